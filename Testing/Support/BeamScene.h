// SPDX-License-Identifier: BSD-3-Clause
// Hand-made volumes and a small grid about one radar, for tests of the merge by beams.
#pragma once

#include "PolarMerge.h"
#include "SweepMaker.h"
#include "nexrad/Geometry/SiteGeoreference.h"

#include <cmath>
#include <functional>

namespace nexrad::testing
{

inline const Position centralSite = {38.7, -92.0, 200.0};
inline const Time sceneTime = *ParseIso8601("2006-03-12T18:00Z");

/// A grid of 61 × 61 columns, 5 km apart, about the site; levels each 250 m from 250 m on.
inline GridSpecification SceneGrid()
{
  GridSpecification grid;
  grid.dimensions = {61, 61, 72};
  grid.spacing = {5'000.0, 5'000.0, 250.0};
  grid.origin = {-150'000.0, -150'000.0, 250.0};
  grid.centreLatitude = centralSite.latitude;
  grid.centreLongitude = centralSite.longitude;
  return grid;
}

/// A full sweep of 360 rays and 230 gates of 1 km with one value, scanned `seconds` after 18:00 in
/// an instant.
inline NumberSweep UniformSweep(int number, double elevation, float value, double seconds = 0.0)
{
  NumberSweep sweep = MakeSweep(number, elevation, 360, 230);
  SetAll(sweep, value);
  for (PolarRay& ray : sweep.rays)
  {
    ray.time = sceneTime + Duration(std::llround(seconds * 1000.0));
  }
  return sweep;
}

/// A volume of the central site: its times are those of its rays.
inline PolarVolume VolumeOf(
  const std::vector<NumberSweep>& sweeps, const Position& site = centralSite)
{
  PolarVolume volume = MakeVolume(site, 0.0, sweeps);
  volume.start = volume.end = volume.sweeps.front().rays.front().time;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    for (const PolarRay& ray : sweep.rays)
    {
      volume.start = std::min(volume.start, ray.time);
      volume.end = std::max(volume.end, ray.time);
    }
  }
  return volume;
}

inline GriddedVolume MergeAt(const std::vector<PolarVolume>& volumes, double seconds,
  const BeamMergeOptions& options = {}, const GridSpecification& grid = SceneGrid())
{
  std::vector<const PolarVolume*> pointers;
  for (const PolarVolume& volume : volumes)
  {
    pointers.push_back(&volume);
  }
  BeamMerger merger(grid, options);
  return *MergePolar(merger, pointers, sceneTime + Duration(std::llround(seconds * 1000.0)));
}

/// The gates' own values at the tilts (no Formulas G9) and straight lines between them (no G11 and
/// G12).
inline BeamMergeOptions AsMeasured()
{
  BeamMergeOptions options;
  options.sharpen = false;
  options.trend = false;
  return options;
}

/// A voxel as a radar sees it, by exact geometry.
struct SeenVoxel
{
  std::size_t index = 0;
  double azimuth = 0.0;        ///< degrees
  double groundDistance = 0.0; ///< m
  double elevation = 0.0;      ///< degrees
  double slantRange = 0.0;     ///< m
};

/// Calls for every voxel of the grid.
inline void ForEachVoxel(const GridSpecification& grid, const Position& site,
  const std::function<void(const SeenVoxel&)>& visit)
{
  const SiteGeoreference georeference(site);
  const BeamModel beam;
  SeenVoxel voxel;
  for (int y = 0; y < grid.dimensions[1]; ++y)
  {
    for (int x = 0; x < grid.dimensions[0]; ++x)
    {
      const auto place = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
      const GroundDirection direction = georeference.Look(place[0], place[1]);
      voxel.azimuth = direction.azimuth;
      voxel.groundDistance = direction.groundDistance;
      for (int z = 0; z < grid.dimensions[2]; ++z)
      {
        const BeamDirection look =
          beam.Look({grid.Coordinate(2, z) - site.altitude, direction.groundDistance});
        voxel.elevation = look.elevation;
        voxel.slantRange = look.slantRange;
        voxel.index = (static_cast<std::size_t>(z) * static_cast<std::size_t>(grid.dimensions[1]) +
                        static_cast<std::size_t>(y)) *
                        static_cast<std::size_t>(grid.dimensions[0]) +
                      static_cast<std::size_t>(x);
        visit(voxel);
      }
    }
  }
}

} // namespace nexrad::testing
