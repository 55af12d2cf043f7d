// SPDX-License-Identifier: BSD-3-Clause
// Formulas A2a: the merge along a motion that is given, held against a synthetic field that moves.
#include "BeamScene.h"
#include "MovingEcho.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

const Site site = {"KTST", centralSite};
const Velocity velocity = {22.0, -12.0};

// Storms east, north and west of the radar.
MovingEcho TestField()
{
  MovingEcho field;
  field.storms = {{60e3, 30e3, 50.0}, {-20e3, 55e3, 45.0}, {-50e3, -20e3, 55.0}};
  field.velocity = velocity;
  return field;
}

// Columns 2 km apart to 90 km from the radar, levels of 500 m.
GridSpecification FineGrid()
{
  GridSpecification grid = SceneGrid();
  grid.dimensions = {91, 91, 10};
  grid.spacing = {2'000.0, 2'000.0, 500.0};
  grid.origin = {-90'000.0, -90'000.0, 1'000.0};
  return grid;
}

GriddedVolume MergeMoving(const std::vector<PolarVolume>& volumes, double seconds,
  const MotionField* motion, const GridSpecification& grid = FineGrid(), const RangeLoop& loop = {},
  const BeamMergeOptions& options = {})
{
  std::vector<const PolarVolume*> pointers;
  for (const PolarVolume& volume : volumes)
  {
    pointers.push_back(&volume);
  }
  BeamMerger merger(grid, options);
  const Time time = sceneTime + Duration(std::llround(seconds * 1000.0));
  return *merger.Merge(PrepareAll(merger, pointers), time, motion, loop);
}

// Largest difference from the field in dBZ over the voxels between the tilts 0.5° and 6° where it
// has 15 dBZ or more: its edge, which a threshold cuts, is no matter here.
double LargestError(const GriddedVolume& volume, const MovingEcho& field, double seconds)
{
  double largest = 0.0;
  std::size_t count = 0;
  const auto compare = [&](const SeenVoxel& voxel)
  {
    const double azimuth = voxel.azimuth * RadiansPerDegree;
    const double truth = field.At(
      voxel.groundDistance * std::sin(azimuth), voxel.groundDistance * std::cos(azimuth), seconds);
    if (truth >= 15.0 && voxel.elevation > 0.5 && voxel.elevation < 6.0)
    {
      ++count;
      const bool echo = volume.states[voxel.index] == VoxelState::Echo;
      const double found = echo ? static_cast<double>(volume.values[voxel.index]) : 0.0;
      largest = std::max(largest, std::abs(found - truth));
    }
  };
  ForEachVoxel(volume.grid, centralSite, compare);
  EXPECT_GT(count, 300u);
  return largest;
}

std::vector<PolarVolume> TwoVolumes(const ScanPlan& plan = {})
{
  const MovingEcho field = TestField();
  return {
    ScanEcho(field, site, sceneTime, -240.0, plan), ScanEcho(field, site, sceneTime, 60.0, plan)};
}

} // namespace

// Between gates of 1 km and rays that are 1.2 km apart at 70 km, a storm of 55 dBZ that falls to
// 1/e in 8 km is interpolated to 0.6 dBZ: h²/8 times its curvature, 2 · 55 dBZ / (8 km)², along
// both axes. It moves by 25 m/s, and so by 1.5 to 6 km from the looks at it to the time.
TEST(BeamMotion, EchoStandsWhereItWasAtTheTime)
{
  const std::vector<PolarVolume> volumes = TwoVolumes();
  const MotionField motion = MotionField::Constant(velocity);
  EXPECT_AT_MOST(LargestError(MergeMoving(volumes, 0.0, &motion), TestField(), 0.0), 0.8,
    "largest error along the motion, dBZ");
  EXPECT_AT_LEAST(LargestError(MergeMoving(volumes, 0.0, nullptr), TestField(), 0.0), 8.0,
    "largest error without the motion, dBZ");
}

// Formulas A2b: of a cell that decays between two volumes the stronger observation counts more. The
// last tilt is scanned 110 s before and 190 s after the time.
TEST(BeamMotion, OfCellsThatChangeTheStrongerCountsMore)
{
  const auto strongest = [](double before, double after)
  {
    MovingEcho first;
    first.storms = {{30e3, 20e3, before}};
    first.velocity = velocity;
    MovingEcho second = first;
    second.storms[0].dbz = after;
    const MotionField motion = MotionField::Constant(velocity);
    const GriddedVolume merged = MergeMoving(
      {ScanEcho(first, site, sceneTime, -210.0, {}), ScanEcho(second, site, sceneTime, 90.0, {})},
      0.0, &motion);
    return static_cast<double>(*std::max_element(merged.values.begin(), merged.values.end()));
  };
  constexpr double share = 110.0 / 300.0;
  EXPECT_WITHIN(strongest(45.0, 35.0), 45.0 - 10.0 * std::pow(share, 2.5), 0.5,
    "strongest echo of a cell that decays, dBZ");
  EXPECT_WITHIN(strongest(45.0, 42.0), 45.0 - 3.0 * share, 0.5,
    "strongest echo of a cell that hardly decays, dBZ");
  EXPECT_WITHIN(
    strongest(25.0, 15.0), 25.0 - 10.0 * share, 0.5, "strongest echo that is no cell, dBZ");
}

// In the middle of a sweep, and of a volume: for half of the directions this sweep is the last
// look, for the others the next one.
TEST(BeamMotion, HoldsWhereASweepWasInProgress)
{
  const MovingEcho field = TestField();
  ScanPlan plan;
  plan.firstAzimuth = 250.0; // between them its seam goes through a storm
  const std::vector<PolarVolume> volumes = {ScanEcho(field, site, sceneTime, -300.0, plan),
    ScanEcho(field, site, sceneTime, -50.0, plan), ScanEcho(field, site, sceneTime, 200.0, plan)};
  const MotionField motion = MotionField::Constant(velocity);
  for (const double seconds : {-45.0, -10.0, 0.0, 3.0, 12.0})
  {
    EXPECT_AT_MOST(LargestError(MergeMoving(volumes, seconds, &motion), field, seconds), 0.9,
      "largest error along the motion, dBZ")
      << seconds;
  }
}

// A tilt that the later pattern does not have is interpolated between two sweeps, minutes apart,
// each of which is looked up where the echo was at its own time.
TEST(BeamMotion, HoldsAcrossAChangeOfPattern)
{
  const MovingEcho field = TestField();
  ScanPlan later;
  later.tilts = {0.5, 1.9, 2.9, 3.9, 6.0};
  later.secondsPerSweep = 40.0;
  const std::vector<PolarVolume> volumes = {
    ScanEcho(field, site, sceneTime, -150.0), ScanEcho(field, site, sceneTime, 20.0, later)};
  const MotionField motion = MotionField::Constant(velocity);
  EXPECT_AT_MOST(LargestError(MergeMoving(volumes, 0.0, &motion), field, 0.0), 1.0,
    "largest error along the motion, dBZ");
}

// The motion's lattice is that of the grid: east of the radar the storm moves north, west of it
// south.
TEST(BeamMotion, TakesTheMotionOfTheColumn)
{
  MovingEcho east;
  east.storms = {{50e3, 0.0, 50.0}};
  east.velocity = {0.0, 25.0};
  MovingEcho west;
  west.storms = {{-50e3, 0.0, 50.0}};
  west.velocity = {0.0, -25.0};
  std::vector<PolarVolume> volumes;
  for (const double start : {-240.0, 60.0})
  {
    volumes.push_back(ScanEcho(east, site, sceneTime, start));
    const PolarVolume other = ScanEcho(west, site, sceneTime, start);
    for (std::size_t i = 0; i < other.sweeps.size(); ++i)
    {
      const NumberSweep from = NumbersOf(other.sweeps[i]);
      const auto copyHalf = [&from](NumberSweep& sweep)
      {
        const auto half = static_cast<std::ptrdiff_t>(sweep.values.size() / 2);
        std::copy(from.values.begin() + half, from.values.end(), sweep.values.begin() + half);
        std::copy(from.states.begin() + half, from.states.end(), sweep.states.begin() + half);
      };
      ChangeGates(volumes.back().sweeps[i], copyHalf);
    }
  }
  MotionField motion;
  motion.lattice.nodes = {4, 2};
  motion.lattice.step = {30.0, 90.0};
  const Velocity north = {0.0, 25.0};
  const Velocity south = {0.0, -25.0};
  motion.velocities = {south, south, north, north, south, south, north, north};
  const GriddedVolume merged = MergeMoving(volumes, 0.0, &motion);
  EXPECT_AT_MOST(LargestError(merged, east, 0.0), 0.8, "largest error of the eastern echo, dBZ");
  EXPECT_AT_MOST(LargestError(merged, west, 0.0), 0.8, "largest error of the western echo, dBZ");
}

// 20° east of the grid's centre the radar's north stands 12.7° to the left of the grid's. At 100
// m/s a motion that is not turned puts each look 3 km off, to opposite sides; what of that does not
// cancel is 3² · 55 dBZ / 8², 8 dBZ in the middle of a storm.
TEST(BeamMotion, IsTurnedFromTheGridsDirectionsToTheRadars)
{
  MovingEcho field = TestField();
  field.velocity = {0.0, 100.0};
  GridSpecification grid = FineGrid();
  grid.centreLongitude = centralSite.longitude - 20.0;
  const auto centre = grid.FromGeographic(centralSite.longitude, centralSite.latitude);
  grid.origin = {centre[0] - 90'000.0, centre[1] - 90'000.0, 1'000.0};
  const auto above = grid.FromGeographic(centralSite.longitude, centralSite.latitude + 0.1);
  const double turn = std::atan2(above[0] - centre[0], above[1] - centre[1]);
  ASSERT_WITHIN(turn / RadiansPerDegree, -12.7, 0.3, "turn of the grid's north, degrees");
  const std::vector<PolarVolume> volumes = {
    ScanEcho(field, site, sceneTime, -200.0), ScanEcho(field, site, sceneTime, 100.0)};
  const MotionField turned =
    MotionField::Constant({100.0 * std::sin(turn), 100.0 * std::cos(turn)});
  // From one sweep to the next the storms move 2 km: what neighbouring sweeps hold above a place
  // belongs to other storms, so that nothing is to be had from them.
  BeamMergeOptions options;
  options.sharpen = false;
  options.trend = false;
  EXPECT_AT_MOST(LargestError(MergeMoving(volumes, 0.0, &turned, grid, {}, options), field, 0.0),
    0.8, "largest error with the motion turned, dBZ");
  const MotionField same = MotionField::Constant(field.velocity);
  EXPECT_AT_LEAST(LargestError(MergeMoving(volumes, 0.0, &same, grid, {}, options), field, 0.0),
    5.0, "largest error with the motion not turned, dBZ");
}

TEST(BeamMotion, CountsInMetresOnGeographicAxes)
{
  GridSpecification grid = FineGrid();
  grid.axes = GridAxes::Geographic;
  grid.spacing = {0.022, 0.018, 500.0};
  grid.origin = {centralSite.longitude - 45 * 0.022, centralSite.latitude - 45 * 0.018, 1'000.0};
  const MotionField motion = MotionField::Constant(velocity);
  EXPECT_AT_MOST(LargestError(MergeMoving(TwoVolumes(), 0.0, &motion, grid), TestField(), 0.0), 0.8,
    "largest error along the motion, dBZ");
}

TEST(BeamMotion, WithoutSpeedIsLinearToTheLastBit)
{
  const std::vector<PolarVolume> volumes = TwoVolumes();
  const GriddedVolume linear = MergeMoving(volumes, 0.0, nullptr);
  const MotionField still = MotionField::Constant({0.0, 0.0});
  EXPECT_EQ(MergeMoving(volumes, 0.0, &still).values, linear.values);
  // Still where the grid is looked at, though not beyond: the looks go all the same way.
  MotionField almost;
  almost.lattice.nodes = {2, 91};
  almost.lattice.step = {90.0, 1.0};
  almost.velocities.assign(182, Velocity{});
  almost.velocities.back() = {10.0, 0.0};
  const GriddedVolume merged = MergeMoving(volumes, 0.0, &almost);
  const std::size_t row = 91;
  for (std::size_t level = 0; level < 10; ++level)
  {
    const auto first = static_cast<std::ptrdiff_t>(level * row * row);
    const auto end = first + static_cast<std::ptrdiff_t>(88 * row);
    EXPECT_TRUE(std::equal(
      merged.values.begin() + first, merged.values.begin() + end, linear.values.begin() + first));
  }
}

// Before the first volume and after the last each tilt has one look, up to 300 s from the time. It
// goes 7.5 km along the motion.
TEST(BeamMotion, ALookAloneGoesAlongTheMotion)
{
  const MovingEcho field = TestField();
  const MotionField motion = MotionField::Constant(velocity);
  for (const double start : {-300.0, 180.0})
  {
    const std::vector<PolarVolume> one = {ScanEcho(field, site, sceneTime, start)};
    EXPECT_AT_MOST(LargestError(MergeMoving(one, 0.0, &motion), field, 0.0), 0.9,
      "largest error along the motion, dBZ")
      << start;
    EXPECT_AT_LEAST(LargestError(MergeMoving(one, 0.0, nullptr), field, 0.0), 20.0,
      "largest error without the motion, dBZ")
      << start;
  }
}

namespace
{

// 45 dBZ at the antenna and 3 dB less each km above it, everywhere: so it stays however it moves.
PolarVolume ScanLayers(double start)
{
  PolarVolume volume = ScanEcho({}, site, sceneTime, start);
  const auto fill = [](NumberSweep& sweep)
  {
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      const auto elevation = static_cast<double>(sweep.rays[ray].elevation);
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
        const double height = BeamModel().Locate(range, elevation).height;
        SetGate(sweep, ray, gate, static_cast<float>(45.0 - 0.003 * height));
      }
    }
  };
  for (PolarSweep& sweep : volume.sweeps)
  {
    ChangeGates(sweep, fill);
  }
  return volume;
}

} // namespace

// 7.5 km farther out a tilt at 6° is 0.8 km higher, where it has 2.4 dB less.
TEST(BeamMotion, ALookAloneKeepsItsHeight)
{
  const std::vector<PolarVolume> one = {ScanLayers(-300.0)};
  const MotionField motion = MotionField::Constant(velocity);
  BeamMergeOptions options;
  options.sharpen = false;
  const GriddedVolume moved = MergeMoving(one, 0.0, &motion, FineGrid(), {}, options);
  const GriddedVolume linear = MergeMoving(one, 0.0, nullptr, FineGrid(), {}, options);
  std::size_t count = 0;
  double largest = 0.0;
  const auto compare = [&](const SeenVoxel& voxel)
  {
    // Beyond the lowest and the highest tilt there is none from which what moved could come.
    if (voxel.elevation > 1.4 && voxel.elevation < 4.3 && voxel.groundDistance > 15e3)
    {
      ++count;
      ASSERT_EQ(moved.states[voxel.index], VoxelState::Echo);
      largest = std::max(largest,
        static_cast<double>(std::abs(moved.values[voxel.index] - linear.values[voxel.index])));
    }
  };
  ForEachVoxel(moved.grid, centralSite, compare);
  EXPECT_AT_LEAST(count, 40'000u, "voxels compared");
  EXPECT_AT_MOST(
    largest, 0.4, "largest difference of moved and unmoved, dBZ"); // the tilts between which it is
                                                                   // interpolated are 20 s apart
}

namespace
{

// Quarters of the circle of a value, without echo, range folded, and not sampled, in this order;
// the value is that of every other ray, and its negative that of those between where it is asked
// for.
PolarVolume FourQuarters(double start, float value = 40.0F, bool alternate = false)
{
  PolarVolume volume = ScanEcho({}, site, sceneTime, start);
  const auto fill = [value, alternate](NumberSweep& sweep)
  {
    constexpr std::array<GateState, 4> states = {
      GateState::Valid, GateState::BelowThreshold, GateState::RangeFolded, GateState::NotSampled};
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        sweep.states[sweep.Index(ray, gate)] = states[ray / 90];
        sweep.values[sweep.Index(ray, gate)] = alternate && ray % 2 == 1 ? -value : value;
      }
    }
  };
  for (PolarSweep& sweep : volume.sweeps)
  {
    ChangeGates(sweep, fill);
  }
  return volume;
}

} // namespace

// The looks go up to 5 km away, and no voxel becomes seen or unseen by that; what is folded at all
// times stays so.
class KindsOfNothing : public ::testing::TestWithParam<std::vector<double>>
{
};

TEST_P(KindsOfNothing, StayApart)
{
  std::vector<PolarVolume> volumes;
  for (const double start : GetParam())
  {
    volumes.push_back(FourQuarters(start));
  }
  const MotionField motion = MotionField::Constant(velocity);
  const GriddedVolume moved = MergeMoving(volumes, 0.0, &motion);
  const GriddedVolume linear = MergeMoving(volumes, 0.0, nullptr);
  std::array<std::size_t, 4> counts = {};
  std::size_t changed = 0;
  for (std::size_t i = 0; i < linear.states.size(); ++i)
  {
    const auto tells = [](VoxelState state)
    { return state == VoxelState::Echo || state == VoxelState::NoEcho; };
    ++counts[static_cast<std::size_t>(linear.states[i])];
    changed += moved.states[i] != linear.states[i] ? 1 : 0;
    if (tells(linear.states[i]))
    {
      ASSERT_TRUE(tells(moved.states[i]));
    }
    else
    {
      ASSERT_EQ(moved.states[i], linear.states[i]);
    }
  }
  EXPECT_AT_LEAST(
    *std::min_element(counts.begin(), counts.end()), 10'000u, "voxels of the rarest kind");
  EXPECT_AT_LEAST(changed, 220u, "voxels that change"); // along the border between echo and none
}

INSTANTIATE_TEST_SUITE_P(OnOneSideOrBoth, KindsOfNothing,
  ::testing::Values(
    std::vector<double>{-240.0, 60.0}, std::vector<double>{-240.0}, std::vector<double>{180.0}));

TEST(BeamMotion, VelocityIsNeverBlended)
{
  std::vector<PolarVolume> volumes = {
    FourQuarters(-240.0, 20.0F, true), FourQuarters(60.0, 20.0F, true)};
  for (PolarVolume& volume : volumes)
  {
    volume.moment = MomentName::VEL;
  }
  const MotionField motion = MotionField::Constant(velocity);
  const GriddedVolume merged = MergeMoving(volumes, 0.0, &motion);
  std::size_t count = 0;
  for (std::size_t i = 0; i < merged.values.size(); ++i)
  {
    if (merged.states[i] == VoxelState::Echo)
    {
      ++count;
      ASSERT_NEAR(std::abs(merged.values[i]), 20.0F, 1e-3F);
    }
  }
  EXPECT_AT_LEAST(count, 10'000u, "voxels of echo");
}

TEST(BeamMotion, TheResultDoesNotDependOnThreadsOrOrder)
{
  std::vector<PolarVolume> volumes = TwoVolumes();
  const MotionField motion = MotionField::Constant(velocity);
  const GriddedVolume once = MergeMoving(volumes, 0.0, &motion);
  for (const unsigned threads : {1U, 2U, 7U})
  {
    const GriddedVolume again = MergeMoving(volumes, 0.0, &motion, FineGrid(), ThreadLoop(threads));
    EXPECT_EQ(again.values, once.values);
    EXPECT_EQ(again.states, once.states);
  }
  std::reverse(volumes.begin(), volumes.end());
  EXPECT_EQ(MergeMoving(volumes, 0.0, &motion).values, once.values);
}

// Where a mask says that there is no echo about a column, gates are not looked up. With ages asked
// for they are, each of them: the voxels must be the same, in a volume and between volumes, with
// patterns that change, and rays that are missing.
TEST(BeamMotion, WhatIsPassedOverHoldsNothing)
{
  const MovingEcho field = TestField();
  ScanPlan later;
  later.tilts = {0.5, 1.9, 2.9, 3.9, 6.0, 19.5};
  std::vector<PolarVolume> volumes = {ScanEcho(field, site, sceneTime, -300.0),
    ScanEcho(field, site, sceneTime, -50.0), ScanEcho(field, site, sceneTime, 200.0, later)};
  volumes[1].sweeps[2].rays.resize(300);
  ChangeGates(volumes[2].sweeps[0],
    [](NumberSweep& sweep) { sweep.states[sweep.Index(20, 70)] = GateState::RangeFolded; });
  const MotionField motion = MotionField::Constant(velocity);
  BeamMergeOptions withAges;
  withAges.ancillary = true;
  GridSpecification grid = SceneGrid(); // reaches beyond the last gates
  for (const double seconds : {-400.0, -250.0, -20.0, 10.0, 120.0, 190.0, 260.0, 500.0})
  {
    for (const MotionField* each : {&motion, static_cast<const MotionField*>(nullptr)})
    {
      const GriddedVolume quick = MergeMoving(volumes, seconds, each, grid);
      const GriddedVolume whole = MergeMoving(volumes, seconds, each, grid, {}, withAges);
      EXPECT_EQ(quick.values, whole.values);
      EXPECT_EQ(quick.states, whole.states);
    }
  }
}

namespace
{

// The same with filtered gates in place of range-folded ones.
PolarVolume WithFilteredGates(PolarVolume volume)
{
  for (PolarSweep& sweep : volume.sweeps)
  {
    GateRows rows(sweep.rows.LargestCode());
    std::vector<std::uint16_t> codes(sweep.gates);
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      sweep.Read(ray, codes.data());
      std::replace(codes.begin(), codes.end(), std::uint16_t(GateCode::RangeFolded),
        std::uint16_t(GateCode::Filtered));
      rows.Append(codes.data(), codes.size());
    }
    rows.Finish();
    sweep.rows = std::move(rows);
  }
  return volume;
}

} // namespace

// Neither has a weight, and neither is looked for along the motion.
TEST(BeamMotion, FilteredGatesCountAsRangeFoldedOnes)
{
  const std::vector<PolarVolume> folded = {FourQuarters(-300.0), FourQuarters(200.0)};
  const std::vector<PolarVolume> filtered = {
    WithFilteredGates(folded[0]), WithFilteredGates(folded[1])};
  const MotionField motion = MotionField::Constant(velocity);
  for (const MotionField* each : {&motion, static_cast<const MotionField*>(nullptr)})
  {
    GriddedVolume expected = MergeMoving(folded, 0.0, each);
    const GriddedVolume found = MergeMoving(filtered, 0.0, each);
    EXPECT_GT(
      std::count(expected.states.begin(), expected.states.end(), VoxelState::RangeFolded), 1000);
    std::replace(expected.states.begin(), expected.states.end(), VoxelState::RangeFolded,
      VoxelState::Filtered);
    EXPECT_TRUE(found.states == expected.states);
    EXPECT_TRUE(found.values == expected.values);
  }
}

namespace
{

// The states of a volume of codes, which its codes tell or do not.
std::vector<VoxelState> StatesOfCodes(const GriddedVolume& volume)
{
  std::vector<VoxelState> states;
  for (const std::uint8_t code : volume.codes)
  {
    states.push_back(MomentCode::StateOf(code));
  }
  for (const StateRun& run : volume.statesBesideCodes)
  {
    std::fill_n(states.begin() + static_cast<std::ptrdiff_t>(run.first), run.count, run.state);
  }
  return states;
}

// Two looks with sectors of echo, no echo, gates that are folded, in the lowest sweep filtered, and
// none.
std::vector<PolarVolume> AllKinds()
{
  std::vector<PolarVolume> volumes = {FourQuarters(-300.0), FourQuarters(200.0)};
  for (PolarVolume& volume : volumes)
  {
    volume.sweeps.front() = WithFilteredGates(volume).sweeps.front();
  }
  return volumes;
}

} // namespace

// Codes are those that a file has of the values, however many threads make them.
TEST(BeamMotion, CodesAreThoseOfValuesAndStates)
{
  const MotionField motion = MotionField::Constant(velocity);
  std::vector<BeamMergeOptions> cases(4);
  cases[1].fillColumns = true;
  cases[2].ancillary = true;
  cases[3].strategy = OverlapStrategy::Maximum;
  for (BeamMergeOptions options : cases)
  {
    const GriddedVolume expected = MergeMoving(AllKinds(), 0.0, &motion, FineGrid(), {}, options);
    std::vector<std::uint8_t> codes(expected.values.size());
    MomentCode::Of(expected).WriteBytes(expected, 0, codes.size(), codes.data());
    options.codes = true;
    for (const RangeLoop& loop : {RangeLoop(), ThreadLoop(3)})
    {
      const GriddedVolume found = MergeMoving(AllKinds(), 0.0, &motion, FineGrid(), loop, options);
      EXPECT_TRUE(found.values.empty() && found.states.empty());
      EXPECT_TRUE(found.codes == codes);
      EXPECT_TRUE(StatesOfCodes(found) == expected.states);
      EXPECT_TRUE(std::is_sorted(found.statesBesideCodes.begin(), found.statesBesideCodes.end(),
        [](const StateRun& one, const StateRun& next) { return one.first < next.first; }));
      EXPECT_TRUE(found.ancillary.weight == expected.ancillary.weight);
    }
    EXPECT_GT(std::count(expected.states.begin(), expected.states.end(), VoxelState::Filtered), 99);
    EXPECT_GT(
      std::count(expected.states.begin(), expected.states.end(), VoxelState::RangeFolded), 99);
  }
}

// How many bytes a velocity needs depends on all voxels.
TEST(BeamMotion, VelocityHasNoCodes)
{
  std::vector<PolarVolume> volumes = AllKinds();
  volumes[0].moment = volumes[1].moment = MomentName::VEL;
  BeamMergeOptions options;
  options.codes = true;
  const GriddedVolume found = MergeMoving(volumes, 0.0, nullptr, FineGrid(), {}, options);
  EXPECT_TRUE(found.codes.empty());
  EXPECT_EQ(found.values.size(), found.grid.VoxelCount());
}

TEST(BeamMotion, RefusesTheMotionOfAnotherGrid)
{
  MotionField motion;
  motion.lattice.nodes = {2, 2};
  motion.lattice.step = {50.0, 90.0};
  motion.velocities.assign(4, Velocity{});
  EXPECT_THROW(MergeMoving(TwoVolumes(), 0.0, &motion), Error);
}

// Against sines and cosines in double precision.
TEST(BeamMotion, DirectionsFollowTheMotion)
{
  constexpr double diameter = 2.0 * 8'494'666.7;
  for (const double range : {500.0, 4e3, 30e3, 200e3})
  {
    for (const double azimuth : {0.0, 0.2, 90.0, 217.0, 359.9})
    {
      for (const double seconds : {-600.0, -30.0, 0.0, 250.0})
      {
        const ColumnDirection column = {
          static_cast<float>(azimuth), static_cast<float>(range / diameter)};
        const ColumnMotion motion = {
          static_cast<float>(15.0 / diameter), static_cast<float>(-9.0 / diameter)};
        const ColumnDirection moved = DirectionAt(column, motion, static_cast<float>(seconds));
        const double away = range + 15.0 * seconds;
        const double clockwise = -9.0 * seconds;
        EXPECT_GE(moved.azimuth, 0.0F);
        EXPECT_LT(moved.azimuth, 360.0F);
        EXPECT_NEAR(static_cast<double>(moved.halfTangent) * diameter / std::hypot(away, clockwise),
          1.0, 1e-6);
        const double turned = azimuth + std::atan2(clockwise, away) / RadiansPerDegree;
        EXPECT_WITHIN(AngleDifference(turned, static_cast<double>(moved.azimuth)), 0.0, 0.0026,
          "azimuth moved to, degrees");
      }
    }
  }
}
