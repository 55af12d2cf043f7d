// SPDX-License-Identifier: BSD-3-Clause
// Formulas A3: the motion that is found, held against the motion of known fields.
#include "GridMaker.h"
#include "Motion/VolumeMotion.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

using namespace nexrad;
using nexrad::testing::MakeTestGrid;
using nexrad::testing::MakeTestVolume;
using namespace std::chrono_literals;

namespace
{

const Time noon = *ParseIso8601("2006-03-12T12:00:00Z");
constexpr double seconds = 600.0;

// A round storm of 45 dBZ that moves straight; `strength` adds to it at the second time.
struct TestStorm
{
  double x, y; // m, at the first time
  Velocity velocity;
  double growth = 0.0; // dBZ

  double Reflectivity(double atX, double atY, double part) const
  {
    const double dx = atX - x - part * seconds * velocity.east;
    const double dy = atY - y - part * seconds * velocity.north;
    const double length = 9000.0;
    return (45.0 + part * growth) * std::exp(-(dx * dx + dy * dy) / (length * length)) - 5.0;
  }
};

struct VolumePair
{
  GriddedVolume before;
  GriddedVolume after;
};

VolumePair MakePair(const GridSpecification& grid, const std::vector<TestStorm>& storms)
{
  const auto at = [&](double part)
  {
    return [&storms, part](double x, double y)
    {
      double strongest = 0.0;
      for (const TestStorm& storm : storms)
      {
        strongest = std::max(strongest, storm.Reflectivity(x, y, part));
      }
      return strongest;
    };
  };
  return {MakeTestVolume(grid, noon, at(0.0)), MakeTestVolume(grid, noon + 600s, at(1.0))};
}

// A storm at the middle of its way, in voxels of `spacing`.
Velocity FoundAt(const MotionField& field, const TestStorm& storm, double spacing)
{
  return field.At((storm.x + 0.5 * seconds * storm.velocity.east) / spacing,
    (storm.y + 0.5 * seconds * storm.velocity.north) / spacing);
}

void ExpectNear(const Velocity& found, const Velocity& wanted, double tolerance)
{
  EXPECT_AT_MOST(std::hypot(found.east - wanted.east, found.north - wanted.north), tolerance,
    "error of the motion, m/s");
}

const GridSpecification squareGrid = MakeTestGrid({128, 128, 2}, 2000.0);

} // namespace

TEST(MotionEstimate, FindsOneMotionAndFillsTheFieldWithIt)
{
  const Velocity velocity = {18.0, -11.0};
  const VolumePair pair = MakePair(
    squareGrid, {{60e3, 150e3, velocity}, {140e3, 90e3, velocity}, {170e3, 190e3, velocity}});
  const MotionField field = EstimateMotion(pair.before, pair.after);
  for (const double row : {0.0, 40.0, 90.0, 127.0})
  {
    for (const double column : {0.0, 33.0, 127.0})
    {
      ExpectNear(field.At(column, row), velocity, 0.04);
    }
  }
}

TEST(MotionEstimate, FindsStormsThatMoveApart)
{
  const std::vector<TestStorm> storms = {
    {60e3, 60e3, {20.0, 4.0}}, {180e3, 60e3, {8.0, 14.0}}, {120e3, 190e3, {15.0, -6.0}}};
  const VolumePair pair = MakePair(squareGrid, storms);
  const MotionField field = EstimateMotion(pair.before, pair.after);
  for (const TestStorm& storm : storms)
  {
    ExpectNear(FoundAt(field, storm, 2000.0), storm.velocity, 1.4);
  }
}

TEST(MotionEstimate, IsNotMisledByGrowthAndDecay)
{
  const Velocity velocity = {-16.0, 9.0};
  const std::vector<TestStorm> storms = {
    {90e3, 70e3, velocity, 12.0}, {190e3, 80e3, velocity, -15.0}, {150e3, 190e3, velocity}};
  const VolumePair pair = MakePair(squareGrid, storms);
  const MotionField field = EstimateMotion(pair.before, pair.after);
  for (const TestStorm& storm : storms)
  {
    ExpectNear(FoundAt(field, storm, 2000.0), velocity, 0.9);
  }
}

TEST(MotionEstimate, DoesNotDependOnTheVoxelsSize)
{
  const Velocity velocity = {18.0, -11.0};
  const std::vector<TestStorm> storms = {{60e3, 150e3, velocity}, {140e3, 90e3, velocity}};
  for (const double spacing : {1000.0, 4000.0})
  {
    const int size = static_cast<int>(256e3 / spacing);
    const VolumePair pair = MakePair(MakeTestGrid({size, size, 1}, spacing), storms);
    ExpectNear(
      FoundAt(EstimateMotion(pair.before, pair.after), storms[0], spacing), velocity, 0.23);
  }
}

// On geographic axes the same metres are more voxels eastwards than northwards.
TEST(MotionEstimate, CountsInMetresOnGeographicAxes)
{
  GridSpecification grid = MakeTestGrid({160, 128, 1}, 0.0);
  grid.axes = GridAxes::Geographic;
  grid.origin = {-90.0, 44.0, 0.0};
  grid.spacing = {0.02, 0.02, 500.0};
  const double northward = VoxelExtent(grid, 0.0)[1];
  const double eastward = VoxelExtent(grid, 64.0)[0];
  const auto at = [&](double shift)
  {
    return [=](double longitude, double latitude)
    {
      const double x = (longitude + 90.0) / 0.02 * eastward - 140e3 - shift * 12'000.0;
      const double y = (latitude - 44.0) / 0.02 * northward - 140e3 - shift * 6'000.0;
      return 45.0 * std::exp(-(x * x + y * y) / 1e8) - 5.0;
    };
  };
  const MotionField field =
    EstimateMotion(MakeTestVolume(grid, noon, at(0.0)), MakeTestVolume(grid, noon + 600s, at(1.0)));
  ExpectNear(field.At(146e3 / eastward, 143e3 / northward), {20.0, 10.0}, 0.036);
}

TEST(MotionEstimate, IsStillWithoutEcho)
{
  const VolumePair pair = MakePair(squareGrid, {});
  const MotionField field = EstimateMotion(pair.before, pair.after);
  for (const Velocity& velocity : field.velocities)
  {
    EXPECT_EQ(velocity.east, 0.0);
    EXPECT_EQ(velocity.north, 0.0);
  }
}

// What was not scanned is no storm's edge: coverage that changes does not pull the storm along.
TEST(MotionEstimate, IgnoresWhatWasNotScanned)
{
  const TestStorm storm = {110e3, 120e3, {14.0, 7.0}};
  VolumePair pair = MakePair(squareGrid, {storm});
  const auto width = static_cast<std::size_t>(squareGrid.dimensions[0]);
  for (std::size_t i = 0; i < pair.after.values.size(); ++i)
  {
    if (i % width > 64) // through the storm
    {
      pair.after.values[i] = pair.after.fill;
      pair.after.states[i] = VoxelState::NotScanned;
    }
  }
  const MotionField field = EstimateMotion(pair.before, pair.after);
  ExpectNear(FoundAt(field, storm, 2000.0), storm.velocity, 0.063);
}

TEST(MotionEstimate, KeepsToTheMaximumSpeed)
{
  const Velocity velocity = {30.0, 0.0};
  const VolumePair pair = MakePair(squareGrid, {{100e3, 128e3, velocity}});
  MotionOptions options;
  options.maximumSpeed = 12.0;
  for (const Velocity& found : EstimateMotion(pair.before, pair.after, options).velocities)
  {
    EXPECT_LE(std::hypot(found.east, found.north), 12.0 + 1e-9);
  }
}

TEST(MotionEstimate, NeedsNoMaximumSpeed)
{
  const TestStorm storm = {100e3, 128e3, {30.0, 0.0}};
  const VolumePair pair = MakePair(squareGrid, {storm});
  MotionOptions options;
  options.maximumSpeed = std::numeric_limits<double>::infinity();
  const MotionField field = EstimateMotion(pair.before, pair.after, options);
  ExpectNear(FoundAt(field, storm, 2000.0), storm.velocity, 0.0028);
}

TEST(MotionEstimate, WorksOnTheSmallestGrids)
{
  for (const std::array<int, 3>& dimensions : {std::array<int, 3>{1, 1, 1}, {2, 1, 1}, {1, 5, 2}})
  {
    const VolumePair pair = MakePair(MakeTestGrid(dimensions, 2000.0), {{0.0, 0.0, {5.0, 5.0}}});
    for (const Velocity& found : EstimateMotion(pair.before, pair.after).velocities)
    {
      EXPECT_TRUE(std::isfinite(found.east) && std::isfinite(found.north));
    }
  }
}

TEST(MotionEstimate, RefusesOptionsAndVolumesThatMakeNoSense)
{
  VolumePair pair = MakePair(MakeTestGrid({4, 4, 1}, 2000.0), {});
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
  {
    MotionOptions options;
    options.spacing = bad;
    EXPECT_THROW(EstimateMotion(pair.before, pair.after, options), Error);
  }
  EXPECT_THROW(EstimateMotion(pair.after, pair.before), Error);
  GriddedVolume other = pair.after;
  other.grid.origin[0] = 1.0;
  EXPECT_THROW(EstimateMotion(pair.before, other), Error);
  other = pair.after;
  other.moment = MomentName::VEL;
  EXPECT_THROW(EstimateMotion(pair.before, other), Error);
  other = pair.after;
  other.states.pop_back();
  EXPECT_THROW(EstimateMotion(pair.before, other), Error);
}
