// SPDX-License-Identifier: BSD-3-Clause
// Formulas G9, against the mean over the beam by brute force.
#include "BeamScene.h"
#include "Geometry/Angles.h"
#include "Gridding/BeamSharpening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double beamWidth = 0.95; // degrees

std::vector<TiltEdges> EdgesOf(const std::vector<double>& elevations)
{
  std::vector<BeamTilt> tilts;
  for (const double elevation : elevations)
  {
    BeamTilt tilt;
    tilt.elevation = static_cast<float>(elevation);
    tilt.tangent = static_cast<float>(std::tan(elevation * RadiansPerDegree));
    tilts.push_back(tilt);
  }
  return FindEdges(tilts, beamWidth, true);
}

TiltSample Echo(double value)
{
  TiltSample sample;
  sample.state = VoxelState::Echo;
  sample.value = static_cast<float>(value);
  sample.fade = 1.0F;
  return sample;
}

TiltSample Without(VoxelState state)
{
  TiltSample sample;
  sample.state = state;
  sample.fade = 1.0F;
  return sample;
}

double SharpenedAt(
  std::size_t tilt, const std::vector<double>& elevations, const std::vector<TiltSample>& samples)
{
  std::vector<TiltSample> sharpened;
  const bool changed = SharpenTilts(EdgesOf(elevations), samples.data(), sharpened);
  return static_cast<double>(changed ? sharpened[tilt].value : samples[tilt].value);
}

// What a radar measures of a profile in dBZ over the angle from the middle of its beam: Z weighted
// with the square of a pattern that is half at half the beam width.
double MeanOverBeam(const std::function<double(double)>& profile)
{
  double sum = 0.0;
  double weights = 0.0;
  for (double angle = -2.0; angle <= 2.0; angle += 0.001)
  {
    const double oneWay = std::exp2(-std::pow(angle / (0.5 * beamWidth), 2.0));
    sum += oneWay * oneWay * std::pow(10.0, profile(angle) / 10.0);
    weights += oneWay * oneWay;
  }
  return 10.0 * std::log10(sum / weights);
}

} // namespace

TEST(BeamSharpening, AStraightSlopeComesOutAsItWasBeforeTheBeam)
{
  const std::vector<double> elevations = {0.5, 1.5, 2.4, 3.4, 4.3};
  for (const double slope : {-14.0, -6.0, 6.0, 14.0}) // dB a degree
  {
    const auto truth = [slope](double elevation) { return 35.0 + slope * (elevation - 2.4); };
    std::vector<TiltSample> samples;
    for (const double elevation : elevations)
    {
      samples.push_back(Echo(MeanOverBeam([&](double angle) { return truth(elevation + angle); })));
    }
    for (std::size_t tilt = 1; tilt + 1 < elevations.size(); ++tilt)
    {
      EXPECT_NEAR(SharpenedAt(tilt, elevations, samples), truth(elevations[tilt]), 0.02) << slope;
    }
  }
  // By hand: 10 dB a degree over a standard deviation of 0.95/√(16 ln 2) = 0.28527° is 0.65686
  // e-folds of Z, and exp(s²/2) of it 0.9369 dB.
  EXPECT_NEAR(
    SharpenedAt(1, {1.0, 2.0, 3.0}, {Echo(40.0), Echo(30.0), Echo(20.0)}), 30.0 - 0.937, 0.005);
}

// Whatever stands on the two sides; towards no echo the line of G8, which ends half a beam before
// the tilt without, and not before the middle.
TEST(BeamSharpening, TakesBackTheMeanOverTwoStraightSides)
{
  const std::vector<double> elevations = {0.5, 1.45, 3.1};
  const double toLower = 0.95 * std::max(0.5, 1.0 - 0.475 / 0.95);
  const double toUpper = 1.65 * (1.0 - 0.475 / 1.65);
  for (const double value : {5.0, 22.0, 38.0})
  {
    for (const double lower : {-1.0, 3.0, 20.0, 45.0})
    {
      for (const double upper : {-1.0, 8.0, 30.0, 50.0})
      {
        const bool noneBelow = lower < 0.0;
        const bool noneAbove = upper < 0.0;
        const double below = noneBelow ? -value / toLower : (lower - value) / 0.95;
        const double above = noneAbove ? -value / toUpper : (upper - value) / 1.65;
        if (std::max(below, above) > 30.0 || std::min(below, above) < -90.0)
        {
          continue; // beyond the limits of the row
        }
        const double excess =
          MeanOverBeam([&](double angle) { return angle < 0.0 ? -below * angle : above * angle; });
        const double got = SharpenedAt(1, elevations,
          {noneBelow ? Without(VoxelState::NoEcho) : Echo(lower), Echo(value),
            noneAbove ? Without(VoxelState::NoEcho) : Echo(upper)});
        EXPECT_NEAR(got, value - std::max(excess, -3.0), 0.03) << lower << " " << upper;
      }
    }
  }
}

TEST(BeamSharpening, HasLimits)
{
  const std::vector<double> elevations = {1.0, 2.0, 3.0};
  const TiltSample none = Without(VoxelState::NoEcho);
  // What one tilt alone sees fills half the beam.
  EXPECT_NEAR(SharpenedAt(1, elevations, {none, Echo(50.0), none}), 53.0, 1e-4);
  // When one side is not known, nothing is said of how the beam is filled.
  for (const VoxelState unknown : {VoxelState::NotScanned, VoxelState::RangeFolded})
  {
    EXPECT_EQ(SharpenedAt(1, elevations, {Without(unknown), Echo(50.0), none}), 50.0);
  }
  TiltSample assumed = none;
  assumed.assumed = true;
  EXPECT_EQ(SharpenedAt(1, elevations, {Echo(50.0), Echo(50.0), assumed}), 50.0);
  EXPECT_EQ(SharpenedAt(0, elevations, {Echo(50.0), none, none}), 50.0);
  EXPECT_EQ(SharpenedAt(2, elevations, {none, none, Echo(50.0)}), 50.0);
  // A neighbour that fades away takes its part of the slope and of the gain with it.
  TiltSample fading = none;
  fading.fade = 1e-4F;
  EXPECT_NEAR(SharpenedAt(1, elevations, {Echo(50.0), Echo(50.0), fading}), 50.0, 1e-2);
  EXPECT_NEAR(SharpenedAt(1, elevations, {none, Echo(50.0), fading}), 50.0, 1e-2);
  // An echo more than two standard deviations away is not seen: exp(2)·Φ(2) is 8.585 dB.
  EXPECT_NEAR(SharpenedAt(1, elevations, {Echo(70.0), Echo(20.0), none}), 20.0 - 8.7, 0.15);
  // Constant echo stays as it is to the last digit, and what is no more than 0 dBZ does.
  EXPECT_EQ(SharpenedAt(1, elevations, {Echo(33.5), Echo(33.5), Echo(33.5)}), 33.5);
  EXPECT_EQ(SharpenedAt(1, elevations, {Echo(30.0), Echo(-2.0), none}), -2.0);
}

// In the merge: the tilts' values are the sharpened ones, of reflectivity in dBZ, when asked for.
TEST(BeamSharpening, IsForReflectivityInDecibels)
{
  const auto volumeOf = [](MomentName moment)
  {
    PolarVolume volume = VolumeOf(
      {UniformSweep(1, 1.0, 40.0F), UniformSweep(2, 2.0, 30.0F), UniformSweep(3, 3.0, 20.0F)});
    volume.moment = moment;
    return volume;
  };
  const auto expectAtTheMiddleTilt =
    [](const PolarVolume& volume, const BeamMergeOptions& options, float expected)
  {
    const GriddedVolume merged = MergeAt({volume}, 0.0, options);
    std::size_t voxels = 0;
    const auto check = [&](const SeenVoxel& voxel)
    {
      if (voxel.groundDistance > 5'000.0 && voxel.groundDistance < 200'000.0 &&
          std::abs(voxel.elevation - 2.0) < 0.01)
      {
        ASSERT_NEAR(merged.values[voxel.index], expected, 0.4);
        ++voxels;
      }
    };
    ForEachVoxel(merged.grid, centralSite, check);
    EXPECT_GT(voxels, 100u);
  };
  expectAtTheMiddleTilt(volumeOf(MomentName::REF), {}, 29.06F);
  expectAtTheMiddleTilt(volumeOf(MomentName::ZDR), {}, 30.0F);
  expectAtTheMiddleTilt(volumeOf(MomentName::REF), AsMeasured(), 30.0F);
  BeamMergeOptions linear;
  linear.linearReflectivity = true;
  expectAtTheMiddleTilt(volumeOf(MomentName::REF), linear, 30.0F);
}
