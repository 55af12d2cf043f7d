// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Model/RadarVolume.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// Direction and time of one ray.
struct PolarRay
{
  double azimuth = 0.0;   ///< degrees clockwise from north
  double elevation = 0.0; ///< degrees
  Time time{};
};

/// One moment of one sweep as numbers: rays × gates, gates fastest. All rays share one gate
/// geometry.
struct PolarSweep
{
  int elevationNumber = 0;  ///< number of the cut in the coverage pattern, from 1
  double firstGate = 0.0;   ///< m, slant range of the first gate's centre; may be negative
  double gateSpacing = 0.0; ///< m
  std::size_t gates = 0;
  std::vector<PolarRay> rays;
  std::vector<float> values; ///< unit of the moment; NaN where the state is not Valid
  std::vector<GateState> states;

  std::size_t Index(std::size_t ray, std::size_t gate) const { return ray * gates + gate; }
};

/// What gridding needs of a radar volume: one moment of one site.
struct PolarVolume
{
  Site site;
  MomentName moment = MomentName::REF;
  Time start{};                   ///< first ray, of the whole volume
  Time end{};                     ///< last ray
  bool synthetic = false;         ///< from a simulated file
  std::vector<PolarSweep> sweeps; ///< those that have the moment, in the order scanned
};

/// Converts the words of one moment. A sweep whose rays differ in gate geometry gives one
/// PolarSweep for each geometry; shorter rays are padded with NotSampled, rays without the moment
/// are left out.
PolarVolume MakePolarVolume(const RadarVolume& volume, MomentName moment);

} // namespace nexrad
