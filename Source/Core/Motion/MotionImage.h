// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace nexrad
{

/// Column maxima for the motion estimate: the strongest echo of each column, over all of a grid or
/// a part of it.
struct MotionImage
{
  int columns = 0;
  int rows = 0;
  std::array<double, 2> first = {0.0, 0.0}; ///< voxels of the grid before the first pixel
  std::array<double, 2> scale = {1.0, 1.0}; ///< voxels of the grid along each side of a pixel
  std::vector<float> values;                ///< dBZ, at least 0; no echo is 0
  std::vector<std::uint8_t> scanned;        ///< 0 where no voxel of the column was scanned

  MotionImage() = default;
  /// An image of which nothing was scanned.
  MotionImage(int columns, int rows);

  std::size_t Index(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  /// The place of the centre of a pixel (fractions count) in voxels of the grid along an axis (0 x,
  /// 1 y).
  double ToVoxel(std::size_t axis, double pixel) const
  {
    return first[axis] + (pixel + 0.5) * scale[axis] - 0.5;
  }
};

/// Each pixel with its neighbours in the ratio 1 : 2 : 1 along both axes, where they were scanned:
/// takes out what is too small to be followed.
MotionImage Smooth(const MotionImage& image);

/// Half as many pixels along both axes (rounded up), each the mean of those scanned among four.
MotionImage Halve(const MotionImage& image);

/// An image and its halves, from fine to coarse; at least one.
using MotionPyramid = std::vector<MotionImage>;

/// The images of the motion estimate: the image in pixels of at most `finest` m (as near as halving
/// gets, and no finer than it comes), smoothed, and its halves up to 8 km. `grid` is what the image
/// counts its voxels in.
MotionPyramid MakePyramid(const MotionImage& image, const GridSpecification& grid, double finest);

/// Value and slope at a place between pixels.
struct ImageSample
{
  double value = 0.0;     ///< dBZ
  double perColumn = 0.0; ///< dBZ a pixel
  double perRow = 0.0;    ///< dBZ a pixel
};

/// Bilinear; empty outside the image and where one of the four pixels was not scanned.
std::optional<ImageSample> SampleImage(const MotionImage& image, double column, double row);

} // namespace nexrad
