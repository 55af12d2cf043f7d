// SPDX-License-Identifier: BSD-3-Clause
// Several radars about one time, through the choice of their volumes: radars that start, stop and
// miss volumes, how they overlap, and the ancillary arrays.
#include "BeamScene.h"
#include "DirectMerge.h"
#include "Tolerance.h"
#include "nexrad/Merging/TimeMerge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

const Position eastSite = {38.7, -91.0, 300.0};
constexpr double gap = 900.0; // s, the default
constexpr OverlapStrategy allStrategies[] = {OverlapStrategy::Mean, OverlapStrategy::Nearest,
  OverlapStrategy::Maximum, OverlapStrategy::Distance};

// A grid of 23 × 11 columns, 10 km apart, about both radars; levels each 500 m from 500 m on.
GridSpecification NetworkGrid()
{
  GridSpecification grid = SceneGrid();
  grid.dimensions = {23, 11, 16};
  grid.spacing = {10'000.0, 10'000.0, 500.0};
  grid.origin = {-70'000.0, -50'000.0, 500.0};
  return grid;
}

// A volume of five tilts, 20 s each, its rays one after the other; `seconds` after 18:00.
PolarVolume TimedVolume(const char* name, const Position& site, float value, double seconds)
{
  std::vector<NumberSweep> sweeps;
  for (int tilt = 0; tilt < 5; ++tilt)
  {
    const double begin = seconds + 24.0 * tilt;
    sweeps.push_back(UniformSweep(tilt + 1, 0.5 + tilt, value, begin));
    for (std::size_t ray = 0; ray < 360; ++ray)
    {
      sweeps.back().rays[ray].time +=
        Duration(std::llround(20'000.0 * static_cast<double>(ray) / 360.0));
    }
  }
  PolarVolume volume = VolumeOf(sweeps, site);
  volume.site.name = name;
  return volume;
}

// KWST every five minutes of two hours; KEST from 0:40, with 28 minutes between its volumes at 0:50
// and 1:18, until 1:23.
std::vector<PolarVolume> Network(float west, float east)
{
  std::vector<PolarVolume> volumes;
  for (int i = 0; i < 24; ++i)
  {
    volumes.push_back(TimedVolume("KWST", centralSite, west, 300.0 * i));
  }
  for (const double minutes : {40.0, 45.0, 50.0, 78.0, 83.0})
  {
    volumes.push_back(TimedVolume("KEST", eastSite, east, 60.0 * minutes));
  }
  return volumes;
}

// Merges at one time after the other.
class NetworkRun
{
public:
  NetworkRun(const std::vector<PolarVolume>& volumes, const BeamMergeOptions& options)
  {
    for (const PolarVolume& volume : volumes)
    {
      pointers.push_back(&volume);
    }
    request.grid = NetworkGrid();
    request.beam = options;
  }

  GriddedVolume At(double seconds)
  {
    request.time = sceneTime + Duration(std::llround(seconds * 1000.0));
    return *nexrad::testing::MergeDirectly(pointers, request, {}, &run);
  }

private:
  std::vector<const PolarVolume*> pointers;
  MergeRequest request;
  DirectRun run;
};

BeamMergeOptions WithAncillaryArrays(OverlapStrategy strategy = OverlapStrategy::Distance)
{
  BeamMergeOptions options;
  options.strategy = strategy;
  options.ancillary = true;
  return options;
}

// Slant ranges from both radars to the voxels that each saw well inside its tilts, else −1.
struct Ranges
{
  std::vector<double> west;
  std::vector<double> east;

  static std::vector<double> From(const Position& site)
  {
    std::vector<double> ranges(NetworkGrid().VoxelCount(), -1.0);
    ForEachVoxel(NetworkGrid(), site,
      [&](const SeenVoxel& voxel)
      {
        const bool inside = voxel.elevation > 0.1 && voxel.elevation < 4.9 &&
                            voxel.groundDistance > 3'000.0 && voxel.groundDistance < 225'000.0;
        ranges[voxel.index] = inside ? voxel.slantRange : -1.0;
      });
    return ranges;
  }

  Ranges()
    : west(From(centralSite))
    , east(From(eastSite))
  {
  }

  bool Both(std::size_t voxel) const { return west[voxel] > 0.0 && east[voxel] > 0.0; }
};

double WeightAt(double range)
{
  return std::exp(-range * range / 1e10);
}

// Rises by 0.1 dBZ a km to the east and 0.05 to the north.
double SmoothField(double x, double y)
{
  return 25.0 + x / 10'000.0 + y / 20'000.0;
}

// Three tilts of the field, out to 75 km.
PolarVolume ScanSmoothField(
  const char* name, const Position& site, std::size_t rays, double gateLength)
{
  const GridSpecification grid = NetworkGrid();
  const SiteGeoreference georeference(site);
  const BeamModel beam;
  const auto gates = static_cast<std::size_t>(75'000.0 / gateLength);
  std::vector<NumberSweep> sweeps;
  for (int tilt = 0; tilt < 3; ++tilt)
  {
    NumberSweep sweep = MakeSweep(tilt + 1, 0.5 + tilt, rays, gates, gateLength);
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      sweep.rays[ray].time = sceneTime;
      for (std::size_t gate = 0; gate < gates; ++gate)
      {
        const double range = sweep.firstGate + gateLength * static_cast<double>(gate);
        const BeamPoint point = beam.Locate(range, sweep.rays[ray].elevation);
        const auto place = georeference.Locate({sweep.rays[ray].azimuth, point.groundDistance});
        const auto onGrid = grid.FromGeographic(place[0], place[1]);
        SetGate(sweep, ray, gate, static_cast<float>(SmoothField(onGrid[0], onGrid[1])));
      }
    }
    sweeps.push_back(sweep);
  }
  PolarVolume volume = VolumeOf(sweeps, site);
  volume.site.name = name;
  return volume;
}

std::vector<double> SlantRanges(const Position& site)
{
  std::vector<double> ranges(NetworkGrid().VoxelCount());
  ForEachVoxel(NetworkGrid(), site,
    [&ranges](const SeenVoxel& voxel) { ranges[voxel.index] = voxel.slantRange; });
  return ranges;
}

// The field's mean over the part of a voxel of NetworkGrid that is less than `end` from a radar, by
// 20 × 20 points.
double MeanWithin(const Position& site, double end, double x, double y)
{
  const GridSpecification grid = NetworkGrid();
  const SiteGeoreference georeference(site);
  double sum = 0.0;
  int count = 0;
  for (int point = 0; point < 400; ++point)
  {
    const double east = x + 500.0 * (point % 20 - 9.5);
    const double north = y + 500.0 * (point / 20 - 9.5);
    const auto place = grid.ToGeographic(east, north);
    if (georeference.Look(place[0], place[1]).groundDistance < end)
    {
      sum += SmoothField(east, north);
      ++count;
    }
  }
  return sum / count;
}

} // namespace

// Both radars see the same steady field: whatever KEST does, its value is the same everywhere and
// always, by every strategy; what is seen by KEST alone comes and goes, with that value.
TEST(BeamNetwork, AConstantFieldStaysConstantWhileARadarStartsMissesVolumesAndStops)
{
  const std::vector<PolarVolume> volumes = Network(30.0F, 30.0F);
  const Ranges ranges;
  for (const OverlapStrategy strategy : allStrategies)
  {
    NetworkRun run(volumes, WithAncillaryArrays(strategy));
    std::size_t eastAlone = 0;
    for (double seconds = 600.0; seconds < 6600.0; seconds += 50.0)
    {
      const GriddedVolume volume = run.At(seconds);
      const bool eastTakesPart = volume.sites.front() == "KEST";
      for (std::size_t i = 0; i < volume.values.size(); ++i)
      {
        const bool echo = volume.states[i] == VoxelState::Echo;
        ASSERT_TRUE(!echo || std::abs(volume.values[i] - 30.0F) < 1e-3F) << seconds;
        ASSERT_TRUE(echo || ranges.west[i] < 0.0) << seconds;
        const bool one = volume.ancillary.radars[i] == 1;
        eastAlone += eastTakesPart && one && volume.ancillary.nearestSite[i] == 0;
      }
    }
    EXPECT_AT_LEAST(eastAlone, 50'000u, "voxels of the eastern radar alone");
  }
}

// The weight of KEST rises from nothing to all of it in the five minutes before its first volume
// is ten minutes off, and falls again; never in a step that the fade of 1/300 a second does not
// give. So does the merged value where the radars see different things.
TEST(BeamNetwork, ARadarThatStartsMissesVolumesAndStopsFades)
{
  constexpr double step = 10.0; // s
  constexpr double fade = 3.0 * step / gap;
  const std::vector<PolarVolume> volumes = Network(20.0F, 40.0F);
  NetworkRun run(volumes, WithAncillaryArrays());
  const Ranges ranges;
  GriddedVolume before = run.At(1400.0);
  double smallestWeight = std::numeric_limits<double>::max();
  for (double seconds = 1400.0 + step; seconds < 6200.0; seconds += step)
  {
    const GriddedVolume now = run.At(seconds);
    for (std::size_t i = 0; i < now.values.size(); ++i)
    {
      if (!ranges.Both(i))
      {
        continue;
      }
      const double west = WeightAt(ranges.west[i]);
      const double east = WeightAt(ranges.east[i]);
      const double weight = now.ancillary.weight[i];
      ASSERT_GT(weight, (1.0 - 1e-5) * west);
      ASSERT_AT_MOST(weight / (west + east) - 1.0, 0.0017, "weight above both radars', part of it");
      // The rays of neighbouring tilts are 24 s apart, and so are the ends of their fades.
      const double change = std::abs(weight - static_cast<double>(before.ancillary.weight[i]));
      ASSERT_AT_MOST(change, (fade + 24.0 * 3.0 / gap) * east + 0.02 * west,
        "change of the weight in a step, its radar's slowest fade as the bound")
        << seconds;
      const double valueStep = std::abs(now.values[i] - before.values[i]);
      ASSERT_AT_MOST(valueStep, 20.0 * (fade + 24.0 * 3.0 / gap) * east / west + 0.05,
        "change of the value in a step, dBZ, its radar's slowest fade as the bound")
        << seconds;
      // Midway between the volumes 28 minutes apart: both 14 minutes off.
      const bool middle = std::abs(seconds - 3888.0) < step;
      smallestWeight = middle ? std::min(smallestWeight, (weight - west) / east) : smallestWeight;
    }
    before = now;
  }
  EXPECT_AT_MOST(smallestWeight, 0.35, "smallest weight");
}

// The weight of KEST at every voxel of the overlap, as a part of the whole: between what the fade
// gives its first ray and its last ray; up while it comes, and down while it goes.
TEST(BeamNetwork, TheWeightOfARadarThatComesAndGoesIsARamp)
{
  const std::vector<PolarVolume> volumes = Network(20.0F, 40.0F);
  NetworkRun run(volumes, WithAncillaryArrays());
  const Ranges ranges;
  const auto partsAt = [&](double seconds)
  {
    const GriddedVolume volume = run.At(seconds);
    std::vector<double> parts;
    for (std::size_t i = 0; i < volume.values.size(); ++i)
    {
      if (ranges.Both(i))
      {
        const double both = static_cast<double>(volume.ancillary.weight[i]);
        parts.push_back((both - WeightAt(ranges.west[i])) / WeightAt(ranges.east[i]));
      }
    }
    return parts;
  };
  const auto fadeOf = [](double age) { return std::clamp(3.0 * (1.0 - age / gap), 0.0, 1.0); };
  const auto checkRamp = [&](double from, double to, double firstRay, double lastRay, double sign)
  {
    std::vector<double> before;
    double largestReturn = 0.0;
    for (double seconds = from; seconds <= to; seconds += 10.0)
    {
      const auto [least, most] =
        std::minmax({fadeOf(std::abs(firstRay - seconds)), fadeOf(std::abs(lastRay - seconds))});
      const std::vector<double> parts = partsAt(seconds);
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        ASSERT_GT(parts[i], least - 1e-5) << seconds;
        ASSERT_AT_MOST(parts[i] - most, 0.0145, "weight above the ramp");
        const double change = before.empty() ? 0.0 : sign * (parts[i] - before[i]);
        largestReturn = std::max(largestReturn, -change);
      }
      before = parts;
    }
    EXPECT_AT_MOST(largestReturn, 0.009, "step back of the weight");
  };
  checkRamp(1480.0, 1940.0, 2400.0, 2516.0, 1.0);
  checkRamp(5560.0, 6010.0, 4980.0, 5096.0, -1.0);
}

// Worked out by hand: KWST saw 20 dBZ 100 s before the time, KEST 40 dBZ 800 s before it, so that
// KEST counts for 3·(1 − 800/900) = 1/3.
TEST(BeamNetwork, AncillaryArraysAndValuesByHandForEachStrategy)
{
  std::vector<PolarVolume> volumes;
  for (const auto& [name, site, value, seconds] :
    {std::make_tuple("KWST", centralSite, 20.0F, -100.0),
      std::make_tuple("KEST", eastSite, 40.0F, -800.0)})
  {
    std::vector<NumberSweep> sweeps;
    for (int tilt = 0; tilt < 5; ++tilt)
    {
      sweeps.push_back(UniformSweep(tilt + 1, 0.5 + tilt, value, seconds));
    }
    volumes.push_back(VolumeOf(sweeps, site));
    volumes.back().site.name = name;
  }
  const Ranges ranges;
  struct Expected
  {
    double value;
    double weight;
  };
  const auto expected = [](OverlapStrategy strategy, double west, double east) -> Expected
  {
    const double a = WeightAt(west);
    const double b = WeightAt(east) / 3.0;
    switch (strategy)
    {
    case OverlapStrategy::Mean:
      return {25.0, 4.0 / 3.0};
    case OverlapStrategy::Maximum:
      return {40.0, 4.0 / 3.0};
    case OverlapStrategy::Nearest:
      return west < east ? Expected{20.0, 1.0} : Expected{40.0, 1.0 / 3.0};
    default:
      return {(20.0 * a + 40.0 * b) / (a + b), a + b};
    }
  };
  for (const OverlapStrategy strategy : allStrategies)
  {
    const GriddedVolume volume = NetworkRun(volumes, WithAncillaryArrays(strategy)).At(0.0);
    ASSERT_EQ(volume.sites, (std::vector<std::string>{"KEST", "KWST"}));
    std::size_t count = 0;
    for (std::size_t i = 0; i < volume.values.size(); ++i)
    {
      const double west = ranges.west[i];
      const double east = ranges.east[i];
      if (!ranges.Both(i) || std::abs(west - east) < 500.0)
      {
        continue;
      }
      ++count;
      const Expected right = expected(strategy, west, east);
      ASSERT_EQ(volume.states[i], VoxelState::Echo);
      ASSERT_WITHIN(volume.values[i], right.value, 0.0135, "value by hand, dBZ");
      ASSERT_WITHIN(
        volume.ancillary.weight[i] / right.weight, 1.0, 0.002, "weight by hand, part of it");
      ASSERT_EQ(volume.ancillary.radars[i], 2);
      ASSERT_NEAR(volume.ancillary.age[i], 100.0, 1e-3);
      ASSERT_EQ(volume.ancillary.nearestSite[i], east < west ? 0 : 1);
    }
    EXPECT_AT_LEAST(count, 800u, "voxels compared");
  }
}

// A smooth field, as a legacy radar (1°, 1 km) and one in super-resolution (0.5°, 250 m) see it:
// the merge is the field, across the places where one of them begins or ends to see as well. Voxels
// of 10 km are means of what has gates of them (Formulas G10).
TEST(BeamNetwork, ASmoothFieldHasNoStripesWhereResolutionsMeet)
{
  const GridSpecification grid = NetworkGrid();
  // Both end within the grid, beyond the middle between them.
  constexpr std::array<double, 2> ends = {75'500.0, 75'125.0};
  const std::array<Position, 2> sites = {centralSite, eastSite};
  const std::vector<PolarVolume> volumes = {ScanSmoothField("KLEG", centralSite, 360, 1000.0),
    ScanSmoothField("KFIN", eastSite, 720, 250.0)};
  const GriddedVolume volume = NetworkRun(volumes, WithAncillaryArrays()).At(0.0);
  const std::array<std::vector<double>, 2> ranges = {
    SlantRanges(centralSite), SlantRanges(eastSite)};
  std::size_t ofOne = 0;
  std::size_t ofBoth = 0;
  double atEnds = 0.0;
  double elsewhere = 0.0;
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    if (volume.states[i] != VoxelState::Echo)
    {
      continue;
    }
    const double x = grid.Coordinate(0, static_cast<int>(i % 23));
    const double y = grid.Coordinate(1, static_cast<int>(i / 23 % 11));
    double sum = 0.0;
    double weights = 0.0;
    bool isAtEnd = false;
    for (std::size_t site = 0; site < 2; ++site)
    {
      const double weight = ranges[site][i] < ends[site] ? WeightAt(ranges[site][i]) : 0.0;
      sum += weight > 0.0 ? weight * MeanWithin(sites[site], ends[site], x, y) : 0.0;
      weights += weight;
      isAtEnd = isAtEnd || std::abs(ranges[site][i] - ends[site]) < 5'000.0;
    }
    double& largest = isAtEnd ? atEnds : elsewhere;
    ASSERT_GT(weights, 0.0);
    largest = std::max(largest, std::abs(volume.values[i] - sum / weights));
    (volume.ancillary.radars[i] == 1 ? ofOne : ofBoth) += 1;
  }
  EXPECT_AT_MOST(elsewhere, 0.06, "difference to the mean away from the ends of range, dBZ");
  EXPECT_AT_MOST(atEnds, 0.15, "difference to the mean at the ends of range, dBZ");
  EXPECT_AT_LEAST(ofOne, 600u, "voxels that one radar sees");
  EXPECT_AT_LEAST(ofBoth, 150u, "voxels that both radars see");
}
