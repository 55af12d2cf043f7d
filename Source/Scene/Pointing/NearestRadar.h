// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// Where a place lies as a radar has it.
struct RadarPlace
{
  std::string site;      ///< name of the radar
  double distance = 0.0; ///< m along the ground
  double azimuth = 0.0;  ///< degrees clockwise from north, from the radar to the place
};

/// The place as the nearest of the radars has it, of those that the site table knows. Nothing when
/// it knows none.
std::optional<RadarPlace> FindNearestRadar(
  const std::vector<std::string>& sites, double latitude, double longitude);

} // namespace nexrad::scene
