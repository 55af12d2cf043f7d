// SPDX-License-Identifier: BSD-3-Clause
// Formulas V1 to V4 against SYNTHETIC winds that are known at each gate: the folds that are found,
// the gates left without one, and a vortex whose jump is near twice the Nyquist velocity.
#include "FoldScore.h"
#include "Tolerance.h"
#include "VelocityScan.h"
#include "nexrad/Velocity/Dealiasing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

Wind UniformWind(const PlaceOverRadar&)
{
  return WindFrom(240.0, 40.0);
}

// From 10 m/s at the ground to 60 m/s at 10 km, turning from south to west.
Wind ShearedWind(const PlaceOverRadar& place)
{
  const double share = std::clamp(place.height / 10'000.0, 0.0, 1.0);
  return WindFrom(180.0 + 80.0 * share, 10.0 + 50.0 * share);
}

// Storms of 24 km across and 14 km high, 30 km apart: no sweep is connected.
bool IsInStorm(const PlaceOverRadar& place)
{
  const double east = std::remainder(place.east, 30'000.0);
  const double north = std::remainder(place.north, 30'000.0);
  return std::hypot(east, north) < 12'000.0 && place.height < 14'000.0;
}

// A vortex 40 km north of the radar, whose wind is fastest `radius` m from its centre.
constexpr double vortexNorth = 40'000.0;
Wind VortexWind(const PlaceOverRadar& place, double fastest, double radius)
{
  const double east = place.east;
  const double north = place.north - vortexNorth;
  const double distance = std::max(1.0, std::hypot(east, north));
  const double speed =
    distance < radius ? fastest * distance / radius : fastest * radius / distance;
  return {5.0 - speed * north / distance, 8.0 + speed * east / distance};
}

FoldScore ScoreOf(const VelocityScan& scan, float nyquist, const DealiasOptions& options = {})
{
  const VelocityVolume truth = ScanVelocities(scan);
  VelocityVolume volume = FoldedAt(truth, nyquist);
  Dealias(volume, options);
  return CompareFolds(truth, volume);
}

void ExpectAllRight(const FoldScore& score)
{
  EXPECT_EQ(score.wrong, 0u);
  EXPECT_EQ(score.unknown, 0u);
}

double LargestDifference(const VelocitySweep& sweep)
{
  float least = 1000.0F;
  float most = -1000.0F;
  for (const float value : sweep.values)
  {
    least = value < least ? value : least;
    most = value > most ? value : most;
  }
  return static_cast<double>(most - least);
}

} // namespace

TEST(Dealiasing, LeavesVelocitiesThatAreNotFolded)
{
  VelocityScan scan;
  scan.wind = [](const PlaceOverRadar&) { return WindFrom(200.0, 12.0); };
  const VelocityVolume truth = ScanVelocities(scan);
  VelocityVolume volume = FoldedAt(truth, 30.0F);
  const DealiasCounts counts = Dealias(volume);
  EXPECT_EQ(counts.measured, 9u * 360u * 400u);
  EXPECT_EQ(counts.unfolded, 0u);
  EXPECT_EQ(counts.unknown, 0u);
  EXPECT_EQ(CompareFolds(truth, volume).wrong, 0u);
}

TEST(Dealiasing, UnfoldsAUniformWind)
{
  VelocityScan scan;
  scan.wind = UniformWind;
  for (const float nyquist : {12.0F, 16.0F, 25.0F})
  {
    SCOPED_TRACE(nyquist);
    ExpectAllRight(ScoreOf(scan, nyquist));
  }
}

TEST(Dealiasing, UnfoldsAShearedProfile)
{
  VelocityScan scan;
  scan.wind = ShearedWind;
  for (const float nyquist : {12.0F, 25.0F})
  {
    SCOPED_TRACE(nyquist);
    ExpectAllRight(ScoreOf(scan, nyquist));
  }
}

// The whole fold of each storm follows from the wind profile of all sweeps.
TEST(Dealiasing, UnfoldsStormsThatAreNotConnected)
{
  VelocityScan scan;
  scan.wind = ShearedWind;
  scan.echo = IsInStorm;
  for (const float nyquist : {12.0F, 25.0F})
  {
    SCOPED_TRACE(nyquist);
    ExpectAllRight(ScoreOf(scan, nyquist));
  }
}

// Noise of a fifth of the Nyquist velocity.
TEST(Dealiasing, BearsNoise)
{
  VelocityScan scan;
  scan.wind = ShearedWind;
  scan.echo = IsInStorm;
  scan.noise = 2.5;
  const FoldScore score = ScoreOf(scan, 12.0F);
  EXPECT_EQ(score.wrong, 0u);
  EXPECT_AT_MOST(score.UnknownShare(), 0.44, "gates without a fold, %");
}

// Two sides of a tornado are neighbours with a true jump near twice the Nyquist velocity. The
// largest and the least velocity differ by 35 m/s in the narrowest vortex and by 86 m/s in the
// strongest.
TEST(Dealiasing, KeepsAVortex)
{
  struct Vortex
  {
    double radius;  // m
    double fastest; // m/s
  };
  for (const Vortex& vortex : {Vortex{300.0, 30.0}, Vortex{300.0, 35.0}, Vortex{400.0, 45.0},
         Vortex{500.0, 45.0}, Vortex{1'500.0, 25.0}, Vortex{1'500.0, 45.0}})
  {
    SCOPED_TRACE(std::to_string(vortex.radius) + " m, " + std::to_string(vortex.fastest) + " m/s");
    VelocityScan scan;
    scan.elevations = {0.5, 1.5, 2.4};
    scan.rays = 720;
    scan.gates = 320;
    scan.noise = 0.5;
    scan.wind = [&](const PlaceOverRadar& place)
    { return VortexWind(place, vortex.fastest, vortex.radius); };
    const VelocityVolume truth = ScanVelocities(scan);
    VelocityVolume volume = FoldedAt(truth, 25.0F);
    Dealias(volume);
    ExpectAllRight(CompareFolds(truth, volume));
    for (std::size_t sweep = 0; sweep < truth.sweeps.size(); ++sweep)
    {
      EXPECT_NEAR(
        LargestDifference(volume.sweeps[sweep]), LargestDifference(truth.sweeps[sweep]), 0.01);
    }
  }
}

// Up to three Nyquist velocities in one cut.
TEST(Dealiasing, UsesTheNyquistVelocityOfEachRay)
{
  VelocityScan scan;
  scan.wind = UniformWind;
  const VelocityVolume truth = ScanVelocities(scan);
  VelocityVolume volume = truth;
  for (VelocitySweep& sweep : volume.sweeps)
  {
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      const float nyquist = ray < 120 ? 22.0F : ray < 250 ? 25.0F : 28.0F;
      sweep.rays[ray].nyquist = nyquist;
      for (std::size_t gate = 0; gate < sweep.gates; ++gate)
      {
        float& value = sweep.values[sweep.Index(ray, gate)];
        value = std::remainder(value, 2.0F * nyquist);
      }
    }
  }
  Dealias(volume);
  ExpectAllRight(CompareFolds(truth, volume));
}

TEST(Dealiasing, LeavesRaysWithoutANyquistVelocity)
{
  VelocityScan scan;
  scan.wind = UniformWind;
  const VelocityVolume truth = ScanVelocities(scan);
  VelocityVolume volume = truth;
  const DealiasCounts counts = Dealias(volume);
  EXPECT_EQ(counts.measured, 9u * 360u * 400u) << "they are counted";
  EXPECT_EQ(counts.unfolded + counts.unknown, 0u);
  EXPECT_EQ(std::memcmp(volume.sweeps[0].values.data(), truth.sweeps[0].values.data(),
              truth.sweeps[0].values.size() * sizeof(float)),
    0);
}

// One storm seen from one side can have several winds; a sounding tells which.
TEST(Dealiasing, FollowsAGivenWind)
{
  VelocityScan scan;
  scan.elevations = {0.5};
  scan.wind = UniformWind;
  scan.echo = [](const PlaceOverRadar& place)
  { return std::hypot(place.east - 50'000.0, place.north - 30'000.0) < 8'000.0; };
  DealiasOptions options;
  options.wind.levels = {{0.0, WindFrom(240.0, 38.0)}, {1500.0, WindFrom(240.0, 42.0)}};
  ExpectAllRight(ScoreOf(scan, 12.0F, options));
  // The profile of the volume before serves where the volume has none.
  DealiasOptions before;
  before.before = options.wind;
  ExpectAllRight(ScoreOf(scan, 12.0F, before));
}

// Formulas V4: of two storms without any wind profile, the smaller one has no fold.
TEST(Dealiasing, LeavesUnknownWhatNothingDecides)
{
  VelocityScan scan;
  scan.elevations = {0.5};
  scan.wind = UniformWind;
  scan.echo = [](const PlaceOverRadar& place)
  {
    return std::hypot(place.east - 10'000.0, place.north - 60'000.0) < 8'000.0 ||
           std::hypot(place.east + 10'000.0, place.north + 60'000.0) < 4'000.0;
  };
  const VelocityVolume truth = ScanVelocities(scan);
  VelocityVolume volume = FoldedAt(truth, 12.0F);
  const DealiasCounts counts = Dealias(volume);
  EXPECT_AT_LEAST(counts.unknown, 150u, "gates without a fold");
  for (std::size_t index = 0; index < volume.sweeps[0].values.size(); ++index)
  {
    EXPECT_EQ(volume.sweeps[0].states[index] == GateState::Valid,
      !std::isnan(volume.sweeps[0].values[index]));
  }
}

TEST(Dealiasing, GivesTheSameOnSeveralThreads)
{
  VelocityScan scan;
  scan.wind = ShearedWind;
  scan.echo = IsInStorm;
  VelocityVolume one = FoldedAt(ScanVelocities(scan), 12.0F);
  VelocityVolume three = one;
  Dealias(one);
  DealiasOptions options;
  options.loop = ThreadLoop(3);
  Dealias(three, options);
  for (std::size_t sweep = 0; sweep < one.sweeps.size(); ++sweep)
  {
    EXPECT_EQ(one.sweeps[sweep].states, three.sweeps[sweep].states);
    EXPECT_EQ(std::memcmp(one.sweeps[sweep].values.data(), three.sweeps[sweep].values.data(),
                one.sweeps[sweep].values.size() * sizeof(float)),
      0);
  }
}

TEST(Dealiasing, CountsJumps)
{
  VelocityScan scan;
  scan.elevations = {0.5};
  scan.noise = 0.0;
  scan.wind = UniformWind;
  const JumpCounts none = CountJumps(FoldedAt(ScanVelocities(scan), 50.0F));
  EXPECT_EQ(none.pairs, 360u * 399u + 360u * 400u);
  EXPECT_EQ(none.jumps, 0u);
  // 40 m/s fold at 25 m/s on four rays, along all of their gates.
  EXPECT_EQ(CountJumps(FoldedAt(ScanVelocities(scan), 25.0F)).jumps, 4u * 400u);
}
