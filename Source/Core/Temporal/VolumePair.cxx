// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/VolumePair.h"

#include "Model/Error.h"

namespace nexrad
{

namespace
{

bool SameGrid(const GridSpecification& first, const GridSpecification& second)
{
  return first.dimensions == second.dimensions && first.origin == second.origin &&
         first.spacing == second.spacing && first.axes == second.axes &&
         first.centreLatitude == second.centreLatitude &&
         first.centreLongitude == second.centreLongitude;
}

} // namespace

void RequirePair(const GriddedVolume& before, const GriddedVolume& after)
{
  if (!SameGrid(before.grid, after.grid))
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
