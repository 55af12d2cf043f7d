// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Model/RadarVolume.h"
#include "Simulation/StormField.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// The coverage patterns that the simulator can scan (11, 12, 21, 31, 32, 121, 212, 215, …);
/// nullptr for others.
const CoveragePattern* FindCoveragePattern(int number);
std::vector<int> KnownCoveragePatterns();

struct SimulatorOptions
{
  bool superResolution = false; ///< 250 m × 0.5° (message 31) in place of 1 km × 1° (message 1)
  double effectiveRadiusFactor =
    4.0 / 3.0;             ///< refraction of the simulated atmosphere (Formulas B1)
  double beamWidth = 0.95; ///< degrees, between half-power points
  double noise = 1.0;      ///< dB, standard deviation of a gate
  double sensitivity =
    -7.5;                 ///< dBZ, weakest echo seen at 50 km; it rises with 20·log10 of the range
  std::uint32_t seed = 1; ///< of the noise
};

/// Scans the field with one radar, one coverage pattern, from `start` on: each gate is the mean of
/// the field over the beam and the gate's length at the ray's own time. Deterministic. Throws Error
/// for an unknown pattern or a site without a position.
RadarVolume ScanVolume(const StormField& field, const Site& site, int coveragePattern, Time start,
  const SimulatorOptions& options = {});

/// Time from the start of one volume to the start of the next with that pattern.
Duration VolumePeriod(int coveragePattern);

} // namespace nexrad
