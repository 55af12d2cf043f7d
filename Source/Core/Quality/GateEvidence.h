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

/// What is measured about a gate, over a window of three rays: numbers of one gate, or arrays of
/// those of several gates. NoNumber where nothing is known.
template <class Number>
struct EvidenceOf
{
  Number reflectivity{};   ///< dBZ
  Number range{};          ///< m, slant range
  float elevation = 0.0F;  ///< degrees
  Number agreement{};      ///< 0…1: part of the gates about it that are within 3 dB of it
  Number squares{};        ///< dB², mean squared difference along the ray
  Number turns{};          ///< 0…1: spin
  Number still{};          ///< 0…1: part of the velocities that are near 0 and narrow
  Number ownStill{};       ///< the same of the gate alone
  Number speed{};          ///< m/s, mean |V|
  Number ownSpeed{};       ///< m/s, mean |V| of the gate alone
  Number flow{};           ///< 0…1: |mean V| / mean |V|, 1 where all move one way
  Number width{};          ///< m/s, mean spectrum width
  Number correlation{};    ///< mean ρ_hv
  Number ownCorrelation{}; ///< ρ_hv of the gate alone
  Number ratio{};          ///< dB, mean Z_DR
  Number ratioSpread{};    ///< dB, standard deviation of Z_DR, of neighbouring gates
  Number phaseSpread{};    ///< degrees, the same of Φ_DP
  Number filterPower{};    ///< dB that the clutter filter removed
  Number gradient{};       ///< dB a degree, how much weaker the next tilt above is there
};

/// That of one gate.
using GateEvidence = EvidenceOf<float>;

/// The evidence of those gates of a row that have a value. The arrays let the processor work on
/// several gates at once.
struct EvidenceRow : EvidenceOf<std::vector<float>>
{
  std::vector<std::size_t> gates; ///< which they are

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
  std::vector<float> values;
  std::vector<float> about;
  std::vector<float> like;
  std::vector<std::uint16_t> codes;
  std::vector<float> filterPower;
};

} // namespace nexrad
