// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Motion/AreaMotion.h"

#include "nexrad/Motion/MotionEstimate.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// Each of them is some steps of Gauss and Newton.
constexpr int refinements = 2;

// Pixels of an image along one axis, fractions count.
struct PixelSpan
{
  double begin;
  double end;
};

// The area as it lay `metres` before, in pixels of the image.
PixelSpan PixelsOf(const GridArea& area, const GridSpecification& grid, const MotionImage& image,
  std::size_t axis, double metres)
{
  const double middleRow = (0.5 * (area[2] + area[3]) - grid.origin[1]) / grid.spacing[1];
  const double back = metres / VoxelExtent(grid, middleRow)[axis]; // voxels
  const auto pixelOf = [&](double place)
  {
    const double voxel = (place - grid.origin[axis]) / grid.spacing[axis] - back;
    return (voxel + 0.5 - image.first[axis]) / image.scale[axis] - 0.5;
  };
  return {pixelOf(area[2 * axis]), pixelOf(area[2 * axis + 1])};
}

// The pixels from `begin` up to `end` along both axes, as far as there are.
MotionImage CutOut(
  const MotionImage& image, const std::array<int, 2>& begin, const std::array<int, 2>& end)
{
  MotionImage part;
  part.columns = end[0] - begin[0];
  part.rows = end[1] - begin[1];
  part.scale = image.scale;
  part.first = {
    image.first[0] + begin[0] * image.scale[0], image.first[1] + begin[1] * image.scale[1]};
  for (int row = begin[1]; row < end[1]; ++row)
  {
    const auto from = static_cast<std::ptrdiff_t>(image.Index(begin[0], row));
    const auto to = from + part.columns;
    part.values.insert(part.values.end(), image.values.begin() + from, image.values.begin() + to);
    part.scanned.insert(
      part.scanned.end(), image.scanned.begin() + from, image.scanned.begin() + to);
  }
  return part;
}

// The two images about the area, of which the first knows the area alone.
struct AreaImages
{
  MotionImage before;
  MotionImage after;
};

AreaImages ImagesAbout(const GridArea& area, const AreaPair& pair, const GridSpecification& grid,
  const Velocity& first, double farthest)
{
  const MotionImage& before = pair.images.before->front();
  const MotionImage& after = pair.images.after->front();
  const std::array<int, 2> size = {
    std::min(before.columns, after.columns), std::min(before.rows, after.rows)};
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  const std::array<double, 2> back = {first.east * pair.early, first.north * pair.early};
  std::array<PixelSpan, 2> inside{};
  std::array<int, 2> begin{};
  std::array<int, 2> end{};
  for (const std::size_t axis : {0U, 1U})
  {
    inside[axis] = PixelsOf(area, grid, before, axis, back[axis]);
    const double margin = farthest / (voxel[axis] * before.scale[axis]) + 2.0;
    const auto limit = [&](double pixel)
    { return static_cast<int>(std::clamp(pixel, 0.0, static_cast<double>(size[axis]))); };
    begin[axis] = limit(std::floor(inside[axis].begin - margin));
    end[axis] = limit(std::ceil(inside[axis].end + margin) + 1.0);
  }
  AreaImages images = {CutOut(before, begin, end), CutOut(after, begin, end)};
  const auto isIn = [&](std::size_t axis, int pixel)
  {
    // A pixel more: what lies between the last one and the face is found from both.
    const double place = begin[axis] + pixel;
    return place > inside[axis].begin - 1.0 && place < inside[axis].end + 1.0;
  };
  for (int row = 0; row < images.before.rows; ++row)
  {
    for (int column = 0; column < images.before.columns; ++column)
    {
      if (!isIn(0, column) || !isIn(1, row))
      {
        images.before.scanned[images.before.Index(column, row)] = 0;
      }
    }
  }
  return images;
}

} // namespace

Velocity EstimateMotionWithin(const GridArea& area, const std::vector<AreaPair>& pairs,
  const GridSpecification& grid, const Velocity& first, const MotionOptions& options)
{
  if (pairs.empty())
  {
    return first;
  }
  double mean = 0.0; // s
  for (const AreaPair& pair : pairs)
  {
    mean += pair.images.seconds / static_cast<double>(pairs.size());
  }
  const double farthest = options.maximumSpeed * mean;
  std::vector<AreaImages> images;
  for (const AreaPair& pair : pairs)
  {
    images.push_back(ImagesAbout(area, pair, grid, first, farthest));
  }
  std::vector<ImagePair> compared;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    compared.push_back({&images[i].before, &images[i].after, pairs[i].images.seconds / mean});
  }
  GridSpecification oneNode = grid; // whose one displacement is that of all pixels
  oneNode.dimensions = {1, 1, 1};
  MotionSolver solver(oneNode, options, {first.east * mean, first.north * mean}, farthest);
  for (int i = 0; i < refinements; ++i)
  {
    solver.Refine(compared);
  }
  return solver.Motion(mean).velocities.front();
}

} // namespace nexrad
