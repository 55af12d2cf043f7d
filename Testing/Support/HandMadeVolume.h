// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// The gates of one moment of a hand-made sweep. All words have 8 bits, value = (word − 66) / 2.
struct HandMadeMoment
{
  MomentName name = MomentName::REF;
  int gates = 0;
  int firstGate = 0;   ///< m
  int gateSpacing = 0; ///< m
  std::function<std::uint8_t(int ray, int gate)> word = [](int, int) { return std::uint8_t{0}; };
};

/// One sweep: rays of equal steps from `firstAzimuth` over `turn` degrees.
struct HandMadeSweep
{
  float elevation = 0.5F; ///< degrees
  int rays = 360;
  double firstAzimuth = 0.5; ///< degrees
  double turn = 360.0;       ///< degrees
  float nyquist = 25.0F;     ///< m/s; 0: the file does not tell
  std::vector<HandMadeMoment> moments;
};

/// A volume to be known gate by gate.
struct HandMadeVolume
{
  Site site = {"KEAX", Position{38.81, -94.264, 333.0}};
  Time start{};
  std::vector<HandMadeSweep> sweeps;
  bool complete = true;   ///< ends with an end-of-volume ray
  bool synthetic = false; ///< carries the mark of a simulated file
};

/// The word of a reflectivity in dBZ, to half a dBZ.
std::uint8_t ReflectivityWord(double value);

/// A volume of one sweep of 360 rays and 100 gates of 1 km, with the same reflectivity everywhere.
HandMadeVolume ConstantVolume(const Site& site, Time start, double reflectivity);

/// As a decoder gives it: a ray every 20 ms.
RadarVolume MakeRadarVolume(const HandMadeVolume& volume);

/// Writes the file (message 31, no compression) and returns its path.
std::filesystem::path WriteLevel2(
  const std::filesystem::path& path, const std::vector<HandMadeVolume>& cycles);

/// Puts another time, or no name of a site, into the volume header of such a file.
void SetHeaderTime(const std::filesystem::path& path, Time time);
void BlankHeaderName(const std::filesystem::path& path);

} // namespace nexrad::testing
