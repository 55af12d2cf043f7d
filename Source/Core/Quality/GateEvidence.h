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

/// What is measured about the gates of one row, over windows of three rays. NoNumber where nothing
/// is known.
struct RowEvidence
{
  std::vector<float> agreement;   ///< 0…1: part of the gates about it that are within 3 dB of it
  std::vector<float> squares;     ///< dB², mean squared difference along the ray
  std::vector<float> turns;       ///< 0…1: spin
  std::vector<float> still;       ///< 0…1: part of the velocities that are near 0 and narrow
  std::vector<float> ownStill;    ///< the same of the gate alone
  std::vector<float> speed;       ///< m/s, mean |V|
  std::vector<float> width;       ///< m/s, mean spectrum width
  std::vector<float> correlation; ///< mean ρ_hv
  std::vector<float> ratio;       ///< dB, mean Z_DR
  std::vector<float> ratioSpread; ///< dB, standard deviation of Z_DR, of neighbouring gates
  std::vector<float> phaseSpread; ///< degrees, the same of Φ_DP
  std::vector<float> gradient;    ///< dB a degree, how much weaker the next tilt above is there
};

/// Reads the evidence of a sweep row by row. Rows that follow each other share work.
class EvidenceReader
{
public:
  /// `above`: the next tilt; nullptr where there is none. `gates`: the first ones alone count. All
  /// arguments must outlive the reader.
  EvidenceReader(
    const EchoGrid& grid, const EchoGrid* above, const SweepSources& sources, std::size_t gates);

  void Read(std::size_t place, RowEvidence& evidence);

private:
  struct RaySums
  {
    std::size_t place;
    ReflectivitySums reflectivity;
    VelocitySums velocity;
    PolarimetricSums polarimetric;
  };

  const RaySums& SumsOf(std::size_t place);
  void ReadAgreement(std::size_t place, RowEvidence& evidence) const;
  void ReadGradient(std::size_t place, RowEvidence& evidence) const;

  const EchoGrid& grid;
  const EchoGrid* above;
  const SweepSources& sources;
  RowGeometry geometry;
  std::array<RaySums, 3> kept;
  std::size_t next = 0;
};

} // namespace nexrad
