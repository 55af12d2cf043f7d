// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/WriteVolumes.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradThreads.h"

#include <algorithm>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

// What one process makes, or all of them together.
struct Block
{
  WrittenFiles files;
  std::uintmax_t bytes = 0;
  bool anySite = false; ///< some radar took part in a volume
};

// Merges and writes the steps of this process.
Block WriteBlock(
  const GridJob& job, SeriesMerger& merger, const Progress& progress, const Processes& processes)
{
  const std::vector<Time>& times = merger.Times();
  const auto [begin, end] = processes.Part(times.size());
  if (begin < end)
  {
    merger.EndAt(times[end - 1]);
  }
  StepWriter writer(job.folder, job.format, job.nxv);
  Block block;
  GriddedVolume memory;
  for (std::size_t i = begin; i < end; ++i)
  {
    auto volume =
      merger.Merge(times[i], ShareOf(progress, i - begin, end - begin), {}, std::move(memory));
    if (!volume)
    {
      throw Error("stopped before all volumes were made");
    }
    block.anySite = block.anySite || !volume->sites.empty();
    memory = writer.Write(std::move(*volume));
  }
  writer.Finish();
  block.bytes = writer.Bytes();
  block.files = writer.TakeFiles();
  return block;
}

// The blocks of all processes as one, without the files.
Block AddUp(const Block& mine, const Processes& processes)
{
  Block all;
  const std::string own = (mine.anySite ? "1" : "0") + std::to_string(mine.bytes);
  for (const std::string& text : processes.Exchange(own))
  {
    all.anySite = all.anySite || text.front() == '1';
    all.bytes += std::stoull(text.substr(1));
  }
  return all;
}

// The index of all volumes, whichever process made them.
void WriteIndex(
  const fs::path& path, const std::vector<fs::path>& files, const std::vector<Time>& times)
{
  NxvSeries index;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    index.emplace_back(files[i].filename().string(), ToSeconds(times[i]));
  }
  WriteNxvSeries(path, index);
}

// The rest, once all volumes are there.
GridReport Conclude(
  const GridJob& job, const SeriesMerger& merger, Block& mine, const Processes& processes)
{
  const std::vector<Time>& times = merger.Times();
  const Block block = AddUp(mine, processes);
  if (!block.anySite)
  {
    mine.files.Remove();
    throw Error("no radar has a volume within --max-gap of any time asked for, from " +
                FormatIso8601(times.front()) + " to " + FormatIso8601(times.back()));
  }
  GridReport report;
  for (const Time time : times)
  {
    report.files.push_back(job.folder / VolumeFileName(time, job.format));
  }
  report.bytes = block.bytes;
  report.index =
    job.folder / (job.format == VolumeFormat::Nxv ? "volumes.nxv.series" : "volumes.vti.series");
  const bool leavesOut = job.options.method == MergeMethod::Beam; // the thesis takes all rays
  for (const InputProblem& problem : merger.Problems())
  {
    if (!problem.note || leavesOut)
    {
      (problem.note ? report.notes : report.problems).push_back(problem.Line());
    }
  }
  report.comparison = merger.CompareRadars();
  report.takenOff = merger.BiasesTakenOff();
  report.echo = merger.Echo();
  processes.Together([&] { mine.files.Keep(); });
  processes.Together(
    [&]
    {
      if (processes.IsFirst())
      {
        WriteIndex(report.index, report.files, times);
      }
    });
  return report;
}

void RequireDone(bool done)
{
  if (!done)
  {
    throw Error("stopped before all inputs were read");
  }
}

} // namespace

GridReport WriteVolumes(const GridJob& job, const Progress& progress, const Processes& processes)
{
  MergerSetup setup;
  setup.loop = vtkNexradRangeLoop();
  setup.threads = vtkNexradThreadCount();
  setup.processes = processes;
  MergeOptions options = job.options;
  options.compareRadars = true;
  SeriesMerger merger(job.inputs, options, setup);
  RequireDone(merger.Open(ShareOf(progress, 0.0, ScanShare)));
  for (;;)
  {
    Block block;
    const double from = merger.IsScanned() ? ScanShare : 0.0;
    processes.Together(
      [&] { block = WriteBlock(job, merger, ShareOf(progress, from, 1.0), processes); });
    if (merger.Confirm())
    {
      return Conclude(job, merger, block, processes);
    }
    block.files.Remove();
    RequireDone(merger.Scan(ShareOf(progress, 0.0, ScanShare)));
  }
}

} // namespace nexrad::application
