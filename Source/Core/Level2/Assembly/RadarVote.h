// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/ArrivedRay.h"

#include <optional>
#include <string>

namespace nexrad
{

/// The radar that the rays of a file are of, as they themselves say.
struct RadarOfRays
{
  std::string name;                       ///< "" when its rays have none, as in message 1
  std::optional<StoredPosition> position; ///< message 31
};

/// Finds the radar that a file is of, takes the rays of other radars out of `rays`, and reports
/// them in one line. The sender of a ray is the type of its message and the name and the position
/// in it.
///
/// The file is of the sender of most rays; a sender with the header's name goes before it when it
/// has a tenth of the rays. A ray of another sender stays in two cases, because a bit of its
/// message is wrong: when it states the radar's position and another name; and when it states the
/// radar's name and another position, and its time, cut and number are those of a ray between the
/// rays beside it in the file. These are reported too.
RadarOfRays KeepOneRadar(RayList& rays, const std::string& headerName, const ArrivedDamage& report);

} // namespace nexrad
