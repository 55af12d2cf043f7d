// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Encoding/Level2Encoder.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace nexrad
{

/// A radar of the simulated day and the pattern that it scans all day.
struct SimulatedSite
{
  std::string name; ///< in the site table
  int coveragePattern = 21;
  double bias = 0.0; ///< dB that its reflectivities are too high
};

struct SimulatedDayOptions
{
  Time begin{};                                          ///< of the period simulated
  Duration length = std::chrono::hours(24);              ///< above 0
  std::vector<SimulatedSite> sites = DefaultSites();     ///< KEAX, KILX and KLSX
  int messageType = 1;                                   ///< 1, or 31 for super-resolution
  Level2Container container = Level2Container::LdmBzip2; ///< of every file
  std::uint32_t seed = 1;                                ///< of the storms and the noise
  double effectiveRadiusFactor = 4.0 / 3.0;              ///< see SimulatorOptions
  std::set<EchoKind> notWeather;                         ///< see SimulatorOptions
  bool dualPolarisation = false;                         ///< see SimulatorOptions

  /// KEAX with pattern 21, KILX with 12, KLSX with 11.
  static std::vector<SimulatedSite> DefaultSites();
};

/// One volume of the day, and the name of its file.
struct SimulatedVolume
{
  Site site;
  int coveragePattern = 21;
  Time start{};
  int volumeNumber = 1;
  std::string fileName; ///< as the archive names it: KLSX20060312_180107, with _V06 for message 31
                        ///< and .gz for gzip
  double bias = 0.0;    ///< of the site, dB
};

/// The volumes that begin in [begin, begin + length), in the order of their starts. Each site keeps
/// its own pace and phase, which do not depend on `begin`. Throws Error for an unknown site or
/// pattern, no sites, a site named twice, or a length that is not above 0.
std::vector<SimulatedVolume> PlanSimulatedDay(const SimulatedDayOptions& options);

/// The bytes of one file of the day. The field must be of the options' seed. Threads may work on
/// several volumes at a time. Throws Error for dual polarisation in message 1.
std::vector<std::uint8_t> SimulateFile(
  const StormField& field, const SimulatedVolume& volume, const SimulatedDayOptions& options);

} // namespace nexrad
