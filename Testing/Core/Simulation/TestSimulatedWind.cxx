// SPDX-License-Identifier: BSD-3-Clause
// The wind of the synthetic day against its closed form, and the radial velocities that radars see
// of it.
#include "ScannedStorm.h"
#include "Tolerance.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/ScanStrategy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// Pattern 31 has the lowest Nyquist velocity, 11.6 m/s: most of its velocities are folded.
const TruthfulScan& Scanned(int pattern)
{
  static const TruthfulScan low = Scan({}, 31);
  static const TruthfulScan high = Scan({}, 212);
  return pattern == 31 ? low : high;
}

StormVortex Mesocyclone()
{
  StormVortex vortex;
  vortex.level = 1'000.0;
  vortex.tiltX = 0.3;
  vortex.widening = 0.15;
  vortex.rotation = {28.0, 3'500.0, 8'500.0};
  return vortex;
}

WindVector PartOf(const StormVortex& vortex, double east, double north, double height)
{
  const PlanePoint axis = vortex.AxisAt(height);
  WindVector wind;
  vortex.AddTo(wind, {axis.x + east, axis.y + north, height});
  return wind;
}

WindVector WindAt(const StormSnapshot& snapshot, const PlanePoint& place)
{
  WindVector wind = MeanWind(place.z);
  for (const StormVortex& vortex : snapshot.Vortices())
  {
    vortex.AddTo(wind, place);
  }
  return wind;
}

// The mean of the radial velocity over the beam by brute force, weighted with Z: directions on a
// fine square lattice over ±3 standard deviations of the pattern, five ranges in the gate.
double BruteForceVelocity(
  const StormSnapshot& snapshot, const Ray& ray, double range, double spacing)
{
  constexpr int half = 9;
  const Position site = *TestSite().position;
  const double sigma = 0.95 / std::sqrt(16.0 * std::log(2.0));
  const double step = 3.0 * sigma / half;
  double sum = 0.0;
  double weights = 0.0;
  BeamTrace trace(site, ray.elevation, range + spacing, {});
  for (int side = -half; side <= half; ++side)
  {
    const double azimuth = ray.azimuth + side * step / std::cos(ray.elevation * RadiansPerDegree);
    trace.Point(azimuth, ray.elevation);
    for (int up = -half; up <= half; ++up)
    {
      const double elevation = ray.elevation + up * step;
      const double pattern =
        std::exp(-0.5 * (up * up + side * side) * step * step / (sigma * sigma));
      for (int part = 0; part < 5; ++part)
      {
        const PlanePoint place =
          trace.Place(trace.At(range + spacing * ((part + 0.5) / 5.0 - 0.5), elevation));
        const double weight = pattern * std::pow(10.0, snapshot.Reflectivity(place) / 10.0);
        const WindVector wind = WindAt(snapshot, place);
        sum += weight * std::cos(elevation * RadiansPerDegree) *
               (wind.east * std::sin(azimuth * RadiansPerDegree) +
                 wind.north * std::cos(azimuth * RadiansPerDegree));
        weights += weight;
      }
    }
  }
  return sum / weights;
}

} // namespace

TEST(MeanWind, IsThatOfItsLevelsAndLinearBetweenThem)
{
  const std::vector<WindLevel>& levels = MeanWindLevels();
  for (const WindLevel& level : levels)
  {
    const WindVector wind = MeanWind(level.height);
    EXPECT_NEAR(std::hypot(wind.east, wind.north), level.speed, 1e-6) << level.height;
    const double from = std::atan2(-wind.east, -wind.north) / RadiansPerDegree;
    EXPECT_NEAR(std::remainder(from - level.direction, 360.0), 0.0, 1e-6) << level.height;
  }
  const WindVector below = MeanWind(6'000.0);
  const WindVector above = MeanWind(9'000.0);
  const WindVector between = MeanWind(7'200.0);
  EXPECT_NEAR(between.east, 0.6 * below.east + 0.4 * above.east, 1e-9);
  EXPECT_NEAR(between.north, 0.6 * below.north + 0.4 * above.north, 1e-9);
  EXPECT_NEAR(MeanWind(-50.0).north, MeanWind(0.0).north, 1e-6);
  EXPECT_NEAR(MeanWind(25'000.0).east, MeanWind(18'000.0).east, 1e-6);
}

TEST(StormVortex, TurnsAsASolidInItsCoreAndFallsOffOutside)
{
  const StormVortex vortex = Mesocyclone();
  for (const double height : {500.0, 1'000.0, 3'500.0, 7'000.0})
  {
    const double radius = vortex.RadiusAt(height);
    const double speed = vortex.rotation.At(height);
    EXPECT_NEAR(radius, 3'000.0 + 0.15 * (height - 1'000.0), 1e-9);
    const double left = 1.0 - std::pow((height - 3'500.0) / 8'500.0, 2.0);
    EXPECT_NEAR(speed, 28.0 * left * left, 1e-9);
    // The peak difference across the axis, and the turn: anticlockwise.
    EXPECT_NEAR(PartOf(vortex, radius, 0.0, height).north, speed, 1e-9);
    EXPECT_NEAR(PartOf(vortex, -radius, 0.0, height).north, -speed, 1e-9);
    EXPECT_NEAR(PartOf(vortex, 0.0, radius, height).east, -speed, 1e-9);
    // Half of it half-way to the axis; the same shear everywhere in the core.
    EXPECT_NEAR(PartOf(vortex, radius / 2.0, 0.0, height).north, speed / 2.0, 1e-9);
    EXPECT_NEAR(PartOf(vortex, 0.0, 0.0, height).north, 0.0, 1e-9);
    const double rest = radius / StormVortex::Reach;
    EXPECT_NEAR(PartOf(vortex, 3.0 * radius, 0.0, height).north,
      speed * (1.0 / 3.0 - rest) / (1.0 - rest), 1e-9);
    EXPECT_NEAR(PartOf(vortex, StormVortex::Reach - 1.0, 0.0, height).north, 0.0, 1e-3);
    EXPECT_EQ(PartOf(vortex, StormVortex::Reach + 1.0, 0.0, height).north, 0.0);
  }
  EXPECT_NEAR(vortex.AxisAt(6'000.0).x - vortex.AxisAt(1'000.0).x, 1'500.0, 1e-9);
}

TEST(StormVortex, ConvergesBelowAndDivergesAloft)
{
  StormVortex updraft;
  updraft.coreRadius = 5'000.0;
  updraft.inflow = {9.0, 500.0, 2'500.0};
  updraft.outflow = {22.0, 11'500.0, 3'500.0};
  EXPECT_NEAR(PartOf(updraft, 5'000.0, 0.0, 500.0).east, -9.0, 1e-9);
  EXPECT_NEAR(PartOf(updraft, 0.0, -5'000.0, 500.0).north, 9.0, 1e-9);
  EXPECT_NEAR(PartOf(updraft, 5'000.0, 0.0, 11'500.0).east, 22.0, 1e-9);
  EXPECT_NEAR(PartOf(updraft, 5'000.0, 0.0, 5'000.0).east, 0.0, 1e-9);
  // The divergence in the core is 2·speed/radius.
  const double divergence =
    (PartOf(updraft, 1'000.0, 0.0, 11'500.0).east - PartOf(updraft, -1'000.0, 0.0, 11'500.0).east +
      PartOf(updraft, 0.0, 1'000.0, 11'500.0).north -
      PartOf(updraft, 0.0, -1'000.0, 11'500.0).north) /
    2'000.0;
  EXPECT_NEAR(divergence, 2.0 * 22.0 / 5'000.0, 1e-12);
  EXPECT_TRUE(updraft.Touches({20'000.0, 0.0, 100.0, 0.0, 200.0}, StormVortex::Reach));
  EXPECT_FALSE(updraft.Touches({20'000.0, 0.0, 100.0, 4'000.0, 6'000.0}, StormVortex::Reach));
  EXPECT_FALSE(updraft.Touches({20'000.0, 0.0, 100.0, 0.0, 200.0}, 10'000.0));
}

TEST(FoldVelocity, TakesAwayWholeNyquistIntervals)
{
  EXPECT_NEAR(FoldVelocity(20.0, 25.0), 20.0, 1e-12);
  EXPECT_NEAR(FoldVelocity(30.0, 25.0), -20.0, 1e-12);
  EXPECT_NEAR(FoldVelocity(-30.0, 25.0), 20.0, 1e-12);
  for (double velocity = -90.0; velocity < 90.0; velocity += 0.7)
  {
    const double folded = FoldVelocity(velocity, 11.5);
    EXPECT_LE(std::abs(folded), 11.5);
    const double intervals = (velocity - folded) / 23.0;
    EXPECT_NEAR(intervals, std::round(intervals), 1e-9);
  }
}

// The quadrature against a dense summation, where the beam meets storms.
TEST(VelocitySampler, IsTheMeanOverTheBeamWeightedWithZ)
{
  const StormSnapshot snapshot = StormField().At(start);
  const std::vector<StormVortex>& vortices = snapshot.Vortices();
  double squares = 0.0;
  double largest = 0.0;
  int count = 0;
  for (const double elevation : {0.483, 1.45, 4.307})
  {
    BeamSampler beam(*TestSite().position, elevation, 240'000.0, {});
    Ray ray;
    ray.elevation = static_cast<float>(elevation);
    for (double azimuth = 3.0; azimuth < 360.0; azimuth += 9.0)
    {
      ray.azimuth = static_cast<float>(azimuth);
      beam.Point(ray.azimuth, ray.elevation);
      std::vector<double> reflectivity;
      beam.Sample(snapshot, {880, 2'125, 250}, reflectivity);
      VelocitySampler wind(beam.Trace(), snapshot);
      for (std::size_t gate = 20; gate < reflectivity.size(); gate += 40)
      {
        if (reflectivity[gate] > 5.0)
        {
          const double range = 2'125.0 + 250.0 * static_cast<double>(gate);
          const double error = wind.Sample(range, beam.Spreads()[gate]).mean -
                               BruteForceVelocity(snapshot, ray, range, 250.0);
          squares += error * error;
          largest = std::max(largest, std::abs(error));
          ++count;
        }
      }
    }
  }
  ASSERT_FALSE(vortices.empty());
  ASSERT_AT_LEAST(count, 250, "gates compared");
  EXPECT_AT_MOST(std::sqrt(squares / count), 0.35, "error of the radial velocity, RMS, m/s");
  EXPECT_AT_MOST(largest, 1.8, "error of the radial velocity, largest, m/s");
}

TEST(ScanTruth, WordsAreTheTruthWithNoiseFolded)
{
  for (const int pattern : {31, 212})
  {
    const TruthfulScan& scan = Scanned(pattern);
    ASSERT_EQ(scan.truth.sweeps.size(), scan.volume.sweeps.size());
    double squares = 0.0;
    std::size_t count = 0;
    std::size_t folded = 0;
    for (std::size_t cut = 0; cut < scan.volume.sweeps.size(); ++cut)
    {
      const Sweep& sweep = scan.volume.sweeps[cut];
      ASSERT_EQ(scan.truth.sweeps[cut].size(), sweep.rays.size());
      for (std::size_t index = 0; index < sweep.rays.size(); ++index)
      {
        const Ray& ray = sweep.rays[index];
        const MomentRow& row = ray.Row(MomentName::VEL);
        const std::vector<float>& truth = scan.truth.sweeps[cut][index].velocity;
        ASSERT_EQ(truth.size(), row.gates);
        for (std::size_t gate = 0; gate < truth.size(); ++gate)
        {
          ASSERT_EQ(std::isfinite(truth[gate]), row.State(gate) == GateState::Valid);
          if (std::isfinite(truth[gate]))
          {
            ASSERT_LE(std::abs(row.Value(gate)), ray.nyquist + 0.5F);
            const double error = std::remainder(row.Value(gate) - truth[gate], 2.0 * ray.nyquist);
            ASSERT_AT_MOST(std::abs(error), 4.5, "largest noise of velocities, m/s");
            squares += error * error;
            folded += std::abs(truth[gate]) > ray.nyquist ? 1 : 0;
            ++count;
          }
        }
      }
    }
    const double share = static_cast<double>(folded) / static_cast<double>(count);
    std::printf("pattern %d: %zu velocities, %.1f %% folded\n", pattern, count, 100.0 * share);
    ASSERT_AT_LEAST(count, 300'000U, "velocities compared");
    EXPECT_WITHIN(std::sqrt(squares / static_cast<double>(count)), 1.2, 0.014,
      "standard deviation of the noise of velocities, m/s");
    if (pattern == 31)
    {
      EXPECT_AT_LEAST(share, 0.3, "share of folded velocities at 11.6 m/s");
    }
  }
}

TEST(ScanTruth, IsWhatTrueRadialVelocityGives)
{
  const TruthfulScan& scan = Scanned(31);
  const StormField field;
  int count = 0;
  for (const std::size_t cut : {1U, 7U})
  {
    const Sweep& sweep = scan.volume.sweeps[cut];
    for (std::size_t index = 5; index < sweep.rays.size(); index += 61)
    {
      const Ray& ray = sweep.rays[index];
      const MomentRow& row = ray.Row(MomentName::VEL);
      const std::vector<float>& truth = scan.truth.sweeps[cut][index].velocity;
      for (std::size_t gate = 20; gate < truth.size(); gate += 97)
      {
        if (std::isfinite(truth[gate]))
        {
          const double range = row.firstGate + double(row.gateSpacing) * static_cast<double>(gate);
          const double velocity = TrueRadialVelocity(field, *TestSite().position, ray.time,
            ray.azimuth, ray.elevation, range, row.gateSpacing);
          EXPECT_WITHIN(velocity, truth[gate], 0.1, "truth of one gate against the scan's, m/s");
          ++count;
        }
      }
    }
  }
  EXPECT_AT_LEAST(count, 25, "gates compared");
}

TEST(ScanTruth, LeavesTheVolumeAsItIs)
{
  const RadarVolume without = ScanVolume(StormField(), TestSite(), 31, start);
  const RadarVolume& with = Scanned(31).volume;
  ASSERT_EQ(without.buffers.size(), with.buffers.size());
  EXPECT_TRUE(std::equal(without.buffers.begin(), without.buffers.end(), with.buffers.begin(),
    [](const auto& one, const auto& other) { return *one == *other; }));
}

// A radar beside the storm sees the mesocyclone: outbound and inbound on its two sides, twice the
// speed apart. The beam's middle runs through the axis at 2 to 3 km of height.
TEST(ScanTruth, ARadarSeesTheVortexWithItsPeakDifference)
{
  const StormField field;
  const StormSnapshot snapshot = field.At(start);
  int seen = 0;
  for (const StormVortex& vortex : snapshot.Vortices())
  {
    const double height = 2'500.0;
    if (vortex.rotation.At(height) < 15.0)
    {
      continue;
    }
    // A made-up site 40 km south of the axis.
    const PlanePoint axis = vortex.AxisAt(height);
    Position site{39.0 + (axis.y - 40'000.0) / (6'371'000.0 * RadiansPerDegree),
      -91.5 + axis.x / (6'371'000.0 * RadiansPerDegree * std::cos(39.0 * RadiansPerDegree)), 100.0};
    const double elevation = std::atan2(height - 100.0 - 94.0, 40'000.0) / RadiansPerDegree;
    double most = -1e9;
    double least = 1e9;
    for (double offset = -6'000.0; offset <= 6'000.0; offset += 250.0)
    {
      const double azimuth = std::atan2(offset, 40'000.0) / RadiansPerDegree;
      const double environment = std::cos(elevation * RadiansPerDegree) *
                                 (MeanWind(height).east * std::sin(azimuth * RadiansPerDegree) +
                                   MeanWind(height).north * std::cos(azimuth * RadiansPerDegree));
      const double velocity = TrueRadialVelocity(field, site, start, azimuth, elevation,
                                std::hypot(40'000.0, offset), 250.0) -
                              environment;
      most = std::max(most, velocity);
      least = std::min(least, velocity);
    }
    // The beam of 0.95° is 0.66 km wide: it takes little from the peaks.
    EXPECT_AT_LEAST((most - least) / (2.0 * vortex.rotation.At(height)), 0.85,
      "peak difference, part of the vortex's");
    EXPECT_AT_MOST((most - least) / (2.0 * vortex.rotation.At(height)), 1.0,
      "peak difference, part of the vortex's");
    ++seen;
  }
  EXPECT_AT_LEAST(seen, 8, "vortices");
}

TEST(SpectrumWidth, GrowsWithTheShearInTheBeam)
{
  // Upright shear of the mean wind: 0.483° at 180 km meets several km of height.
  const StormSnapshot calm({}, {}, 0.0);
  BeamSampler beam(*TestSite().position, 0.483, 240'000.0, {});
  beam.Point(60.0, 0.483);
  VelocitySampler wind(beam.Trace(), calm);
  const double near = wind.Sample(20'000.0, {}).deviation;
  const double far = wind.Sample(180'000.0, {}).deviation;
  // Standard deviation of the pattern times the shear, 0.29° · 180 km · some 0.005 per second.
  EXPECT_WITHIN(near, 0.6, 0.15, "deviation within the beam at 20 km, m/s");
  EXPECT_WITHIN(far, 4.0, 0.6, "deviation within the beam at 180 km, m/s");
}
