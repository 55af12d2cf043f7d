// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/Relief.h"

#include "nexrad/Geometry/Angles.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::scene
{
namespace
{

constexpr double stretch = 15.0; // of heights
constexpr double gain = 3.0;     // of the change in brightness, before it is compressed

// Rise a length towards the east and the north.
struct Slope
{
  double east;
  double north;
};

// Between the neighbours on both sides; at the edge, between the cell and its neighbour.
Slope SlopeAt(const HeightGrid& ground, int column, int row)
{
  const auto at = [&](int i, int j)
  { return ground.heights[static_cast<std::size_t>(j) * ground.columns + i]; };
  const int west = std::max(column - 1, 0);
  const int east = std::min(column + 1, ground.columns - 1);
  const int south = std::max(row - 1, 0);
  const int north = std::min(row + 1, ground.rows - 1);
  const double metres = 1000.0;
  return {(at(east, row) - at(west, row)) / (metres * ground.cellWidth * std::max(east - west, 1)),
    (at(column, north) - at(column, south)) /
      (metres * ground.cellHeight * std::max(north - south, 1))};
}

} // namespace

HeightGrid MakeHeightGrid(
  const SceneFrame& frame, const Elevations& elevations, int columns, int rows)
{
  const auto& box = frame.Bounds();
  HeightGrid ground{columns, rows, (box[1] - box[0]) / columns, (box[3] - box[2]) / rows, {}};
  ground.heights.resize(static_cast<std::size_t>(columns) * rows);
  const auto fillRow = [&](vtkIdType row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const auto [longitude, latitude] =
        frame.Geographic(box[0] + (column + 0.5) * ground.cellWidth,
          box[2] + (static_cast<double>(row) + 0.5) * ground.cellHeight);
      ground.heights[static_cast<std::size_t>(row) * columns + column] =
        elevations.At(longitude, latitude).value_or(0.0);
    }
  };
  vtkSMPTools::For(0, rows,
    [&](vtkIdType first, vtkIdType last)
    {
      for (vtkIdType row = first; row < last; ++row)
      {
        fillRow(row);
      }
    });
  return ground;
}

std::vector<float> ShadeRelief(const HeightGrid& ground, const LightDirection& light)
{
  const double azimuth = light.azimuth * RadiansPerDegree;
  const double elevation = light.elevation * RadiansPerDegree;
  const std::array<double, 3> towards = {std::sin(azimuth) * std::cos(elevation),
    std::cos(azimuth) * std::cos(elevation), std::sin(elevation)};
  std::vector<float> shades;
  shades.reserve(ground.heights.size());
  for (int row = 0; row < ground.rows; ++row)
  {
    for (int column = 0; column < ground.columns; ++column)
    {
      const Slope slope = SlopeAt(ground, column, row);
      const double east = stretch * slope.east;
      const double north = stretch * slope.north;
      const double lit = (towards[2] - east * towards[0] - north * towards[1]) /
                         std::sqrt(1.0 + east * east + north * north);
      shades.push_back(static_cast<float>(std::tanh(gain * (lit - towards[2]))));
    }
  }
  return shades;
}

} // namespace nexrad::scene
