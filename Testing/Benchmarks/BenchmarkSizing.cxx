// SPDX-License-Identifier: BSD-3-Clause
// What one radar costs in a merge of the whole country, by time and by memory: the figures from
// which Documentation/User/8-several-machines.md sizes a cluster.
//
//   BenchmarkSizing BEFORE AFTER        two Level II files of one radar, some minutes apart
//
// The grid has 0.01° and 33 levels; the block that is merged is the box about all that the radar
// sees. Times are those of one core, medians of five runs, of the processor's clock.
#include "PolarMerge.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Motion/MotionTracker.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"

#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr double degreesPerVoxel = 0.01;

// The United States without Alaska and the islands: 130° to 60° west, 20° to 55° north.
GridSpecification CountryGrid()
{
  GridRequest request;
  request.dimensions = {7000, 3500, 33};
  request.bounds = GeographicBounds{-130.0, 20.0, -60.0, 55.0};
  request.axes = GridAxes::Geographic;
  return MakeGrid(request, {});
}

VoxelBlock BoxAbout(const GridSpecification& grid, const Position& site, double reach)
{
  constexpr double metresPerDegree = 111'000.0;
  constexpr double radians = 3.14159265358979323846 / 180.0;
  const double north = reach / metresPerDegree;
  const double east = north / std::cos((std::abs(site.latitude) + north) * radians);
  const std::array<double, 2> centre = {site.longitude, site.latitude};
  const std::array<double, 2> half = {east, north};
  VoxelBlock block = VoxelBlock::Of(grid);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const auto place = [&](double degrees)
    {
      const double voxel = (degrees - grid.origin[axis]) / degreesPerVoxel;
      return std::clamp(static_cast<int>(std::lround(voxel)), 0, grid.dimensions[axis]);
    };
    block.begin[axis] = place(centre[axis] - half[axis]);
    block.end[axis] = place(centre[axis] + half[axis]);
  }
  return block;
}

// Seconds of the processor for a piece of work.
double Cost(const std::function<void()>& work)
{
  std::array<double, 5> seconds{};
  for (double& each : seconds)
  {
    const std::clock_t begin = std::clock();
    work();
    each = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  }
  std::sort(seconds.begin(), seconds.end());
  return seconds[seconds.size() / 2];
}

void PrintTime(const char* what, double seconds)
{
  std::printf("%-44s %8.1f ms\n", what, 1000.0 * seconds);
}

void PrintMemory(const char* what, std::size_t bytes)
{
  std::printf("%-44s %8.2f MB\n", what, static_cast<double>(bytes) / 1e6);
}

PolarVolume ReadReflectivity(const char* file)
{
  return MakePolarVolume(ReadLevel2(file), MomentName::REF);
}

void MeasureVolume(const char* file)
{
  const PolarVolume volume = ReadReflectivity(file);
  PrintTime("decode a file, one moment", Cost([file] { ReadReflectivity(file); }));
  PrintTime("make its summary", Cost([&volume] { MakeSummary(volume); }));
  const GridSpecification grid = CountryGrid();
  PrintTime("make it ready for merges", Cost([&] { PrepareForGrid(volume, grid, {}); }));
  PrintMemory("its rays", MemoryOf(volume));
  PrintMemory("its rays, ready for merges", PrepareForGrid(volume, grid, {}).MemoryBytes());
  PrintMemory("its summary", MakeSummary(volume).MemoryBytes());
}

// The two volumes as those of `count` radars, three degrees apart.
BeamVolumes AsRadars(const BeamVolumes& volumes, int count)
{
  BeamVolumes radars;
  for (int i = 0; i < count; ++i)
  {
    for (const std::shared_ptr<const BeamVolume>& volume : volumes)
    {
      BeamVolume moved;
      moved.site = {"K" + std::to_string(i),
        Position{33.0 + 3.0 * (i % 4), -110.0 + 3.0 * static_cast<double>(i / 4), 300.0}};
      moved.start = volume->start;
      moved.end = volume->end;
      moved.composite = volume->composite;
      radars.push_back(std::make_shared<const BeamVolume>(std::move(moved)));
    }
  }
  return radars;
}

// The search for motion has a part that grows with the radars, and one that the country alone has.
void MeasureMotion(const BeamVolumes& ready, Time time)
{
  MotionTracker tracker(CountryGrid());
  const auto costOf = [&](int count)
  {
    const BeamVolumes radars = AsRadars(ready, count);
    tracker.Find(radars, time); // makes the geometry ready
    return Cost(
      [&]
      {
        tracker.Find({}, time);
        tracker.Find(radars, time);
      });
  };
  constexpr int many = 16;
  const double one = costOf(1);
  const double each = (costOf(many) - one) / (many - 1);
  PrintTime("find the motion, for each radar", each);
  PrintTime("find the motion, besides", one - each);
}

void MeasureMerge(const PolarVolume& before, const PolarVolume& after)
{
  const GridSpecification grid = CountryGrid();
  const Position& site = *before.site.position;
  const double reach = MakeSummary(before).reach;
  const VoxelBlock block = BoxAbout(grid, site, reach);
  const Time time = before.end + (after.start - before.end) / 2;
  BeamMerger merger(grid);
  merger.SetBlock(block);
  const BeamVolumes ready = PrepareAll(merger, {&before, &after});
  const SiteGeometry geometry(grid, site, reach, BeamModel(), block);
  PrintTime("geometry of the radar, once a run",
    Cost([&] { SiteGeometry(grid, site, reach, BeamModel(), block); }));
  PrintMemory("its geometry", geometry.MemoryBytes());
  MeasureMotion(ready, time);
  MotionTracker tracker(grid);
  const std::shared_ptr<const MotionField> motion = tracker.Find(ready, time);
  GriddedVolume made;
  const double merge =
    Cost([&] { made = *merger.Merge(ready, time, motion.get(), {}, {}, std::move(made)); });
  const auto seen = std::count_if(made.states.begin(), made.states.end(),
    [](VoxelState state) { return state != VoxelState::NotScanned; });
  const auto echo = std::count(made.states.begin(), made.states.end(), VoxelState::Echo);
  PrintTime("merge one time, all that the radar sees", merge);
  vtkNew<vtkImageData> image;
  PrintTime("hand these voxels to VTK", Cost([&] { vtkNexradVolumeToImage(made, image); }));
  const double voxels = static_cast<double>(block.VoxelCount());
  std::printf("%-44s %8.2f million, %.1f %% of them scanned, %.1f %% of those echo\n",
    "voxels of the box about it", voxels / 1e6, 100.0 * static_cast<double>(seen) / voxels,
    100.0 * static_cast<double>(echo) / static_cast<double>(std::max<std::ptrdiff_t>(seen, 1)));
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 3)
  {
    std::cerr << "usage: BenchmarkSizing BEFORE AFTER\n";
    return 2;
  }
  try
  {
    MeasureVolume(argv[1]);
    MeasureMerge(ReadReflectivity(argv[1]), ReadReflectivity(argv[2]));
  }
  catch (const Error& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}
