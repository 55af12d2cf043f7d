// SPDX-License-Identifier: BSD-3-Clause
#include "Coverage.h"

#include "SweepMaker.h"
#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Polar/SweepPairing.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// A column of voxels as one site sees it.
struct Column
{
  std::size_t index; // x + y × width
  GroundDirection direction;
};

// Marks the voxels that one volume saw.
class VolumeCoverage
{
public:
  VolumeCoverage(const PolarVolume& source, const GridSpecification& specification,
    const CoverageOptions& choices, std::vector<std::uint8_t>& marks)
    : volume(source)
    , grid(specification)
    , beam(choices.beam)
    , beamWidth(choices.beamWidth.value_or(BeamWidthOf(source.site)))
    , altitude(source.site.position->altitude)
    , seen(marks)
  {
    for (const PolarSweep& sweep : volume.sweeps)
    {
      finders.emplace_back(sweep);
      sweeps.push_back(testing::NumbersOf(sweep));
    }
  }

  void Mark(const Column& column) const
  {
    for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
    {
      const auto ray = finders[i].Nearest(column.direction.azimuth, beamWidth);
      if (ray)
      {
        this->MarkRay(column, sweeps[i], *ray);
      }
    }
  }

private:
  void MarkRay(const Column& column, const testing::NumberSweep& sweep, std::size_t ray) const
  {
    const double half = 0.5 * beamWidth;
    const auto elevation = static_cast<double>(sweep.rays[ray].elevation);
    const double distance = column.direction.groundDistance;
    const double low = beam.HeightOver(distance, elevation - half);
    const double high = beam.HeightOver(distance, elevation + half);
    const auto plane =
      static_cast<std::size_t>(grid.dimensions[0]) * static_cast<std::size_t>(grid.dimensions[1]);
    for (int level = this->FirstLevel(low); level < grid.dimensions[2]; ++level)
    {
      const double height = grid.Coordinate(2, level) - altitude;
      if (height > high)
      {
        break;
      }
      const double range = beam.Look({height, distance}).slantRange;
      if (IsSampled(sweep, ray, range))
      {
        seen[static_cast<std::size_t>(level) * plane + column.index] = 1;
      }
    }
  }

  // The lowest level whose centre is at or above a height over the antenna.
  int FirstLevel(double height) const
  {
    const double level = std::ceil((height + altitude - grid.origin[2]) / grid.spacing[2]);
    return static_cast<int>(std::clamp(level, 0.0, static_cast<double>(grid.dimensions[2])));
  }

  static bool IsSampled(const testing::NumberSweep& sweep, std::size_t ray, double range)
  {
    const double gate = std::round((range - sweep.firstGate) / sweep.gateSpacing);
    return gate >= 0.0 && gate < static_cast<double>(sweep.gates) &&
           sweep.states[sweep.Index(ray, static_cast<std::size_t>(gate))] != GateState::NotSampled;
  }

  const PolarVolume& volume;
  const GridSpecification& grid;
  const BeamModel beam;
  const double beamWidth; // degrees
  double altitude;        // m above mean sea level, of the antenna
  std::vector<RayFinder> finders;
  std::vector<testing::NumberSweep> sweeps;
  std::vector<std::uint8_t>& seen;
};

} // namespace

std::vector<std::uint8_t> BeamCoverage(const std::vector<const PolarVolume*>& volumes,
  const GridSpecification& grid, const CoverageOptions& options)
{
  std::vector<std::uint8_t> seen(grid.VoxelCount(), 0);
  for (const PolarVolume* volume : volumes)
  {
    if (!volume->site.position)
    {
      throw Error("site \"" + volume->site.name + "\" has no position: its coverage is unknown");
    }
    const SiteGeoreference georeference(*volume->site.position);
    const VolumeCoverage coverage(*volume, grid, options, seen);
    std::size_t index = 0;
    for (int y = 0; y < grid.dimensions[1]; ++y)
    {
      for (int x = 0; x < grid.dimensions[0]; ++x)
      {
        const auto place = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
        coverage.Mark({index++, georeference.Look(place[0], place[1])});
      }
    }
  }
  return seen;
}

} // namespace nexrad
