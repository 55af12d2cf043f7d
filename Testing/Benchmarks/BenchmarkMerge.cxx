// SPDX-License-Identifier: BSD-3-Clause
// How long three radars take to merge at 18:00 UTC of the synthetic day, by dimensions, on two
// threads, with their volumes in memory: the storm as scanned, and the same rays with an echo in
// every gate, both along the storm's motion and linear in time. The geometry, making the volumes
// ready (once a run both), and finding the motion (once a step at most) are measured apart.
#include "PolarMerge.h"
#include "nexrad/Grid/FinerBox.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Motion/MotionTracker.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/Simulation/SimulatedDay.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <map>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

const Time evening = *ParseIso8601("2006-03-12T18:00:00Z");

std::vector<PolarVolume> ScanStorm()
{
  SimulatedDayOptions options;
  options.begin = evening - 15min;
  options.length = 30min;
  std::map<std::string, std::vector<SimulatedVolume>> sites;
  for (const SimulatedVolume& volume : PlanSimulatedDay(options))
  {
    sites[volume.site.name].push_back(volume);
  }
  const StormField field;
  std::vector<PolarVolume> scanned;
  for (const auto& site : sites)
  {
    std::vector<Time> starts;
    std::vector<Time> ends;
    for (const SimulatedVolume& volume : site.second)
    {
      starts.push_back(volume.start);
      ends.push_back(volume.start + VolumePeriod(volume.coveragePattern));
    }
    for (const std::size_t index : FindVolumesAbout(starts, ends, evening, 15min))
    {
      const SimulatedVolume& each = site.second[index];
      scanned.push_back(MakePolarVolume(
        ScanVolume(field, each.site, each.coveragePattern, each.start), MomentName::REF));
    }
  }
  return scanned;
}

// An echo in every gate, no two alike.
std::vector<PolarVolume> FillWithEcho(std::vector<PolarVolume> volumes)
{
  for (PolarVolume& volume : volumes)
  {
    for (PolarSweep& sweep : volume.sweeps)
    {
      std::vector<float> values(sweep.rays.size() * sweep.gates);
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        values[i] = 30.0F + 20.0F * std::sin(static_cast<float>(i % 10'007));
      }
      SetGates(sweep, values, std::vector<GateState>(values.size(), GateState::Valid));
    }
  }
  return volumes;
}

const std::vector<PolarVolume>& Storm()
{
  static const std::vector<PolarVolume> storm = ScanStorm();
  return storm;
}

const std::vector<PolarVolume>& EchoEverywhere()
{
  static const std::vector<PolarVolume> echo = FillWithEcho(Storm());
  return echo;
}

std::vector<const PolarVolume*> PointersTo(const std::vector<PolarVolume>& volumes)
{
  std::vector<const PolarVolume*> pointers;
  for (const PolarVolume& volume : volumes)
  {
    pointers.push_back(&volume);
  }
  return pointers;
}

GridSpecification GridOf(int width)
{
  GridRequest request;
  request.dimensions = {width, width, width / 2};
  std::vector<Position> positions;
  for (const PolarVolume& volume : Storm())
  {
    positions.push_back(*volume.site.position);
  }
  return MakeGrid(request, positions);
}

void MeasureMerge(
  benchmark::State& state, const std::vector<PolarVolume>& volumes, bool alongMotion)
{
  const GridSpecification grid = GridOf(static_cast<int>(state.range(0)));
  const RangeLoop loop = ThreadLoop(2);
  const BeamVolumes storm = PrepareAll(BeamMerger(grid), PointersTo(Storm()));
  const auto motion = alongMotion ? MotionTracker(grid).Find(storm, evening) : nullptr;
  BeamMerger merger(grid);
  const BeamVolumes ready = PrepareAll(merger, PointersTo(volumes));
  merger.Merge(ready, evening, motion.get(), loop); // makes the geometry ready
  for (auto iteration : state)
  {
    benchmark::DoNotOptimize(merger.Merge(ready, evening, motion.get(), loop));
  }
}

void MergeStorm(benchmark::State& state)
{
  MeasureMerge(state, Storm(), true);
}

void MergeStormLinear(benchmark::State& state)
{
  MeasureMerge(state, Storm(), false);
}

void MergeEchoEverywhere(benchmark::State& state)
{
  MeasureMerge(state, EchoEverywhere(), true);
}

void MergeEchoEverywhereLinear(benchmark::State& state)
{
  MeasureMerge(state, EchoEverywhere(), false);
}

// A box of 60 km about the middle of the domain in voxels of 250 m, 240 x 240 x 80 of them, that
// moves by 10 km from one merge to the next: its radars' geometry is made anew each time. One that
// follows its echo also needs, for five minutes, five times the motion of the echo in it, here with
// nothing kept from the step before.
void MeasureBox(benchmark::State& state, const std::vector<PolarVolume>& volumes, bool follows)
{
  const GridSpecification domain = GridOf(256);
  const RangeLoop loop = ThreadLoop(2);
  const BeamVolumes ready = PrepareAll(BeamMerger(domain), PointersTo(volumes));
  std::vector<FinerBox> boxes;
  for (const double east : {-30e3, -20e3})
  {
    boxes.push_back(MakeFinerBox(domain, {{east, east + 60e3, -30e3, 30e3}}));
  }
  const auto motion = MotionTracker(boxes[0].grid).Find(ready, evening);
  BeamMerger merger(boxes[0].grid);
  MotionTracker tracker(domain);
  constexpr int minutes = 5;
  std::size_t number = 0;
  const auto merge = [&]
  {
    tracker.Find({}, evening, loop);
    for (int minute = 0; follows && minute < minutes; ++minute)
    {
      tracker.FindWithin({-30e3, 30e3, -30e3, 30e3}, ready, evening, loop);
    }
    merger.SetBlock(boxes[number++ % boxes.size()].block);
    return merger.Merge(ready, evening, motion.get(), loop);
  };
  merge(); // makes the means of these voxels ready
  for (auto iteration : state)
  {
    benchmark::DoNotOptimize(merge());
  }
}

void MergeBoxOfStorm(benchmark::State& state)
{
  MeasureBox(state, Storm(), false);
}

void MergeBoxOfEchoEverywhere(benchmark::State& state)
{
  MeasureBox(state, EchoEverywhere(), false);
}

void MergeFollowingBoxOfStorm(benchmark::State& state)
{
  MeasureBox(state, Storm(), true);
}

void MergeFollowingBoxOfEchoEverywhere(benchmark::State& state)
{
  MeasureBox(state, EchoEverywhere(), true);
}

// With nothing kept from the step before: the images of all volumes, then the motion of three
// pairs.
void FindMotion(benchmark::State& state)
{
  const GridSpecification grid = GridOf(static_cast<int>(state.range(0)));
  BeamMerger merger(grid);
  const BeamVolumes ready = PrepareAll(merger, PointersTo(Storm()));
  MotionTracker tracker(grid);
  const RangeLoop loop = ThreadLoop(2);
  tracker.Find(ready, evening, loop); // makes the geometry ready
  for (auto iteration : state)
  {
    tracker.Find({}, evening, loop);
    benchmark::DoNotOptimize(tracker.Find(ready, evening, loop));
  }
}

void GeometryOfThreeSites(benchmark::State& state)
{
  const GridSpecification grid = GridOf(static_cast<int>(state.range(0)));
  std::map<std::string, Position> sites;
  for (const PolarVolume& volume : Storm())
  {
    sites[volume.site.name] = *volume.site.position;
  }
  for (auto iteration : state)
  {
    for (const auto& site : sites)
    {
      benchmark::DoNotOptimize(SiteGeometry(grid, site.second, 480'000.0));
    }
  }
}

void PrepareOneVolume(benchmark::State& state)
{
  const GridSpecification grid = GridOf(256);
  for (auto iteration : state)
  {
    benchmark::DoNotOptimize(PrepareForGrid(Storm().front(), grid, {}));
  }
}

} // namespace

BENCHMARK(MergeStorm)->Arg(128)->Arg(256)->Arg(512)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(MergeStormLinear)->Arg(256)->Arg(512)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(MergeEchoEverywhere)
  ->Arg(128)
  ->Arg(256)
  ->Arg(512)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(MergeEchoEverywhereLinear)
  ->Arg(256)
  ->Arg(512)
  ->UseRealTime()
  ->Unit(benchmark::kMillisecond);
BENCHMARK(MergeBoxOfStorm)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(MergeBoxOfEchoEverywhere)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(MergeFollowingBoxOfStorm)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(MergeFollowingBoxOfEchoEverywhere)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(FindMotion)->Arg(256)->Arg(512)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK(GeometryOfThreeSites)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(PrepareOneVolume)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
