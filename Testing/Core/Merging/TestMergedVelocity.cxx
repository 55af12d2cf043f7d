// SPDX-License-Identifier: BSD-3-Clause
// Merged velocities, and what is derived of them, against the truth of SYNTHETIC scans.
#include "DirectMerge.h"
#include "Scans/SimulatedVelocities.h"
#include "SweepMaker.h"
#include "Tolerance.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Moments/MomentMaker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace nexrad
{
namespace
{

using testing::NumberSweep;
using testing::SimulatedVelocities;

// Two radars of two patterns that overlap, one with a low Nyquist velocity.
const std::vector<SimulatedVelocities>& Radars()
{
  static const std::vector<SimulatedVelocities> radars = {
    testing::SimulateVelocities("KLSX", 31), testing::SimulateVelocities("KILX", 12)};
  return radars;
}

GriddedVolume Merge(const std::vector<PolarVolume>& volumes)
{
  std::vector<const PolarVolume*> chosen;
  std::vector<Position> positions;
  for (const PolarVolume& volume : volumes)
  {
    chosen.push_back(&volume);
    positions.push_back(*volume.site.position);
  }
  MergeRequest request;
  GridRequest grid;
  grid.dimensions = {160, 160, 20};
  grid.range = 120'000.0;
  grid.top = 12'000.0;
  request.grid = MakeGrid(grid, positions);
  request.time = volumes.front().start + std::chrono::minutes(3);
  return *testing::MergeDirectly(chosen, request);
}

GriddedVolume MergeMade(const MomentOptions& options, MomentName moment)
{
  std::vector<PolarVolume> volumes;
  for (const SimulatedVelocities& each : Radars())
  {
    volumes.push_back(MomentMaker(each.volume, options).Make(moment));
  }
  return Merge(volumes);
}

} // namespace

TEST(MergedVelocity, HasTheTrueFolds)
{
  std::vector<PolarVolume> truths;
  for (const SimulatedVelocities& each : Radars())
  {
    truths.push_back(
      testing::PolarVelocities(each.truth, MakePolarVolume(each.volume, MomentName::VEL)));
  }
  const GriddedVolume truth = Merge(truths);
  const auto rightShare = [&truth](const GriddedVolume& merged)
  {
    std::size_t right = 0;
    std::size_t echoes = 0;
    for (std::size_t i = 0; i < truth.values.size(); ++i)
    {
      if (truth.states[i] == VoxelState::Echo && merged.states[i] == VoxelState::Echo)
      {
        ++echoes;
        right += std::abs(truth.values[i] - merged.values[i]) < 1.0F ? 1 : 0;
      }
    }
    EXPECT_GT(echoes, 10'000U);
    return 100.0 * static_cast<double>(right) / static_cast<double>(echoes);
  };
  MomentOptions options;
  EXPECT_AT_LEAST(
    rightShare(MergeMade(options, MomentName::VEL)), 99.9, "voxels of the true fold, %");
  options.dealias = false;
  EXPECT_AT_MOST(rightShare(MergeMade(options, MomentName::VEL)), 95.0,
    "voxels of the true fold without dealiasing, %");
}

TEST(MergedVelocity, WithoutDealiasingIsThatOfTheFiles)
{
  std::vector<PolarVolume> folded;
  for (const SimulatedVelocities& each : Radars())
  {
    folded.push_back(MakePolarVolume(each.volume, MomentName::VEL));
  }
  const GriddedVolume expected = Merge(folded);
  MomentOptions options;
  options.dealias = false;
  const GriddedVolume merged = MergeMade(options, MomentName::VEL);
  EXPECT_TRUE(merged.values == expected.values);
  EXPECT_TRUE(merged.states == expected.states);
}

namespace
{

constexpr double rotation = 0.01; // per second
constexpr double coreDistance = 40'000.0;
constexpr double coreRadius = 5'000.0;

// One radar that sees a column of solid-body rotation, centred `coreDistance` from it in a
// direction, in degrees; outside of the core the rotation dies out with the square of the distance.
PolarVolume ScanVortex(const Position& position, double direction, double turns)
{
  NumberSweep sweep = testing::MakeSweep(1, 0.5, 720, 240, 250.0);
  const double centre = direction * RadiansPerDegree;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.rays[ray].time = *ParseIso8601("2006-03-12T18:00Z");
    sweep.rays[ray].nyquist = 100.0F;
    const double azimuth = static_cast<double>(sweep.rays[ray].azimuth) * RadiansPerDegree;
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
      const double east = range * std::sin(azimuth) - coreDistance * std::sin(centre);
      const double north = range * std::cos(azimuth) - coreDistance * std::cos(centre);
      const double distance = std::hypot(east, north);
      const double speed =
        turns * rotation * std::min(1.0, coreRadius * coreRadius / (distance * distance));
      testing::SetGate(sweep, ray, gate,
        static_cast<float>(-speed * north * std::sin(azimuth) + speed * east * std::cos(azimuth)));
    }
  }
  PolarVolume volume = testing::MakeVolume(position, 0.0, {sweep});
  volume.moment = MomentName::VEL;
  return volume;
}

// The largest error of the merged shear within the core, away from its edge, in parts of the truth.
// A solid body has the same radial velocity at all ranges of an azimuth, so the shear of the arc
// falls with the distance from the first radar.
double LargestError(const std::vector<PolarVolume>& velocities, const Position& core)
{
  std::vector<PolarVolume> shears;
  for (const PolarVolume& each : velocities)
  {
    shears.push_back(MomentMaker([&each](MomentName, const WantedRange&) { return each; }, {})
                       .Make(MomentName::AZSHEAR));
  }
  std::vector<const PolarVolume*> chosen;
  for (const PolarVolume& each : shears)
  {
    chosen.push_back(&each);
  }
  MergeRequest request;
  GridRequest grid;
  grid.bounds = GeographicBounds{
    core.longitude - 0.06, core.latitude - 0.05, core.longitude + 0.06, core.latitude + 0.05};
  grid.dimensions = {24, 24, 4};
  grid.bottom = 400.0;
  grid.top = 800.0;
  request.grid = MakeGrid(grid, {*velocities.front().site.position});
  request.time = velocities.front().start;
  const GriddedVolume merged = *testing::MergeDirectly(chosen, request);
  double largest = 0.0;
  std::size_t compared = 0;
  const Position& site = *velocities.front().site.position;
  const std::array<double, 2> radar = request.grid.FromGeographic(site.longitude, site.latitude);
  const std::array<double, 2> centre = request.grid.FromGeographic(core.longitude, core.latitude);
  for (std::size_t i = 0; i < merged.values.size(); ++i)
  {
    const int x = int(i % 24);
    const int y = int(i / 24 % 24);
    if (std::hypot(request.grid.Coordinate(0, x) - centre[0],
          request.grid.Coordinate(1, y) - centre[1]) < coreRadius - 1'500.0)
    {
      EXPECT_EQ(merged.states[i], VoxelState::Echo);
      const double distance = std::hypot(
        request.grid.Coordinate(0, x) - radar[0], request.grid.Coordinate(1, y) - radar[1]);
      const double truth = rotation * coreDistance / distance;
      largest = std::max(largest, std::abs(static_cast<double>(merged.values[i]) / truth - 1.0));
      ++compared;
    }
  }
  EXPECT_GT(compared, 200U);
  return largest;
}

const Position west = {38.7, -90.7, 200.0};
const Position core = {38.7, -90.7 + 40.0 / 111.32 / 0.78043, 200.0};

} // namespace

TEST(MergedShear, OfAResolvedSolidBodyIsItsRotation)
{
  EXPECT_AT_MOST(LargestError({ScanVortex(west, 90.0, 1.0)}, core), 0.008,
    "merged shear of a solid body off, parts of it");
}

// The second radar, as near as the first, sees a fourth of the rotation: a mean would be 38 % low.
TEST(MergedShear, IsTheLargestOfTheRadars)
{
  const Position east = {38.7, core.longitude + 40.0 / 111.32 / 0.78043, 200.0};
  PolarVolume slow = ScanVortex(east, 270.0, 0.25);
  slow.site.name = "KTSU";
  EXPECT_AT_MOST(LargestError({ScanVortex(west, 90.0, 1.0), slow}, core), 0.008,
    "merged shear of a solid body that a second radar sees turn slowly off, parts of it");
}

} // namespace nexrad
