// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Polar/PolarVolume.h"

#include <cstddef>
#include <vector>

namespace nexrad
{

/// The rays of a sweep that are rays of its cut, by their indices, ascending: those that do not
/// stray from it (Formulas Q7). None where most rays stray (HasElevation): a scan in elevation has
/// no tilt. `beamWidth` in degrees.
std::vector<std::size_t> FindRaysOfCut(const PolarSweep& sweep, double beamWidth);

/// Of REF, leaves out of `rays`, indices in a sweep of a volume, those of the Doppler half of a
/// split cut in whose directions its surveillance half has rays of its cut. The Doppler half is a
/// contiguous Doppler cut after a surveillance or batch cut at the same tilt, with nothing but
/// other cuts at that tilt between them. A terminal radar's cuts without ambiguity resolution are
/// none: it repeats the lowest one each minute for its reflectivity. `beamWidth` in degrees.
void LeaveOutSeenTwice(
  const PolarVolume& volume, std::size_t sweep, double beamWidth, std::vector<std::size_t>& rays);

} // namespace nexrad
