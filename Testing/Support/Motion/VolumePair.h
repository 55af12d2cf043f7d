// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

namespace nexrad
{

/// Throws Error unless the two volumes can be interpolated between: reflectivity of both, on the
/// same grid, as many values and states as voxels, the second later than the first.
void RequirePair(const GriddedVolume& before, const GriddedVolume& after);

} // namespace nexrad
