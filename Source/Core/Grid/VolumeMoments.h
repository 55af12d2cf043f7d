// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <vector>

namespace nexrad
{

/// What a volume says of itself, without its voxels and its further moments.
GriddedVolume WithoutVoxels(const GriddedVolume& volume);

/// Moments that were merged at one time on one grid, at least one, as one volume: the first, with
/// the others as its further ones. Each names the radars that took part in any of them.
GriddedVolume JoinMoments(std::vector<GriddedVolume> moments);

/// The moments of a volume, each as a volume of its own: the opposite of JoinMoments.
std::vector<GriddedVolume> SplitMoments(GriddedVolume volume);

} // namespace nexrad
