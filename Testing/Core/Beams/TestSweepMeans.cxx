// SPDX-License-Identifier: BSD-3-Clause
// Formulas G10: voxels coarser than gates and rays are means of them, others stay as they are.
#include "BeamScene.h"
#include "Tolerance.h"
#include "nexrad/Beams/SweepMeans.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Gridding/BeamSampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

using GateSetter = std::function<void(NumberSweep& sweep, std::size_t ray, std::size_t gate)>;

// A sweep at 1° whose gates are set one by one.
NumberSweep SweepOf(std::size_t rays, double gateSpacing, const GateSetter& set)
{
  const auto gates = static_cast<std::size_t>(std::lround(150'000.0 / gateSpacing));
  NumberSweep sweep = MakeSweep(1, 1.0, rays, gates, gateSpacing);
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    sweep.rays[ray].time = sceneTime;
    for (std::size_t gate = 0; gate < gates; ++gate)
    {
      set(sweep, ray, gate);
    }
  }
  return sweep;
}

// 250 m and 0.5°.
NumberSweep FineSweep(const GateSetter& set)
{
  return SweepOf(720, 250.0, set);
}

// No two gates alike, from 10 to 50 dBZ.
void SetNoise(NumberSweep& sweep, std::size_t ray, std::size_t gate)
{
  const double noise = std::sin(static_cast<double>(7919 * ray + 104'729 * gate));
  SetGate(sweep, ray, gate, static_cast<float>(30.0 + 20.0 * noise));
}

GateSetter Alternate(float even, float odd)
{
  return [even, odd](NumberSweep& sweep, std::size_t ray, std::size_t gate)
  { SetGate(sweep, ray, gate, (ray + gate) % 2 == 0 ? even : odd); };
}

// A value in one gate of three, another state in the others.
GateSetter OneOfThree(float value, GateState others)
{
  return [value, others](NumberSweep& sweep, std::size_t ray, std::size_t gate)
  {
    SetGate(sweep, ray, gate, value);
    sweep.states[sweep.Index(ray, gate)] = (ray + gate) % 3 == 0 ? GateState::Valid : others;
  };
}

BeamMergeOptions WithoutMeans()
{
  BeamMergeOptions options = AsMeasured();
  options.means = false;
  return options;
}

// A grid about the site with voxels of another width than the scene's.
GridSpecification GridOfWidth(double width, int columns)
{
  GridSpecification grid = SceneGrid();
  grid.dimensions = {columns, columns, 24};
  for (const std::size_t axis : {0U, 1U})
  {
    grid.spacing[axis] = width;
    grid.origin[axis] = -0.5 * width * (columns - 1);
  }
  return grid;
}

GriddedVolume MergeSweep(const NumberSweep& sweep, const BeamMergeOptions& options,
  MomentName moment = MomentName::REF, const GridSpecification& grid = SceneGrid())
{
  PolarVolume volume = VolumeOf({sweep});
  volume.moment = moment;
  return MergeAt({volume}, 0.0, options, grid);
}

// Voxels that the sweep at 1° sees, away from its last gates.
template <class Check>
void ForEachSeen(const GriddedVolume& volume, const Check& check)
{
  std::size_t seen = 0;
  const auto visit = [&](const SeenVoxel& voxel)
  {
    if (std::abs(voxel.elevation - 1.0) < 0.47 && voxel.groundDistance > 10'000.0 &&
        voxel.groundDistance < 140'000.0)
    {
      check(voxel);
      ++seen;
    }
  };
  ForEachVoxel(volume.grid, centralSite, visit);
  EXPECT_GT(seen, 14'000U);
}

BeamSweep Prepared(const NumberSweep& sweep, double side)
{
  BeamSweep prepared = PrepareBeamVolume(VolumeOf({sweep})).sweeps.front();
  prepared.means = MakeSweepMeans(prepared, ValueRule::Of(MomentName::REF, false), side);
  return prepared;
}

float SampleAt(const BeamSweep& sweep, double azimuth, double range)
{
  BeamTilt tilt;
  tilt.before.push_back({&sweep, nullptr, 0.0F, -1.0F});
  SamplingContext context;
  context.rule = ValueRule::Of(MomentName::REF, false);
  const double halfway = 0.5 * range / static_cast<double>(context.effectiveRadius);
  const auto turned = static_cast<float>(azimuth < 0.0 ? azimuth + 360.0 : azimuth);
  const ColumnDirection column{
    turned < 360.0F ? turned : 0.0F, static_cast<float>(std::tan(halfway))};
  TiltSample sample;
  SampleTilt({tilt}, 0, column, context, nullptr, false, sample);
  return sample.value;
}

} // namespace

TEST(SweepMeans, VoxelsFinerThanGatesChangeByNoBit)
{
  const NumberSweep sweep = SweepOf(360, 1'000.0, SetNoise);
  EXPECT_TRUE(Prepared(sweep, 1'000.0).means.rings.empty());
  const GridSpecification grid = GridOfWidth(900.0, 121);
  const GriddedVolume means = MergeSweep(sweep, {}, MomentName::REF, grid);
  BeamMergeOptions options;
  options.means = false;
  const GriddedVolume gates = MergeSweep(sweep, options, MomentName::REF, grid);
  EXPECT_EQ(means.values, gates.values);
  EXPECT_EQ(means.states, gates.states);
}

// Voxels of 1.8 km and rays of 1° and 1 km: near the radar the rays are closer than the voxels are
// wide, beyond nothing changes.
TEST(SweepMeans, OnlyWhatIsFinerThanVoxelsIsPutTogether)
{
  const NumberSweep sweep = SweepOf(360, 1'000.0, SetNoise);
  const BeamSweep prepared = Prepared(sweep, 1'800.0);
  const double expected = 0.5 * 1'800.0 / (Pi / 180.0);
  ASSERT_WITHIN(prepared.means.reach, expected, 800.0, "distance from which there are no means, m");
  const GridSpecification grid = GridOfWidth(1'800.0, 111);
  const GriddedVolume means = MergeSweep(sweep, AsMeasured(), MomentName::REF, grid);
  const GriddedVolume gates = MergeSweep(sweep, WithoutMeans(), MomentName::REF, grid);
  std::size_t changed = 0;
  const auto check = [&](const SeenVoxel& voxel)
  {
    const bool same = means.values[voxel.index] == gates.values[voxel.index];
    ASSERT_TRUE(same || voxel.groundDistance < expected + 800.0);
    changed += same ? 0U : 1U;
  };
  ForEachSeen(means, check);
  EXPECT_AT_LEAST(changed, 5'000U, "voxels that the means change");
}

TEST(SweepMeans, CoarserVoxelsAreTheMeansOfTheirGates)
{
  const NumberSweep sweep = FineSweep(Alternate(10.0F, 50.0F));
  const GriddedVolume gates = MergeSweep(sweep, WithoutMeans());
  const GriddedVolume means = MergeSweep(sweep, AsMeasured());
  BeamMergeOptions linearly;
  linearly.linearReflectivity = true;
  const GriddedVolume linear = MergeSweep(sweep, linearly);
  float largest = 0.0F;
  const auto check = [&](const SeenVoxel& voxel)
  {
    ASSERT_WITHIN(means.values[voxel.index], 30.0, 0.4, "means of coarser voxels, dBZ");
    ASSERT_WITHIN(linear.values[voxel.index], 10.0 * std::log10(0.5 * (1e1 + 1e5)), 0.1,
      "linear means of coarser voxels, dBZ");
    largest = std::max(largest, gates.values[voxel.index]);
  };
  ForEachSeen(means, check);
  EXPECT_AT_LEAST(
    largest, 45.0F, "largest value of four gates, dBZ"); // four gates are not the mean
}

// Formulas G6 and G8 over the voxel: no echo counts as 0 dBZ, of other moments the larger part
// wins; folded and unsampled gates carry no weight.
TEST(SweepMeans, StatesCountByTheirPartOfTheVoxel)
{
  const NumberSweep third = FineSweep(OneOfThree(45.0F, GateState::BelowThreshold));
  const NumberSweep folded = FineSweep(OneOfThree(45.0F, GateState::RangeFolded));
  const NumberSweep unsampled = FineSweep(OneOfThree(45.0F, GateState::NotSampled));
  const GriddedVolume reflectivity = MergeSweep(third, AsMeasured());
  const GriddedVolume ratio = MergeSweep(third, AsMeasured(), MomentName::ZDR);
  const GriddedVolume besideFolded = MergeSweep(folded, AsMeasured());
  const GriddedVolume besideUnsampled = MergeSweep(unsampled, AsMeasured(), MomentName::ZDR);
  const auto check = [&](const SeenVoxel& voxel)
  {
    ASSERT_EQ(reflectivity.states[voxel.index], VoxelState::Echo);
    ASSERT_WITHIN(
      reflectivity.values[voxel.index], 15.0, 0.5, "reflectivity of a voxel half full, dBZ");
    ASSERT_EQ(ratio.states[voxel.index], VoxelState::NoEcho);
    ASSERT_FLOAT_EQ(besideFolded.values[voxel.index], 45.0F);
    ASSERT_FLOAT_EQ(besideUnsampled.values[voxel.index], 45.0F);
  };
  ForEachSeen(reflectivity, check);
}

TEST(SweepMeans, AnglesAreMeansOnTheCircleAndVelocityIsNone)
{
  const GriddedVolume phase = MergeSweep(FineSweep(Alternate(350.0F, 10.0F)), {}, MomentName::PHI);
  const GriddedVolume velocity =
    MergeSweep(FineSweep(Alternate(-24.0F, 24.0F)), {}, MomentName::VEL);
  const auto check = [&](const SeenVoxel& voxel)
  {
    ASSERT_WITHIN(
      std::remainder(phase.values[voxel.index], 360.0F), 0.0, 0.2, "mean of phases, degrees");
    ASSERT_FLOAT_EQ(std::abs(velocity.values[voxel.index]), 24.0F);
  };
  ForEachSeen(phase, check);
}

// What was scanned, and what stands where, does not depend on the means: here with 20 rays of 0.5°
// missing, and with three missing twice.
TEST(SweepMeans, GapsBetweenRaysStayAsTheyAre)
{
  NumberSweep sweep = FineSweep(
    [](NumberSweep& each, std::size_t ray, std::size_t gate) { SetGate(each, ray, gate, 20.0F); });
  const auto countScanned = [](const GriddedVolume& volume)
  { return std::count(volume.states.begin(), volume.states.end(), VoxelState::Echo); };
  const auto whole = countScanned(MergeSweep(sweep, AsMeasured()));
  for (const std::size_t ray : {std::size_t{500}, std::size_t{300}, std::size_t{100}})
  {
    const std::size_t count = ray == 300 ? 20 : 3;
    const auto first = static_cast<std::ptrdiff_t>(ray);
    const auto last = static_cast<std::ptrdiff_t>(ray + count);
    const auto gates = static_cast<std::ptrdiff_t>(sweep.gates);
    sweep.rays.erase(sweep.rays.begin() + first, sweep.rays.begin() + last);
    sweep.values.erase(sweep.values.begin() + first * gates, sweep.values.begin() + last * gates);
    sweep.states.erase(sweep.states.begin() + first * gates, sweep.states.begin() + last * gates);
  }
  const GriddedVolume gates = MergeSweep(sweep, WithoutMeans());
  const GriddedVolume means = MergeSweep(sweep, AsMeasured());
  EXPECT_EQ(gates.states, means.states);
  for (std::size_t i = 0; i < gates.values.size(); ++i)
  {
    ASSERT_FLOAT_EQ(gates.values[i], means.values[i]);
  }
  // Gaps of 10.5° and of twice 2°, less half a beam width on either side.
  const double missing =
    1.0 - static_cast<double>(countScanned(means)) / static_cast<double>(whole);
  EXPECT_WITHIN(
    missing, (10.5 + 2.0 + 2.0 - 3.0 * 0.95) / 360.0, 0.0015, "part of the circle without rays");
}

// No ring and no ray where one resolution passes into the next: a small step changes little, in
// noise, along a ray, round the radar and across north.
TEST(SweepMeans, PassIntoEachOtherWithoutASeam)
{
  const std::vector<BeamSweep> sweeps = {
    Prepared(FineSweep(SetNoise), 1'800.0), Prepared(SweepOf(360, 1'000.0, SetNoise), 1'800.0)};
  for (const BeamSweep& sweep : sweeps)
  {
    ASSERT_AT_LEAST(sweep.means.rings.size(), 50U, "rings of means");
    const double spacing = 1.0 / static_cast<double>(sweep.means.ringsPerMetre);
    for (double range = 2'000.0; range < 140'000.0; range += 5.0)
    {
      const float step = SampleAt(sweep, 77.7, range + 5.0) - SampleAt(sweep, 77.7, range);
      ASSERT_AT_MOST(std::abs(step) / (40.0 * 5.0 / spacing), 0.4,
        "step along the range, part of 40 dB in a spacing")
        << range;
    }
    for (const double range : {1'500.0, 20'000.0, 51'000.0, 90'000.0})
    {
      for (double azimuth = -3.0; azimuth < 3.0; azimuth += 0.001)
      {
        const float step =
          SampleAt(sweep, azimuth + 0.001, range) - SampleAt(sweep, azimuth, range);
        ASSERT_AT_MOST(std::abs(step) / (40.0 * 0.001 / 0.5), 0.6,
          "step along the azimuth, part of 40 dB in half a degree")
          << range << " " << azimuth;
      }
    }
  }
}

// Columns that see a lone gate over the edge of their cells are not passed over: with ages asked
// for, no column is.
TEST(SweepMeans, ALoneGateIsSeenAsFarAsItsCellReaches)
{
  const NumberSweep before = FineSweep(
    [](NumberSweep& sweep, std::size_t ray, std::size_t gate)
    {
      if (ray % 60 == 7 && gate % 200 == 150)
      {
        SetGate(sweep, ray, gate, 60.0F);
      }
    });
  NumberSweep after = before;
  for (PolarRay& ray : after.rays)
  {
    ray.time = sceneTime + Duration(300'000);
  }
  const std::vector<PolarVolume> volumes = {VolumeOf({before}), VolumeOf({after})};
  BeamMergeOptions withAges;
  withAges.ancillary = true;
  const GridSpecification grid = GridOfWidth(10'000.0, 31);
  const GriddedVolume quick = MergeAt(volumes, 100.0, {}, grid);
  const GriddedVolume whole = MergeAt(volumes, 100.0, withAges, grid);
  EXPECT_EQ(quick.values, whole.values);
  EXPECT_EQ(quick.states, whole.states);
  EXPECT_AT_LEAST(
    std::count(quick.states.begin(), quick.states.end(), VoxelState::Echo), 250, "voxels of echo");
}
