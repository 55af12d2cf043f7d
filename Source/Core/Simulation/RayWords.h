// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// What one ray saw, from which its words are made.
struct RayEcho
{
  const SimulatorOptions& options;
  const GateLayout& layout;                ///< of `reflectivity`
  const std::vector<double>& reflectivity; ///< dBZ, without noise; -infinity: nothing
  std::uint64_t noiseKey;                  ///< CounterNoise
};

/// How the simulator's words stand for values: value = (word − offset)/scale, in dBZ and m/s.
constexpr float ReflectivityScale = 2.0F;
constexpr float ReflectivityOffset = 66.0F;
constexpr float DopplerScale = 2.0F;
constexpr float DopplerOffset = 129.0F;

/// Words of REF for the gates of a layout that begins and steps as the echo's: with noise, 0 below
/// the sensitivity.
void WriteReflectivityWords(const RayEcho& echo, int gates, std::uint8_t* words);

/// Direction of a ray, for its radial velocities.
struct RayDirection
{
  double azimuth = 0.0;   ///< degrees
  double elevation = 0.0; ///< degrees
};

/// Words of VEL and SW: 0 below the sensitivity, 1 where an echo of another pulse overlies.
void WriteDopplerWords(const RayEcho& echo, const GateLayout& doppler, double unambiguousRange,
  const RayDirection& direction, const BeamSampler& beam, const StormSnapshot& snapshot,
  std::uint8_t* velocityWords, std::uint8_t* widthWords);

} // namespace nexrad
