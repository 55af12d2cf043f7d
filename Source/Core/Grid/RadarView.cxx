// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/RadarView.h"

#include "nexrad/Geometry/Beam.h"
#include "nexrad/Geometry/SiteGeoreference.h"

#include <cstddef>

namespace nexrad
{

RadarView MakeRadarView(const GridSpecification& grid, const Position& radar, const RangeLoop& loop)
{
  RadarView view;
  ForEachArray(
    view, [&grid](const char*, std::vector<float>& values) { values.resize(grid.VoxelCount()); });
  const SiteGeoreference site(radar);
  const BeamModel beam;
  const int width = grid.dimensions[0];
  const int height = grid.dimensions[1];
  const int levels = grid.dimensions[2];
  const std::size_t layer = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  const auto lookAt = [&](int x, int y)
  {
    const auto place = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
    const GroundDirection direction = site.Look(place[0], place[1]);
    std::size_t voxel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    for (int z = 0; z < levels; ++z, voxel += layer)
    {
      const BeamDirection seen =
        beam.Look({grid.Coordinate(2, z) - radar.altitude, direction.groundDistance});
      const auto azimuth = static_cast<float>(direction.azimuth);
      view.azimuth[voxel] = azimuth < 360.0F ? azimuth : 0.0F; // what a float rounds up
      view.elevation[voxel] = static_cast<float>(seen.elevation);
      view.slantRange[voxel] = static_cast<float>(seen.slantRange);
    }
  };
  RunLoop(loop, height,
    [&](int begin, int end)
    {
      for (int y = begin; y < end; ++y)
      {
        for (int x = 0; x < width; ++x)
        {
          lookAt(x, y);
        }
      }
    });
  return view;
}

} // namespace nexrad
