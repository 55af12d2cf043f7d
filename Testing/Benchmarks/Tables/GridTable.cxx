// SPDX-License-Identifier: BSD-3-Clause
#include "Tables/GridTable.h"

#include "nexrad/Merging/SeriesMerger.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradThreads.h"

#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>

namespace nexrad::application
{
namespace
{

// Two neighbouring time steps in the middle of the series.
struct Steps
{
  Time begin;
  Time end;
};

Steps FindMiddle(const BenchRequest& request)
{
  const std::vector<Time> times = StepsOf(request);
  const std::size_t middle = times.size() / 2;
  return {times[middle - 1], times[middle]};
}

// The files of the first sites, by name, that are about the steps: so few that a run begins at
// once.
std::vector<std::filesystem::path> FilesAbout(
  const Steps& steps, const SeriesScan& scan, std::size_t sites)
{
  constexpr std::size_t spare = 2; // volumes on either side, for a merge that looks farther
  std::vector<std::filesystem::path> files;
  for (std::size_t site = 0; site < sites; ++site)
  {
    const std::vector<SeriesVolume>& volumes = scan.sites[site].volumes;
    const auto begunBy = [&volumes](Time time)
    {
      return static_cast<std::size_t>(std::count_if(volumes.begin(), volumes.end(),
        [time](const SeriesVolume& volume) { return volume.start <= time; }));
    };
    const std::size_t before = begunBy(steps.begin);
    const std::size_t end = std::min(begunBy(steps.end) + spare, volumes.size());
    for (std::size_t index = before > spare ? before - spare : 0; index < end; ++index)
    {
      files.push_back(volumes[index].file);
    }
  }
  return files;
}

std::vector<std::size_t> SiteCounts(std::size_t all)
{
  std::vector<std::size_t> counts;
  for (std::size_t count = 1; count < all; count *= 2)
  {
    counts.push_back(count);
  }
  counts.push_back(all);
  return counts;
}

struct GridTimes
{
  double first;
  Measurement next;
};

// Merges the two steps by turns: neither is at hand from the merge before.
GridTimes MeasureGrid(
  const std::vector<std::filesystem::path>& files, const MergeOptions& options, int runs)
{
  MergerSetup setup;
  setup.loop = vtkNexradRangeLoop();
  setup.threads = vtkNexradThreadCount();
  setup.anyOrder = true;
  SeriesMerger merger(files, options, setup);
  merger.Open();
  merger.EndAt(merger.Times()[1]);
  const auto merge = [&merger](std::size_t step)
  {
    vtkNew<vtkImageData> image;
    vtkNexradVolumeToImage(*merger.Merge(merger.Times()[step]), image);
  };
  GridTimes times;
  times.first = SecondsOf([&] { merge(0); });
  merge(1);
  std::vector<double> next;
  for (int run = 0; run < runs; ++run)
  {
    next.push_back(SecondsOf([&] { merge(0); }));
    next.push_back(SecondsOf([&] { merge(1); }));
  }
  times.next = Summarize(next);
  return times;
}

} // namespace

BenchTable MakeGridTable(const BenchRequest& request)
{
  const SeriesScan& scan = request.scan;
  BenchTable table;
  table.key = "grid";
  table.title = "One merged volume, method " + NameOf(request.options.method) +
                ", rays in memory; the first of a run also places the sites on the grid";
  table.columns = {NameColumn("dimensions", "voxels"), NameColumn("sites", "sites"),
    {"first_s", "first, s", 3}, {"volume_s", "each further, s", 3}};
  const Steps steps = FindMiddle(request);
  MergeOptions options = request.options;
  options.begin = steps.begin;
  options.end = steps.end;
  for (const std::array<int, 3>& dimensions : request.dimensions)
  {
    options.grid.dimensions = dimensions;
    for (const std::size_t sites : SiteCounts(scan.sites.size()))
    {
      const GridTimes times = MeasureGrid(FilesAbout(steps, scan, sites), options, request.runs);
      table.rows.push_back(
        {FormatDimensions(dimensions), static_cast<double>(sites), times.first, times.next});
    }
  }
  return table;
}

} // namespace nexrad::application
