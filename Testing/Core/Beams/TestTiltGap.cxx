// SPDX-License-Identifier: BSD-3-Clause
// Formulas G11: reflectivity between two tilts, against values worked out by hand.
#include "BeamScene.h"
#include "Tolerance.h"
#include "nexrad/Beams/TiltEdges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// A gap of equal width to the gaps beside it.
TiltEdges EvenEdges(float endShare = 0.5F)
{
  TiltEdges edges;
  edges.trendBelow = 0.25F;
  edges.trendAbove = 0.25F;
  edges.endShare = endShare;
  return edges;
}

TiltGapValues Echoes(float below, float lower, float upper, float above)
{
  TiltGapValues values;
  values.below = below;
  values.lower = lower;
  values.upper = upper;
  values.above = above;
  values.lowerEcho = lower > 0.0F;
  values.upperEcho = upper > 0.0F;
  return values;
}

const float notScanned = TiltGapValues().below;

} // namespace

// In the middle of even gaps the cubic through four points is (−v₀ + 9 v₁ + 9 v₂ − v₃) / 16.
TEST(TiltGap, IsTheCubicThroughFourTilts)
{
  const TiltInterpolation between(Echoes(10.0F, 30.0F, 36.0F, 20.0F), EvenEdges());
  EXPECT_FLOAT_EQ(between.At(0.0F), 30.0F);
  EXPECT_FLOAT_EQ(between.At(0.5F), (-10.0F + 9.0F * 30.0F + 9.0F * 36.0F - 20.0F) / 16.0F);
  EXPECT_FLOAT_EQ(between.At(1.0F), 36.0F);
}

TEST(TiltGap, IsStraightWhereTheTiltsBeyondContinueTheLineOrTellNothing)
{
  for (const TiltGapValues& values : {Echoes(10.0F, 20.0F, 20.0F, 30.0F),
         Echoes(notScanned, 20.0F, 30.0F, notScanned), Echoes(25.0F, 25.0F, 25.0F, 25.0F)})
  {
    const TiltInterpolation between(values, EvenEdges());
    for (const float share : {0.1F, 0.5F, 0.8F})
    {
      EXPECT_NEAR(between.At(share), values.lower + share * (values.upper - values.lower), 1e-5);
    }
  }
}

// Towards a tilt without echo, 0 dBZ is reached where G8 says; the tilts beyond bend that line.
TEST(TiltGap, EndsAnEchoBeforeTheTiltWithoutOne)
{
  const TiltInterpolation above(Echoes(notScanned, 40.0F, 0.0F, 0.0F), EvenEdges(0.8F));
  EXPECT_FLOAT_EQ(above.At(0.4F), 20.0F);
  EXPECT_NEAR(above.At(0.8F), 0.0F, 1e-5F);
  EXPECT_LT(above.At(0.9F), 0.0F);
  const TiltInterpolation below(Echoes(0.0F, 0.0F, 40.0F, notScanned), EvenEdges(0.8F));
  EXPECT_FLOAT_EQ(below.At(0.6F), 20.0F);
  EXPECT_NEAR(below.At(0.2F), 0.0F, 1e-5F);
  // An echo that weakens upwards ends lower than one that is as strong below.
  const TiltInterpolation weakening(Echoes(60.0F, 40.0F, 0.0F, 0.0F), EvenEdges(0.8F));
  EXPECT_FLOAT_EQ(weakening.At(0.4F), 20.0F - 0.25F * 20.0F * 0.4F * 0.6F);
}

// The cubic would bend below 0 dBZ there, and layers would be added to less than no echo.
TEST(TiltGap, IsNoEchoBetweenTwoTiltsWithoutOne)
{
  const TiltInterpolation between(Echoes(30.0F, 0.0F, 0.0F, -20.0F), EvenEdges());
  for (const float share : {0.25F, 0.5F, 0.75F})
  {
    EXPECT_EQ(between.At(share), 0.0F);
  }
}

TEST(TiltGap, TakesWhatIsMeasuredAlone)
{
  std::array<TiltSample, 4> samples;
  samples[0].state = VoxelState::NoEcho;
  samples[1].state = VoxelState::Echo;
  samples[1].value = 30.0F;
  samples[2].state = VoxelState::Echo;
  samples[2].value = 20.0F;
  samples[3].state = VoxelState::NoEcho;
  samples[3].assumed = true;
  const TiltGapValues values = ValuesAbout(samples.data(), samples.size(), 1);
  EXPECT_EQ(values.below, 0.0F);
  EXPECT_EQ(values.lower, 30.0F);
  EXPECT_EQ(values.upper, 20.0F);
  EXPECT_TRUE(std::isnan(values.above));
  samples[0].state = VoxelState::RangeFolded;
  EXPECT_TRUE(std::isnan(ValuesAbout(samples.data(), samples.size(), 1).below));
  EXPECT_TRUE(std::isnan(ValuesAbout(samples.data(), samples.size(), 0).below));
}

TEST(EchoLayers, AddChangesThatVanishAtTheTilts)
{
  const EchoLayers::Changes changes = {{0.0F, 4.0F, -2.0F, 6.0F, 0.0F}, 40.0F};
  EXPECT_FLOAT_EQ(changes.Apply(20.0F, 0.0F), 20.0F);
  EXPECT_FLOAT_EQ(changes.Apply(20.0F, 0.125F), 22.0F);
  EXPECT_FLOAT_EQ(changes.Apply(20.0F, 0.25F), 24.0F);
  EXPECT_FLOAT_EQ(changes.Apply(20.0F, 0.375F), 21.0F);
  EXPECT_FLOAT_EQ(changes.Apply(20.0F, 0.75F), 26.0F);
  EXPECT_FLOAT_EQ(changes.Apply(20.0F, 1.0F), 20.0F);
}

TEST(EchoLayers, RaiseNoEchoAboveTheStrongestAtEqualHeight)
{
  const EchoLayers::Changes changes = {{0.0F, 4.0F, -2.0F, 6.0F, 0.0F}, 22.0F};
  EXPECT_FLOAT_EQ(changes.Apply(20.0F, 0.25F), 22.0F);
  EXPECT_FLOAT_EQ(changes.Apply(25.0F, 0.25F), 25.0F) << "what is stronger already is left";
  EXPECT_FLOAT_EQ(changes.Apply(25.0F, 0.5F), 23.0F) << "and weakened where layers say so";
}

namespace
{

const std::vector<double> pattern21 = {0.5, 1.45, 2.4, 3.35, 4.3, 6.0, 9.9, 14.6, 19.5};

// Sweeps at those elevations, degrees, of a field of height and azimuth, dBZ; 0 or less is no echo.
template <class Field>
PolarVolume Scan(const Field& field, const std::vector<double>& elevations = pattern21)
{
  std::vector<NumberSweep> sweeps;
  int number = 0;
  const BeamModel beam;
  for (const double elevation : elevations)
  {
    NumberSweep sweep = UniformSweep(++number, elevation, 10.0F);
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
        const BeamPoint point = beam.Locate(range, elevation);
        const double value = field(point, sweep.rays[ray].azimuth);
        const std::size_t at = sweep.Index(ray, gate);
        sweep.values[at] = value > 0.0 ? static_cast<float>(value) : NAN;
        sweep.states[at] = value > 0.0 ? GateState::Valid : GateState::BelowThreshold;
      }
    }
    sweeps.push_back(std::move(sweep));
  }
  return VolumeOf(std::move(sweeps));
}

// Root of the mean square of what the merge makes of the field, from 30 to 120 km.
template <class Field>
double RmsErrorOf(const Field& field, bool trend)
{
  BeamMergeOptions options = AsMeasured();
  options.trend = trend;
  const GriddedVolume volume = MergeAt({Scan(field)}, 0.0, options);
  double squares = 0.0;
  std::size_t voxels = 0;
  const auto add = [&](const SeenVoxel& voxel)
  {
    const double height = BeamModel().HeightOver(voxel.groundDistance, voxel.elevation);
    const double truth = field({height, voxel.groundDistance}, voxel.azimuth);
    if (voxel.groundDistance > 30e3 && voxel.groundDistance < 120e3 && voxel.elevation > 0.6 &&
        voxel.elevation < 19.0)
    {
      const bool echo = volume.states[voxel.index] == VoxelState::Echo;
      const double value = echo ? std::max<double>(volume.values[voxel.index], 0.0) : 0.0;
      squares += (value - std::max(truth, 0.0)) * (value - std::max(truth, 0.0));
      ++voxels;
    }
  };
  ForEachVoxel(volume.grid, centralSite, add);
  return std::sqrt(squares / static_cast<double>(voxels));
}

} // namespace

// Formulas G12. A layer from 6 to 10 km, the same everywhere, as an anvil: between the tilts it is
// nearly what it is at the tilts.
TEST(EchoLayers, FollowALayerFromTiltToTilt)
{
  const auto layer = [](const BeamPoint& point, double)
  { return 30.0 - std::pow((point.height - 8000.0) / 500.0, 2.0); };
  const double linear = RmsErrorOf(layer, false);
  const double followed = RmsErrorOf(layer, true);
  std::printf("a layer: RMSE %.2f dBZ linear, %.2f dBZ followed\n", linear, followed);
  EXPECT_AT_MOST(
    followed / linear, 0.4, "RMSE of a followed layer, part of that of the linear interpolation");
}

// An echo of 30 dBZ that ends at 9 km, at tilts 5° apart as a terminal radar's pattern 90 has:
// where a tilt leaves the echo, nothing between the tilts becomes much stronger than the echo.
TEST(EchoLayers, MakeNoRingsWhereTiltsLeaveAnEcho)
{
  const auto block = [](const BeamPoint& point, double)
  { return point.height < 9000.0 ? 30.0 : 0.0; };
  BeamMergeOptions options = AsMeasured();
  options.trend = true;
  GridSpecification grid = SceneGrid();
  grid.spacing = {1000.0, 1000.0, 250.0};
  grid.origin = {-30'000.0, -30'000.0, 250.0};
  const PolarVolume scanned = Scan(block, {0.3, 1.0, 2.7, 6.0, 10.0, 15.0, 20.0, 25.0, 30.0});
  const GriddedVolume volume = MergeAt({scanned}, 0.0, options, grid);
  const float most = *std::max_element(volume.values.begin(), volume.values.end());
  std::printf("a block of 30 dBZ: at most %.2f dBZ\n", static_cast<double>(most));
  EXPECT_AT_MOST(most, 33.0, "strongest echo of a merge of 30 dBZ");
}

// Columns of echo 12 km wide, from the ground to 12 km: nothing is taken from beside them.
TEST(EchoLayers, LeaveColumnsOfEchoStandingStraight)
{
  const auto columns = [](const BeamPoint& point, double azimuth)
  {
    const double wave = std::sin(point.groundDistance / 4e3) * std::cos(azimuth / 6.0);
    return wave > 0.3 ? 45.0 - point.height / 400.0 : 0.0;
  };
  const double linear = RmsErrorOf(columns, false);
  const double followed = RmsErrorOf(columns, true);
  std::printf("columns: RMSE %.2f dBZ linear, %.2f dBZ followed\n", linear, followed);
  EXPECT_LE(followed, linear);
}

// Faint echo is no more frequent than in a linear interpolation: what layers add between two tilts
// without echo is known to half a decibel only.
TEST(EchoLayers, MakeNoFaintEchoOfNone)
{
  const auto layer = [](const BeamPoint& point, double azimuth)
  { return 12.0 + 8.0 * std::sin(azimuth / 9.0) - std::pow((point.height - 5000.0) / 400.0, 2.0); };
  const auto countFaint = [&layer](bool trend)
  {
    BeamMergeOptions options = AsMeasured();
    options.trend = trend;
    const GriddedVolume volume = MergeAt({Scan(layer)}, 0.0, options);
    std::size_t faint = 0;
    std::size_t echo = 0;
    for (std::size_t i = 0; i < volume.values.size(); ++i)
    {
      echo += volume.states[i] == VoxelState::Echo ? 1 : 0;
      faint += volume.states[i] == VoxelState::Echo && volume.values[i] <= 0.5F ? 1 : 0;
    }
    return static_cast<double>(faint) / static_cast<double>(echo);
  };
  const double linear = countFaint(false);
  const double followed = countFaint(true);
  std::printf("echo up to 0.5 dBZ: %.4f linear, %.4f followed\n", linear, followed);
  EXPECT_LT(followed, linear);
}

// No one cell decides: what is added is the same whatever the block, and nothing without echo.
TEST(EchoLayers, ChangeNothingWithoutEcho)
{
  const BeamVolume quiet =
    PrepareForGrid(Scan([](const BeamPoint&, double) { return -1.0; }), SceneGrid(), {});
  for (float azimuth = 0.5F; azimuth < 360.0F; azimuth += 10.0F)
  {
    EXPECT_EQ(quiet.layers->GapsAt({azimuth, 0.005F}), 0U);
  }
  EXPECT_AT_MOST(quiet.layers->MemoryBytes(), 500U, "memory without echo, bytes");
}
