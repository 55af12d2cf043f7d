// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeMotion.h"

#include "VolumePair.h"

#include <algorithm>

namespace nexrad
{

MotionImage ColumnMaximum(const GriddedVolume& volume)
{
  MotionImage image(volume.grid.dimensions[0], volume.grid.dimensions[1]);
  const std::size_t pixels = image.values.size();
  for (std::size_t first = 0; first < volume.values.size(); first += pixels)
  {
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
    {
      const VoxelState state = volume.states[first + pixel];
      if (state == VoxelState::Echo)
      {
        image.values[pixel] = std::max(image.values[pixel], volume.values[first + pixel]);
      }
      image.scanned[pixel] |= state == VoxelState::NotScanned ? 0 : 1;
    }
  }
  return image;
}

MotionField EstimateMotion(
  const GriddedVolume& before, const GriddedVolume& after, const MotionOptions& options)
{
  RequirePair(before, after);
  const MotionPyramid first = MakePyramid(ColumnMaximum(before), before.grid, options.finestPixel);
  const MotionPyramid second = MakePyramid(ColumnMaximum(after), after.grid, options.finestPixel);
  const double seconds = ToSeconds(after.time) - ToSeconds(before.time);
  return EstimateMotion({{&first, &second, seconds}}, before.grid, options);
}

} // namespace nexrad
