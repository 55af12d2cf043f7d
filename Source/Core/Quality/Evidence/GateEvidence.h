// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Quality/Evidence/EchoGrid.h"
#include "nexrad/Quality/Evidence/SplitCuts.h"
#include "nexrad/Quality/Evidence/Textures.h"

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

/// Reads the evidence of a sweep row by row. Rows that follow each other share work.
class EvidenceReader
{
public:
  /// `above`: the next tilt; nullptr where there is none. `gates`: the first ones alone count. All
  /// arguments must outlive the reader.
  EvidenceReader(
    const EchoGrid& grid, const EchoGrid* above, const SweepSources& sources, std::size_t gates);

  /// Reads the evidence of the gates of a row that have a value; that of others stays as it is.
  void Read(std::size_t place, std::vector<GateEvidence>& evidence);

private:
  struct RowTextures
  {
    std::size_t place;
    RayTextures textures;
  };

  const RayTextures& TexturesOf(std::size_t place);
  void ReadAgreement(std::size_t place, std::vector<GateEvidence>& evidence) const;
  void ReadGradient(std::size_t place, std::vector<GateEvidence>& evidence) const;
  void ReadFilterPower(std::size_t place, std::vector<GateEvidence>& evidence);

  const EchoGrid& grid;
  const EchoGrid* above;
  const SweepSources& sources;
  RowGeometry geometry;
  std::array<RowTextures, 3> kept;
  std::size_t next = 0;
  std::vector<GateSums> sums;
  std::vector<std::uint16_t> codes;
  std::vector<float> filterPower;
};

} // namespace nexrad
