// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Level2Options.h"
#include "nexrad/Level2/Messages/DecodedRay.h"
#include "nexrad/Model/RadarVolume.h"

#include <optional>
#include <string>

namespace nexrad
{

/// What a file says about its radar.
struct SiteEvidence
{
  std::string headerName;                 ///< in the volume header; "" when blank
  std::string rayName;                    ///< in message 31; "" in message 1
  std::string path;                       ///< the file's name may hold the site's
  std::optional<StoredPosition> position; ///< message 31
};

/// Sets `volume.site` and writes into its notes where name and position are from, when that is not
/// the file itself. Name: the option, the header (but the rays, where they also state the place of
/// the radar that they name, and the header's radar is elsewhere), the rays, a known site in the
/// file's name.
/// Position: the option, message 31, the site table by the name.
void ResolveSite(const SiteEvidence& evidence, const Level2Options& options, RadarVolume& volume);

} // namespace nexrad
