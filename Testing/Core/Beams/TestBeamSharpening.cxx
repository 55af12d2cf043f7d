// SPDX-License-Identifier: BSD-3-Clause
// Formulas G9, against the mean over the beam by brute force.
#include "BeamScene.h"
#include "Tolerance.h"
#include "nexrad/Beams/BeamSharpening.h"
#include "nexrad/Beams/BeamVolume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double beamWidth = 0.95; // degrees

// What a tilt holds; without it nothing is known there.
struct TiltEcho
{
  bool isThere = false;
  std::optional<float> value; // dBZ; empty: no echo
};

TiltEcho Echo(double value)
{
  return {true, static_cast<float>(value)};
}

TiltEcho NoEcho()
{
  return {true, {}};
}

const TiltEcho unknown;

// The value of the tilt in the middle of three, each of one value. It is rounded to half a step of
// the scale: 15 dB in at most 65 532 steps of a power of two.
double SharpenedBetween(
  double gapBelow, const TiltEcho& below, double value, const TiltEcho& above, double gapAbove)
{
  constexpr double elevation = 3.0;
  std::vector<NumberSweep> sweeps;
  const auto add = [&sweeps](double angle, const TiltEcho& echo)
  {
    if (echo.isThere)
    {
      sweeps.push_back(MakeSweep(1, angle, 360, 10));
    }
    if (echo.value)
    {
      SetAll(sweeps.back(), *echo.value);
    }
  };
  add(elevation, Echo(value));
  add(elevation - gapBelow, below);
  add(elevation + gapAbove, above);
  BeamVolume prepared = PrepareBeamVolume(VolumeOf(sweeps), beamWidth);
  SharpenSweeps(prepared.sweeps, beamWidth, BeamModel());
  const BeamSweep& middle = prepared.sweeps.front();
  return static_cast<double>(middle.scale.ValueOf(middle.Row(5)[5]));
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
  for (const double slope : {-14.0, -6.0, 6.0, 14.0}) // dB a degree
  {
    const auto truth = [slope](double elevation) { return 35.0 + slope * elevation; };
    const auto measured = [&truth](double elevation)
    { return MeanOverBeam([&](double angle) { return truth(elevation + angle); }); };
    for (const double gap : {0.9, 1.0, 1.7})
    {
      EXPECT_NEAR(
        SharpenedBetween(gap, Echo(measured(-gap)), measured(0.0), Echo(measured(gap)), gap),
        truth(0.0), 0.0015)
        << slope;
    }
  }
  // By hand: 11.418 dB a degree over a standard deviation of 0.95/√(16 ln 2) = 0.28527° is 0.75
  // e-folds of Z, and exp(s²/2) of it 1.22145 dB.
  EXPECT_NEAR(SharpenedBetween(1.0, Echo(41.418), 30.0, Echo(18.582), 1.0), 30.0 - 1.22145, 1e-4);
}

// Whatever stands on the two sides; towards no echo the line of G8, which ends half a beam before
// the tilt without, and not before the middle.
TEST(BeamSharpening, TakesBackTheMeanOverTwoStraightSides)
{
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
        const double got = SharpenedBetween(0.95, noneBelow ? NoEcho() : Echo(lower), value,
          noneAbove ? NoEcho() : Echo(upper), 1.65);
        EXPECT_WITHIN(
          got, value - std::max(excess, -3.0), 0.003, "difference to the mean over the beam, dB")
          << lower << " " << upper;
      }
    }
  }
}

TEST(BeamSharpening, HasLimits)
{
  // What one tilt alone sees fills half the beam.
  EXPECT_NEAR(SharpenedBetween(1.0, NoEcho(), 50.0, NoEcho(), 1.0), 53.0, 1e-4);
  // When one side is not known, nothing is said of how the beam is filled.
  EXPECT_EQ(SharpenedBetween(1.0, unknown, 50.0, NoEcho(), 1.0), 50.0);
  EXPECT_EQ(SharpenedBetween(1.0, Echo(50.0), 50.0, unknown, 1.0), 50.0);
  // An echo more than two standard deviations away is not seen: exp(2)·Φ(2) is 7.221. On the other
  // side, 20 dB lost over 0.525° are 2.503 e-folds over a standard deviation, and exp(2.503²/2)·
  // Φ(−2.503) is 0.141. The sum is 8.670 dB.
  EXPECT_NEAR(SharpenedBetween(1.0, Echo(70.0), 20.0, NoEcho(), 1.0), 20.0 - 8.670, 0.001);
  // Constant echo stays as it is to the last digit.
  EXPECT_EQ(SharpenedBetween(1.0, Echo(33.5), 33.5, Echo(33.5), 1.0), 33.5);
}

// The sweeps of a volume: each by its neighbours in elevation, of repeated cuts the nearest in
// time.
TEST(BeamSharpening, ChangesEachSweepByItsNeighbours)
{
  PolarVolume volume = VolumeOf({UniformSweep(1, 1.0, 40.0F), UniformSweep(2, 2.0, 30.0F),
    UniformSweep(3, 3.0, 20.0F), UniformSweep(4, 1.0, 60.0F, 200.0)});
  const auto valueOf = [](const BeamVolume& prepared, std::size_t sweep, std::size_t gate)
  {
    const BeamSweep& of = prepared.sweeps[sweep];
    return of.scale.ValueOf(of.Row(5)[gate]);
  };
  const auto sharpen = [](const PolarVolume& polar)
  {
    BeamVolume prepared = PrepareBeamVolume(polar, beamWidth);
    SharpenSweeps(prepared.sweeps, beamWidth, BeamModel());
    return prepared;
  };
  const BeamVolume measured = PrepareBeamVolume(volume, beamWidth);
  const BeamVolume sharpened = sharpen(volume);
  EXPECT_EQ(valueOf(measured, 1, 50), 30.0F);
  // To half a step of the scale: 15 dB in at most 65 532 steps of a power of two.
  EXPECT_NEAR(valueOf(sharpened, 1, 50), 30.0 - 0.9369, 1.3e-4);
  // Echo of 0 dBZ and less is left as it is.
  ChangeGates(volume.sweeps[1], [](NumberSweep& sweep) { SetAll(sweep, -2.0F); });
  EXPECT_EQ(valueOf(sharpen(volume), 1, 50), -2.0F);
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
    EXPECT_EQ(merged.sharpened, expected == 29.06F) << "maps say so";
    std::size_t voxels = 0;
    const auto check = [&](const SeenVoxel& voxel)
    {
      if (voxel.groundDistance > 5'000.0 && voxel.groundDistance < 200'000.0 &&
          std::abs(voxel.elevation - 2.0) < 0.01)
      {
        ASSERT_WITHIN(merged.values[voxel.index], expected, 0.4, "difference to the formula, dB");
        ++voxels;
      }
    };
    ForEachVoxel(merged.grid, centralSite, check);
    EXPECT_AT_LEAST(voxels, 400u, "voxels compared");
  };
  expectAtTheMiddleTilt(volumeOf(MomentName::REF), {}, 29.06F);
  expectAtTheMiddleTilt(volumeOf(MomentName::ZDR), {}, 30.0F);
  expectAtTheMiddleTilt(volumeOf(MomentName::REF), AsMeasured(), 30.0F);
  BeamMergeOptions linear;
  linear.linearReflectivity = true;
  expectAtTheMiddleTilt(volumeOf(MomentName::REF), linear, 30.0F);
}
