// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormField.h"

#include "nexrad/Simulation/StormDay.h"

#include <algorithm>
#include <cmath>

namespace nexrad
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

StormField::StormField(std::uint32_t seed)
  : storms(MakeStormDay(seed))
{
}

StormSnapshot StormField::At(Time time) const
{
  constexpr std::int64_t dayLength = 86'400'000;
  const std::int64_t sinceMidnight =
    ((time.time_since_epoch().count() % dayLength) + dayLength) % dayLength;
  const double seconds = static_cast<double>(sinceMidnight) / 1000.0;
  constexpr std::size_t usualElements = 256;
  std::vector<StormElement> elements;
  std::vector<StormVortex> vortices;
  elements.reserve(usualElements);
  for (const StormLife& storm : storms)
  {
    AddElements(storm, seconds, elements, vortices);
  }
  return {std::move(elements), std::move(vortices), seconds};
}

double StormField::Reflectivity(double longitude, double latitude, double height, Time time) const
{
  return this->At(time).Reflectivity(StormPlane::FromGeographic(longitude, latitude, height));
}

double StormField::MeanReflectivity(
  const GridSpecification& grid, const std::array<int, 3>& voxel, Time time, double floor) const
{
  const StormSnapshot snapshot = this->At(time);
  const double centre = grid.Coordinate(2, voxel[2]);
  const double half = grid.spacing[2] / 2.0;
  Column column;
  Place(column, grid, snapshot, voxel[0], voxel[1], centre - half, centre + half);
  return MeanOfVoxel(column, grid, snapshot, voxel[2], floor);
}

std::vector<float> StormField::MeanReflectivityRows(
  const GridSpecification& grid, int beginRow, int endRow, Time time, double floor) const
{
  const StormSnapshot snapshot = this->At(time);
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

} // namespace nexrad
