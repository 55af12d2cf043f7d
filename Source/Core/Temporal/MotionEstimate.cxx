// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/MotionEstimate.h"

#include "Model/Error.h"
#include "Temporal/MotionImage.h"
#include "Temporal/MotionPair.h"
#include "Temporal/MotionSolver.h"

#include <algorithm>
#include <array>
#include <vector>

namespace nexrad
{

namespace
{

// Finer pixels show the noise of the radar rather than storms; coarser ones hide the storms.
constexpr double finestPixel = 2'000.0;   // m
constexpr double coarsestPixel = 8'000.0; // m
constexpr int fewestPixels = 8;           // along an axis

struct ImagePair
{
  MotionImage before;
  MotionImage after;
};

ImagePair Halve(const ImagePair& pair)
{
  return {Halve(pair.before), Halve(pair.after)};
}

// True while pixels of twice the size are no larger than the limit, and enough of them remain.
bool CanHalve(const MotionImage& image, const GridSpecification& grid, double limit)
{
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  const double pixel = std::min(voxel[0], voxel[1]) * image.scale;
  return pixel * 2.0 <= limit && std::min(image.columns, image.rows) >= 2 * fewestPixels;
}

// The images from fine to coarse.
std::vector<ImagePair> Pyramid(const GriddedVolume& before, const GriddedVolume& after)
{
  ImagePair pair = {ColumnMaximum(before), ColumnMaximum(after)};
  while (CanHalve(pair.before, before.grid, finestPixel))
  {
    pair = Halve(pair);
  }
  std::vector<ImagePair> levels = {{Smooth(pair.before), Smooth(pair.after)}};
  while (CanHalve(levels.back().before, before.grid, coarsestPixel))
  {
    levels.push_back(Halve(levels.back()));
  }
  return levels;
}

} // namespace

MotionField EstimateMotion(
  const GriddedVolume& before, const GriddedVolume& after, const MotionOptions& options)
{
  RequirePair(before, after);
  if (!(options.maximumSpeed > 0.0) || !(options.smoothness > 0.0))
  {
    throw Error("motion: the maximum speed and the smoothness must be above 0");
  }
  const double seconds = ToSeconds(after.time) - ToSeconds(before.time);
  const double farthest = options.maximumSpeed * seconds;
  const std::vector<ImagePair> levels = Pyramid(before, after);
  const ImagePair& coarsest = levels.back();
  MotionSolver solver(before.grid, options,
    SearchDisplacement(coarsest.before, coarsest.after, before.grid, farthest), farthest);
  for (auto level = levels.rbegin(); level != levels.rend(); ++level)
  {
    solver.Refine(level->before, level->after);
  }
  return solver.Motion(seconds);
}

} // namespace nexrad
