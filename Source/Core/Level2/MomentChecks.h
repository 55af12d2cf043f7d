// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <functional>
#include <string>

namespace nexrad
{

/// Takes what is wrong with a ray of a volume: the sweep, the ray's place in it, and one line.
using RayDamageReceiver =
  std::function<void(std::size_t sweep, std::size_t ray, const std::string& what)>;

/// Takes out what cannot be believed of the moments of rays, and reports it, in this order:
///
/// - Moments whose coding (scale, offset, bits of a word) differs from that of more than half of
///   the sweep's rays. No radar changes it within a cut, so a bit of the message is wrong. Where no
///   coding is that common, the four that most rays have are kept.
/// - Moments whose words stand for values that do not lie where the moment's do, as with a negative
///   scale or one of 10^38. The codings of 1991 to 2026 lie far within what is let through.
/// - Moments whose gates lie at other ranges than those of nearly all rays of their sweep. Who
///   makes a table of a sweep makes one for each such geometry, so each moment of a sweep keeps the
///   four that most rays have. Sweeps of radars have one.
/// - The ends of rows that are many times as long as the others of their sweep. Who makes a table
///   of a sweep needs a place for each ray at each gate of the widest ray, so a few wide rays among
///   many narrow ones would take memory that has nothing to do with the file's size. Nothing is cut
///   while the tables of the volume hold no more than twice the gates of its rays and 2^22 more;
///   real sweeps hold exactly as many.
void CheckMoments(RadarVolume& volume, const RayDamageReceiver& report);

} // namespace nexrad
