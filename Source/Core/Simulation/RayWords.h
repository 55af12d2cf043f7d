// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/DualPolarisation.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nexrad
{

/// What one ray saw, from which its words are made. The vectors are of the gates of `layout`.
struct RayEcho
{
  const SimulatorOptions& options;
  const GateLayout& layout;
  const std::vector<double>& reflectivity; ///< dBZ, without noise; -infinity: nothing
  const std::vector<EchoSpread>& spreads;  ///< of the storms
  const std::vector<EchoKind>& kinds;
  std::uint64_t noiseKey; ///< CounterNoise
};

/// How the simulator's words stand for values: value = (word − offset)/scale, in dBZ, m/s, dB,
/// degrees and without dimension: those of real files. Words of PHI have 16 bits, others 8.
struct WordCode
{
  float scale;
  float offset;
};
constexpr WordCode ReflectivityCode{2.0F, 66.0F};
constexpr WordCode DopplerCode{2.0F, 129.0F};
constexpr WordCode DifferentialCode{16.0F, 128.0F};
constexpr WordCode PhaseCode{2.8361F, 2.0F};
constexpr WordCode CorrelationCode{300.0F, -60.5F};

/// Words of REF for the gates of a layout that begins and steps as the echo's: with noise and the
/// radar's bias, 0 below the sensitivity.
void WriteReflectivityWords(const RayEcho& echo, int gates, std::uint8_t* words);

/// Where the words of VEL and SW go, and what is true of them.
struct DopplerWords
{
  std::uint8_t* velocity;
  std::uint8_t* width;
  RayTruth* truth; ///< nullptr: nobody asks
};

/// Words of VEL and SW: 0 below the sensitivity, 1 where an echo of another pulse overlies.
void WriteDopplerWords(const RayEcho& echo, const GateLayout& doppler, double unambiguousRange,
  VelocitySampler& wind, const DopplerWords& words);

/// Words of ZDR, PHI (two bytes each) and RHO, one after another, for the first gates of the echo:
/// 0 where the word of REF is.
void WritePolarimetricWords(const std::vector<PolarimetricGate>& measured,
  const std::uint8_t* reflectivityWords, int gates, std::uint8_t* words);

/// Where the words of a ray's moments stand, one after another: those of REF, VEL, SW, then ZDR,
/// PHI (two bytes each) and RHO.
struct RayBlocks
{
  /// `words` holds Bytes of the same layout.
  RayBlocks(const CutLayout& layout, int polarimetricGates, std::uint8_t* words);

  static std::size_t Bytes(const CutLayout& layout, int polarimetricGates);

  /// Sets the rows of a ray that have gates: they point to the words.
  void Describe(Ray& ray) const;
  /// Puts one value into all gates of a moment, as a receiver's test pattern does.
  void FillWithPattern() const;

  GateLayout reflectivityGates;
  GateLayout dopplerGates;
  GateLayout polarimetricGates;
  std::uint8_t* reflectivity;
  std::uint8_t* velocity;
  std::uint8_t* width;
  std::uint8_t* polarimetric;
};

} // namespace nexrad
