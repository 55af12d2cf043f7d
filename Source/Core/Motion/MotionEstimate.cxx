// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Motion/MotionEstimate.h"

#include "nexrad/Motion/MotionSolver.h"
#include "nexrad/System/Error.h"

#include <algorithm>

namespace nexrad
{

namespace
{

void CheckOptions(const MotionOptions& options)
{
  if (!(options.spacing > 0.0) || !(options.finestPixel > 0.0) || !(options.maximumSpeed > 0.0) ||
      !(options.smoothness > 0.0))
  {
    throw Error("motion: the spacing, the finest pixel, the maximum speed and the smoothness must "
                "be above 0");
  }
}

// The images of a level, counted from the finest. What has fewer levels takes part in the coarser
// ones with its coarsest.
std::vector<ImagePair> ImagesOf(
  const std::vector<MotionPair>& pairs, std::size_t level, double mean)
{
  std::vector<ImagePair> images;
  for (const MotionPair& pair : pairs)
  {
    const std::size_t own = std::min(level, pair.before->size() - 1);
    images.push_back({&pair.before->at(own), &pair.after->at(own), pair.seconds / mean});
  }
  return images;
}

} // namespace

MotionField EstimateMotion(
  const std::vector<MotionPair>& pairs, const GridSpecification& grid, const MotionOptions& options)
{
  CheckOptions(options);
  if (pairs.empty())
  {
    return MotionField{};
  }
  double mean = 0.0; // s
  std::size_t levels = 0;
  for (const MotionPair& pair : pairs)
  {
    mean += pair.seconds / static_cast<double>(pairs.size());
    levels = std::max(levels, pair.before->size());
  }
  const double farthest = options.maximumSpeed * mean;
  MotionSolver solver(
    grid, options, SearchDisplacement(ImagesOf(pairs, levels - 1, mean), grid, farthest), farthest);
  for (std::size_t level = levels; level-- > 0;)
  {
    solver.Refine(ImagesOf(pairs, level, mean));
  }
  return solver.Motion(mean);
}

} // namespace nexrad
