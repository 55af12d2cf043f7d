// SPDX-License-Identifier: BSD-3-Clause
#include "StormMeans.h"

#include <algorithm>
#include <cmath>

namespace nexrad::testing
{

namespace
{

constexpr int horizontalSamples = 4; // along x and along y of a voxel
constexpr int verticalSamples = 2;

// Offset of a sample from a voxel's centre, in voxels.
double SampleOffset(int sample, int samples)
{
  return (sample + 0.5) / samples - 0.5;
}

// The samples of one column of a grid: where they stand in the plane, and what can reach them.
struct Column
{
  std::array<PlanePoint, horizontalSamples * horizontalSamples> places;
  std::vector<int> candidates;
};

void Place(Column& column, const GridSpecification& grid, const StormSnapshot& snapshot, int x,
  int y, double bottom, double top)
{
  std::size_t index = 0;
  Cylinder reach{0.0, 0.0, 0.0, bottom, top};
  for (int row = 0; row < horizontalSamples; ++row)
  {
    const double gridY =
      grid.Coordinate(1, y) + grid.spacing[1] * SampleOffset(row, horizontalSamples);
    for (int place = 0; place < horizontalSamples; ++place)
    {
      const double gridX =
        grid.Coordinate(0, x) + grid.spacing[0] * SampleOffset(place, horizontalSamples);
      const std::array<double, 2> degrees = grid.ToGeographic(gridX, gridY);
      column.places[index] = StormPlane::FromGeographic(degrees[0], degrees[1], 0.0);
      reach.x += column.places[index].x / static_cast<double>(column.places.size());
      reach.y += column.places[index].y / static_cast<double>(column.places.size());
      ++index;
    }
  }
  for (const PlanePoint& place : column.places)
  {
    reach.radius = std::max(reach.radius, std::hypot(place.x - reach.x, place.y - reach.y));
  }
  snapshot.FindElements(reach, column.candidates);
}

double MeanOfVoxel(const Column& column, const GridSpecification& grid,
  const StormSnapshot& snapshot, int z, double floor)
{
  const double centre = grid.Coordinate(2, z);
  const double half = grid.spacing[2] / 2.0;
  if (column.candidates.empty() &&
      (floor >= StormSnapshot::ClearAirMaximum() || centre - half > StormSnapshot::ClearAirTop()))
  {
    return floor;
  }
  double sum = 0.0;
  for (int level = 0; level < verticalSamples; ++level)
  {
    const double height = centre + grid.spacing[2] * SampleOffset(level, verticalSamples);
    for (PlanePoint point : column.places)
    {
      point.z = height;
      sum += std::max(snapshot.Reflectivity(point, column.candidates), floor);
    }
  }
  return sum / static_cast<double>(column.places.size() * verticalSamples);
}

} // namespace

std::vector<float> MeanReflectivityRows(const StormField& field, const GridSpecification& grid,
  int beginRow, int endRow, Time time, double floor)
{
  const StormSnapshot snapshot = field.At(time);
  const auto columns = static_cast<std::size_t>(grid.dimensions[0]);
  const auto rows = static_cast<std::size_t>(std::max(endRow - beginRow, 0));
  std::vector<float> means(columns * rows * static_cast<std::size_t>(grid.dimensions[2]));
  const double half = grid.spacing[2] / 2.0;
  const double bottom = grid.Coordinate(2, 0) - half;
  const double top = grid.Coordinate(2, grid.dimensions[2] - 1) + half;
  Column column;
  for (std::size_t row = 0; row < rows; ++row)
  {
    for (std::size_t x = 0; x < columns; ++x)
    {
      Place(
        column, grid, snapshot, static_cast<int>(x), beginRow + static_cast<int>(row), bottom, top);
      for (int z = 0; z < grid.dimensions[2]; ++z)
      {
        means[(static_cast<std::size_t>(z) * rows + row) * columns + x] =
          static_cast<float>(MeanOfVoxel(column, grid, snapshot, z, floor));
      }
    }
  }
  return means;
}

} // namespace nexrad::testing
