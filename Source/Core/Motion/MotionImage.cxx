// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Motion/MotionImage.h"

#include "nexrad/Motion/MotionField.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// Finer pixels show the noise of the radar rather than storms; coarser ones hide the storms.
constexpr double coarsestPixel = 8'000.0; // m
constexpr int fewestPixels = 8;           // along an axis

// A weighted mean over those pixels that lie in the image and were scanned.
class PixelMean
{
public:
  explicit PixelMean(const MotionImage& source)
    : image(source)
  {
  }

  void Add(int column, int row, float weight)
  {
    if (column < 0 || row < 0 || column >= image.columns || row >= image.rows)
    {
      return;
    }
    const std::size_t index = image.Index(column, row);
    if (image.scanned[index] != 0)
    {
      sum += weight * image.values[index];
      weights += weight;
    }
  }

  void Store(MotionImage& target, std::size_t index) const
  {
    target.scanned[index] = weights > 0.0F ? 1 : 0;
    target.values[index] = weights > 0.0F ? sum / weights : 0.0F;
  }

private:
  const MotionImage& image;
  float sum = 0.0F;
  float weights = 0.0F;
};

// True while pixels of twice the size are no larger than the limit, and enough of them remain.
bool CanHalve(const MotionImage& image, const GridSpecification& grid, double limit)
{
  const std::array<double, 2> voxel = VoxelExtent(grid, 0.5 * (grid.dimensions[1] - 1));
  const double pixel = std::min(voxel[0] * image.scale[0], voxel[1] * image.scale[1]);
  return pixel * 2.0 <= limit && std::min(image.columns, image.rows) >= 2 * fewestPixels;
}

} // namespace

MotionImage::MotionImage(int theColumns, int theRows)
  : columns(theColumns)
  , rows(theRows)
  , values(this->Index(0, rows), 0.0F)
  , scanned(this->Index(0, rows), 0)
{
}

MotionImage Smooth(const MotionImage& image)
{
  MotionImage smooth(image.columns, image.rows);
  smooth.first = image.first;
  smooth.scale = image.scale;
  for (int row = 0; row < image.rows; ++row)
  {
    for (int column = 0; column < image.columns; ++column)
    {
      const std::size_t index = image.Index(column, row);
      if (image.scanned[index] == 0)
      {
        continue;
      }
      PixelMean mean(image);
      for (int dy = -1; dy <= 1; ++dy)
      {
        for (int dx = -1; dx <= 1; ++dx)
        {
          mean.Add(column + dx, row + dy, (dx == 0 ? 2.0F : 1.0F) * (dy == 0 ? 2.0F : 1.0F));
        }
      }
      mean.Store(smooth, index);
    }
  }
  return smooth;
}

MotionImage Halve(const MotionImage& image)
{
  MotionImage half((image.columns + 1) / 2, (image.rows + 1) / 2);
  half.first = image.first;
  half.scale = {2.0 * image.scale[0], 2.0 * image.scale[1]};
  for (int row = 0; row < half.rows; ++row)
  {
    for (int column = 0; column < half.columns; ++column)
    {
      PixelMean mean(image);
      for (const int dy : {0, 1})
      {
        for (const int dx : {0, 1})
        {
          mean.Add(2 * column + dx, 2 * row + dy, 1.0F);
        }
      }
      mean.Store(half, half.Index(column, row));
    }
  }
  return half;
}

MotionPyramid MakePyramid(const MotionImage& image, const GridSpecification& grid, double finest)
{
  MotionImage fine = image;
  while (CanHalve(fine, grid, finest))
  {
    fine = Halve(fine);
  }
  MotionPyramid levels = {Smooth(fine)};
  while (CanHalve(levels.back(), grid, coarsestPixel))
  {
    levels.push_back(Halve(levels.back()));
  }
  return levels;
}

std::optional<ImageSample> SampleImage(const MotionImage& image, double column, double row)
{
  // Also refuses NaN.
  if (!(column >= 0.0 && row >= 0.0 && column <= image.columns - 1 && row <= image.rows - 1))
  {
    return std::nullopt;
  }
  const int left = std::min(static_cast<int>(column), std::max(image.columns - 2, 0));
  const int low = std::min(static_cast<int>(row), std::max(image.rows - 2, 0));
  const int right = std::min(left + 1, image.columns - 1);
  const int high = std::min(low + 1, image.rows - 1);
  const std::size_t pixels[] = {image.Index(left, low), image.Index(right, low),
    image.Index(left, high), image.Index(right, high)};
  for (const std::size_t pixel : pixels)
  {
    if (image.scanned[pixel] == 0)
    {
      return std::nullopt;
    }
  }
  const double x = column - left;
  const double y = row - low;
  const auto value = [&](int i) { return static_cast<double>(image.values[pixels[i]]); };
  const double bottom = value(0) + x * (value(1) - value(0));
  const double top = value(2) + x * (value(3) - value(2));
  ImageSample sample;
  sample.value = bottom + y * (top - bottom);
  sample.perColumn = (1.0 - y) * (value(1) - value(0)) + y * (value(3) - value(2));
  sample.perRow = top - bottom;
  return sample;
}

} // namespace nexrad
