// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/EchoGrid.h"
#include "nexrad/Quality/SplitCuts.h"
#include "nexrad/Quality/Textures.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nexrad
{

/// What is measured about one gate, over a window of three rays. NoNumber where nothing is known.
struct GateEvidence
{
  float reflectivity = NoNumber;   ///< dBZ
  float range = 0.0F;              ///< m, slant range
  float elevation = 0.0F;          ///< degrees
  float agreement = NoNumber;      ///< 0…1: part of the gates about it that are within 3 dB of it
  float squares = NoNumber;        ///< dB², mean squared difference along the ray
  float turns = NoNumber;          ///< 0…1: spin
  float still = NoNumber;          ///< 0…1: part of the velocities that are near 0 and narrow
  float ownStill = NoNumber;       ///< the same of the gate alone
  float speed = NoNumber;          ///< m/s, mean |V|
  float ownSpeed = NoNumber;       ///< m/s, mean |V| of the gate alone
  float flow = NoNumber;           ///< 0…1: |mean V| / mean |V|, 1 where all move one way
  float width = NoNumber;          ///< m/s, mean spectrum width
  float correlation = NoNumber;    ///< mean ρ_hv
  float ownCorrelation = NoNumber; ///< ρ_hv of the gate alone
  float ratio = NoNumber;          ///< dB, mean Z_DR
  float ratioSpread = NoNumber;    ///< dB, standard deviation of Z_DR, of neighbouring gates
  float phaseSpread = NoNumber;    ///< degrees, the same of Φ_DP
  float filterPower = NoNumber;    ///< dB that the clutter filter removed
  float gradient = NoNumber;       ///< dB a degree, how much weaker the next tilt above is there
};

/// The evidence of those gates of a row that have a value: an array for each member of
/// GateEvidence, so that the processor works on several gates at once.
struct EvidenceRow
{
  std::vector<std::size_t> gates; ///< which they are
  float elevation = 0.0F;
  std::vector<float> reflectivity;
  std::vector<float> range;
  std::vector<float> agreement;
  std::vector<float> squares;
  std::vector<float> turns;
  std::vector<float> still;
  std::vector<float> ownStill;
  std::vector<float> speed;
  std::vector<float> ownSpeed;
  std::vector<float> flow;
  std::vector<float> width;
  std::vector<float> correlation;
  std::vector<float> ownCorrelation;
  std::vector<float> ratio;
  std::vector<float> ratioSpread;
  std::vector<float> phaseSpread;
  std::vector<float> filterPower;
  std::vector<float> gradient;

  /// Makes the arrays as long as `gates`, with NoNumber where not every gate has evidence.
  void Clear();

  GateEvidence At(std::size_t i) const
  {
    return {reflectivity[i], range[i], elevation, agreement[i], squares[i], turns[i], still[i],
      ownStill[i], speed[i], ownSpeed[i], flow[i], width[i], correlation[i], ownCorrelation[i],
      ratio[i], ratioSpread[i], phaseSpread[i], filterPower[i], gradient[i]};
  }
};

/// Reads the evidence of a sweep row by row. Rows that follow each other share work.
class EvidenceReader
{
public:
  /// `above`: the next tilt; nullptr where there is none. `gates`: the first ones alone count.
  /// `wanted`: of each row the gates whose evidence is read. All arguments must outlive the reader.
  EvidenceReader(const EchoGrid& grid, const EchoGrid* above, const SweepSources& sources,
    std::size_t gates, const std::vector<GateRange>& wanted);

  void Read(std::size_t place, EvidenceRow& evidence);

private:
  // Sums of a row; the first gate of them is `begin`.
  struct RowTextures
  {
    std::size_t place;
    std::size_t begin = 0;
    RayTextures textures;
  };

  std::size_t Counted(std::size_t place) const;
  GateRange SummedGates(std::size_t place) const;
  const RowTextures& TexturesOf(std::size_t place);
  void ReadTextures(std::size_t place, const GateRange& range, EvidenceRow& evidence);
  void ReadAgreement(std::size_t place, const GateRange& range, EvidenceRow& evidence);
  void ReadGradient(std::size_t place, EvidenceRow& evidence) const;
  void ReadFilterPower(std::size_t place, EvidenceRow& evidence);

  const EchoGrid& grid;
  const EchoGrid* above;
  const SweepSources& sources;
  RowGeometry geometry;
  const std::vector<GateRange>& wanted;
  std::array<RowTextures, 3> kept;
  std::size_t next = 0;
  std::vector<GateSums> sums;
  std::vector<GateSums> polarimetricSums;
  std::vector<float> about;
  std::vector<float> like;
  std::vector<std::uint16_t> codes;
  std::vector<float> filterPower;
};

} // namespace nexrad
