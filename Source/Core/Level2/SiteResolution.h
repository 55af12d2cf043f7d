// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/RadarVote.h"
#include "nexrad/Level2/Level2Options.h"
#include "nexrad/Model/RadarVolume.h"

#include <string>

namespace nexrad
{

/// Sets `volume.site` and writes into its notes where name and position are from, when that is not
/// the file itself. Name: the option, the header (but the rays, where they also state the place of
/// the radar that they name, and the header's radar is elsewhere), the rays, a known site in the
/// file's name.
/// Position: the option, message 31, the site table by the name.
/// `headerName` is the name in the volume header, "" when blank.
void ResolveSite(const std::string& headerName, const RadarOfRays& ofRays,
  const Level2Options& options, RadarVolume& volume);

} // namespace nexrad
