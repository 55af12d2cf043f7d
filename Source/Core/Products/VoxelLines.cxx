// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Products/VoxelLines.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/SiteTable.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace nexrad
{

GroundHeight::GroundHeight(const GridSpecification& grid, const std::vector<std::string>& sites,
  const std::vector<Position>& positions)
{
  const bool placed = positions.size() == sites.size();
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const KnownSite* known = FindSite(sites[i]);
    if (known == nullptr && !placed)
    {
      continue;
    }
    const Position& position = placed ? positions[i] : known->position;
    const auto [x, y] = grid.FromGeographic(position.longitude, position.latitude);
    places.push_back({x, y, known != nullptr ? known->ground : position.altitude});
  }
}

double GroundHeight::Below(const GridSpecification& grid, std::size_t column) const
{
  const auto width = static_cast<std::size_t>(grid.dimensions[0]);
  const double x = grid.Coordinate(0, static_cast<int>(column % width));
  const double y = grid.Coordinate(1, static_cast<int>(column / width));
  // A degree of longitude is shorter than one of latitude.
  const double stretch = grid.axes == GridAxes::Geographic ? std::cos(y * RadiansPerDegree) : 1.0;
  const auto distance = [&](const Place& place)
  { return std::hypot(stretch * (place.x - x), place.y - y); };
  const auto nearest = std::min_element(places.begin(), places.end(),
    [&distance](const Place& a, const Place& b) { return distance(a) < distance(b); });
  return nearest == places.end() ? 0.0 : nearest->height;
}

VoxelLines LinesOf(const GriddedVolume& volume)
{
  const auto read = [&volume](
                      std::size_t first, std::size_t count, float* values, VoxelState* states)
  {
    std::copy_n(volume.values.data() + first, count, values);
    std::copy_n(volume.states.data() + first, count, states);
  };
  return {volume.grid, volume.moment, read,
    GroundHeight(volume.grid, volume.sites, volume.sitePositions)};
}

void WalkColumns(const VoxelLines& voxels, int first, int last, const RangeLoop& loop,
  const std::function<void(const ColumnStretch& stretch)>& visit)
{
  // Columns that are visited together: what is kept of them stays in the processor's cache from one
  // level to the next, and a stretch is long enough to be read in one go.
  constexpr std::size_t together = 4096;
  const std::size_t columns = static_cast<std::size_t>(voxels.grid.dimensions[0]) *
                              static_cast<std::size_t>(voxels.grid.dimensions[1]);
  const std::size_t stretches = (columns + together - 1) / together;
  const auto walk = [&](int begin, int end)
  {
    std::vector<float> values(together);
    std::vector<VoxelState> states(together);
    for (int stretch = begin; stretch < end; ++stretch)
    {
      const std::size_t column = together * static_cast<std::size_t>(stretch);
      const std::size_t count = std::min(together, columns - column);
      for (int level = first; level < last; ++level)
      {
        voxels.read(
          column + columns * static_cast<std::size_t>(level), count, values.data(), states.data());
        visit({column, count, level, values.data(), states.data()});
      }
    }
  };
  RunLoop(loop, static_cast<int>(stretches), walk);
}

} // namespace nexrad
