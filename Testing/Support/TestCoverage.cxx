// SPDX-License-Identifier: BSD-3-Clause
#include "Coverage.h"

#include "SweepMaker.h"
#include "Tolerance.h"
#include "nexrad/Geometry/SiteGeoreference.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace nexrad;
using nexrad::testing::MakeSweep;
using nexrad::testing::MakeVolume;
using nexrad::testing::NumberSweep;

namespace
{

const Position here = {39.0, -92.0, 250.0};

GridSpecification GridAbout(const Position& site)
{
  GridRequest request;
  request.dimensions = {24, 24, 40};
  request.range = 120'000.0;
  request.top = 12'000.0;
  return MakeGrid(request, {site});
}

} // namespace

// The definition, applied to each voxel without any short cut.
TEST(Coverage, IsTheDefinition)
{
  NumberSweep low = MakeSweep(1, 0.5, 360, 100, 1000.0);
  low.rays.erase(low.rays.begin() + 40, low.rays.begin() + 80); // a sector that was not scanned
  low.states.resize(low.rays.size() * low.gates);
  low.values.resize(low.states.size());
  const NumberSweep high = MakeSweep(2, 6.0, 360, 60, 1000.0);
  const PolarVolume volume = MakeVolume(here, 0.0, {low, high});
  const GridSpecification grid = GridAbout(here);
  const auto seen = BeamCoverage({&volume}, grid);
  const BeamModel beam;
  std::size_t marked = 0;
  for (std::size_t i = 0; i < seen.size(); ++i)
  {
    const int x = static_cast<int>(i % 24);
    const int y = static_cast<int>(i / 24 % 24);
    const int z = static_cast<int>(i / 576);
    const auto place = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
    const GroundDirection ground = SiteGeoreference(here).Look(place[0], place[1]);
    const BeamDirection look =
      beam.Look({grid.Coordinate(2, z) - here.altitude, ground.groundDistance});
    const bool sector = ground.azimuth > 39.95 && ground.azimuth < 79.05;
    const bool inLow = !sector && std::abs(look.elevation - 0.5) <= 0.475 &&
                       look.slantRange >= 500.0 && look.slantRange < 100'500.0;
    const bool inHigh = std::abs(look.elevation - 6.0) <= 0.475 && look.slantRange >= 500.0 &&
                        look.slantRange < 60'500.0;
    EXPECT_EQ(seen[i] != 0, inLow || inHigh) << "voxel " << x << " " << y << " " << z;
    marked += seen[i];
  }
  EXPECT_AT_LEAST(marked, 700u, "voxels seen");
  EXPECT_AT_MOST(static_cast<double>(marked) / static_cast<double>(seen.size()), 0.11,
    "share of the voxels seen");
}

TEST(Coverage, GatesThatWereNotSampledSeeNothing)
{
  NumberSweep sweep = MakeSweep(1, 2.0, 360, 100, 1000.0);
  const GridSpecification grid = GridAbout(here);
  const PolarVolume whole = MakeVolume(here, 0.0, {sweep});
  sweep.states.assign(sweep.states.size(), GateState::NotSampled);
  const PolarVolume nothing = MakeVolume(here, 0.0, {sweep});
  const auto count = [](const std::vector<std::uint8_t>& seen)
  { return std::accumulate(seen.begin(), seen.end(), std::size_t(0)); };
  EXPECT_AT_LEAST(count(BeamCoverage({&whole}, grid)), 600u, "voxels seen");
  EXPECT_EQ(count(BeamCoverage({&nothing}, grid)), 0u);
  EXPECT_EQ(count(BeamCoverage({}, grid)), 0u);
  EXPECT_EQ(BeamCoverage({&nothing, &whole}, grid), BeamCoverage({&whole}, grid));
}

TEST(Coverage, RefusesASiteWithoutPosition)
{
  PolarVolume lost = MakeVolume(here, 0.0, {});
  lost.site.position.reset();
  EXPECT_THROW(BeamCoverage({&lost}, GridAbout(here)), Error);
}
