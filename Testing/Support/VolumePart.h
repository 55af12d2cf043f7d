// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

namespace nexrad::testing
{

/// The part of a volume that stands in a block of its grid. Throws Error as PartOf does.
GriddedVolume TakePart(GriddedVolume volume, const VoxelBlock& block);

} // namespace nexrad::testing
