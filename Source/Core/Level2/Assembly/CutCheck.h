// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Assembly/SweepBuilder.h"
#include "nexrad/Model/RadarVolume.h"
#include "nexrad/Model/VolumeCuts.h"

#include <cstddef>
#include <string>
#include <vector>

namespace nexrad
{

/// What is known of the coverage pattern of the sweeps from `begin` to before `end`: its number,
/// that of most of their rays; its message 5; and how many cuts it has. Of several messages 5 of
/// that number, that whose elevations are those of most sweeps counts, and of two alike the first.
/// Message 5 of another number does not count.
VolumeCuts ChoosePattern(const std::vector<ArrivedSweep>& sweeps, std::size_t begin,
  std::size_t end, const std::vector<CoveragePattern>& patterns);

/// The numbers of the cuts, from 1, at an elevation that the pattern had before a higher cut.
std::vector<int> RepeatedCuts(const CoveragePattern& pattern);

/// Finds which cuts of their coverage patterns the volumes of a file have, and what ended them:
/// fills `volume.cuts` and `volume.complete`. `sweeps` are those of `volume`, and `patterns` are
/// the messages 5 of the file (PatternChoice.h says which counts). Where message 5 is absent, the
/// number of cuts of the published pattern counts for rays of message 1.
///
/// Lost cuts, and rays lost at the end of a sweep, are reported; the end of the last volume is not.
/// A new volume is begun by the radar when its first ray comes sooner than half of the rest of the
/// former one could have been scanned; later, the rest is lost.
void CheckCuts(const std::vector<ArrivedSweep>& sweeps,
  const std::vector<CoveragePattern>& patterns, RadarVolume& volume, const ArrivedDamage& report);

} // namespace nexrad
