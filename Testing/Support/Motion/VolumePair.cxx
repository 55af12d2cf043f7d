// SPDX-License-Identifier: BSD-3-Clause
#include "VolumePair.h"

#include "nexrad/System/Error.h"

namespace nexrad
{

void RequirePair(const GriddedVolume& before, const GriddedVolume& after)
{
  if (before.grid != after.grid)
  {
    throw Error("interpolation in time: the two volumes must lie on the same grid");
  }
  for (const GriddedVolume* volume : {&before, &after})
  {
    if (volume->moment != MomentName::REF)
    {
      throw Error("interpolation in time: the moment must be REF, the motion is that of "
                  "reflectivity");
    }
    const std::size_t voxels = volume->grid.VoxelCount();
    if (volume->values.size() != voxels || volume->states.size() != voxels)
    {
      throw Error("interpolation in time: the volume at " + FormatIso8601(volume->time) +
                  " must have a value and a state for each voxel");
    }
  }
  if (after.time <= before.time)
  {
    throw Error("interpolation in time: the second volume (" + FormatIso8601(after.time) +
                ") must be later than the first (" + FormatIso8601(before.time) + ")");
  }
}

} // namespace nexrad
