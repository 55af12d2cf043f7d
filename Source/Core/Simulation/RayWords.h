// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/VelocitySampler.h"

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

/// Words of VEL and SW: 0 below the sensitivity, 1 where an echo of another pulse overlies.
/// `spreads` are those of the echo's gates. Where `truth` is given, it takes the radial velocities
/// without noise and folding (RayTruth::velocity).
void WriteDopplerWords(const RayEcho& echo, const GateLayout& doppler, double unambiguousRange,
  const std::vector<EchoSpread>& spreads, VelocitySampler& wind, std::uint8_t* velocityWords,
  std::uint8_t* widthWords, std::vector<float>* truth);

} // namespace nexrad
