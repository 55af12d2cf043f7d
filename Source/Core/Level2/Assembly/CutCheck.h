// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/SweepBuilder.h"
#include "nexrad/Model/RadarVolume.h"

#include <vector>

namespace nexrad
{

/// Finds which cuts of their coverage patterns the volumes of a file have, and what ended them:
/// fills `volume.cuts` and `volume.complete`. `sweeps` are those of `volume`, and `patterns` are
/// the messages 5 of the file. Of each volume that of its pattern's number counts, which is that of
/// most of its rays; of several that whose elevations are those of most sweeps, and of two alike
/// the first. Where there is none, the number of cuts of the published pattern counts for rays of
/// message 1.
///
/// Lost cuts, and rays lost at the end of a sweep, are reported; the end of the last volume is not.
/// A new volume is begun by the radar when its first ray comes sooner than half of the rest of the
/// former one could have been scanned; later, the rest is lost.
void CheckCuts(const std::vector<ArrivedSweep>& sweeps,
  const std::vector<CoveragePattern>& patterns, RadarVolume& volume, const ArrivedDamage& report);

} // namespace nexrad
