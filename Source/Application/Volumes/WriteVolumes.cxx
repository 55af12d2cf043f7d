// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/WriteVolumes.h"

#include "Volumes/OtherVolumes.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/Series/SharedScan.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradThreads.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

// What one process makes, or all of them together.
struct Block
{
  std::uintmax_t bytes = 0;
  bool anySite = false; ///< some radar took part in a volume
};

// The recipe of a job with its input files: a file that changed makes another recipe.
std::string RecipeOf(const GridJob& job, const std::vector<fs::path>& files)
{
  if (job.recipe.empty())
  {
    return {};
  }
  std::string recipe = job.recipe;
  for (const fs::path& path : files)
  {
    std::error_code ignored;
    const auto changed = fs::last_write_time(path, ignored).time_since_epoch().count();
    const std::uintmax_t size = fs::is_directory(path, ignored) ? 0 : fs::file_size(path, ignored);
    recipe += '\n' + path.string() + ' ' + std::to_string(size) + ' ' + std::to_string(changed);
  }
  return recipe;
}

// Merges and writes the steps of this process that are not there.
class BlockWriter
{
public:
  BlockWriter(const GridJob& theJob, SeriesMerger& theMerger, UnfinishedRun& theRun)
    : job(theJob)
    , merger(theMerger)
    , run(theRun)
    , writer(theRun, theJob.format, theJob.nxv)
  {
  }

  Block Write(const Progress& progress, const Processes& processes)
  {
    const std::vector<Time>& times = merger.Times();
    const auto [begin, end] = processes.Part(times.size());
    if (begin < end)
    {
      merger.EndAt(times[end - 1]);
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      this->Make(times[i], ShareOf(progress, i - begin, end - begin));
    }
    writer.Finish();
    for (std::size_t i = begin; i < end; ++i)
    {
      block.bytes += run.SizeOf(this->NameOf(times[i]));
    }
    return block;
  }

private:
  using Clock = std::chrono::steady_clock;

  std::string NameOf(Time time) const { return VolumeFileName(time, job.format).string(); }

  void Make(Time time, const Progress& progress)
  {
    if (run.Has(this->NameOf(time)))
    {
      const std::optional<std::size_t> volumes = merger.Skip(time, progress);
      if (!volumes)
      {
        this->Stop();
      }
      block.anySite = block.anySite || *volumes > 0;
      return;
    }
    auto volume = merger.Merge(time, progress, {}, std::move(memory));
    if (!volume)
    {
      this->Stop();
    }
    block.anySite = block.anySite || !volume->sites.empty();
    memory = writer.Write(std::move(*volume));
    if (Clock::now() - noted > betweenNotes)
    {
      this->Note();
    }
  }

  // What the files hold, a run that continues this one need not find out again.
  void Note()
  {
    if (!job.recipe.empty())
    {
      run.Note(PackScannedFiles(merger.KnownFiles()));
      noted = Clock::now();
    }
  }

  [[noreturn]] void Stop()
  {
    writer.Finish();
    this->Note();
    throw Error("stopped before all volumes were made; the same command makes the rest");
  }

  static constexpr auto betweenNotes = std::chrono::seconds(5);

  const GridJob& job;
  SeriesMerger& merger;
  UnfinishedRun& run;
  StepWriter writer;
  Block block;
  GriddedVolume memory;
  Clock::time_point noted = Clock::now();
};

// Tells the merger what the interrupted run knew of the files. What cannot be read is found out
// again.
void LearnFromNotes(const UnfinishedRun& run, SeriesMerger& merger)
{
  for (const std::string& note : run.Notes())
  {
    try
    {
      merger.LearnFiles(UnpackScannedFiles(note));
    }
    catch (const Error&)
    {
      continue;
    }
  }
}

// The blocks of all processes as one.
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
GridReport Conclude(const GridJob& job, const SeriesMerger& merger, const Block& mine,
  UnfinishedRun& run, const Processes& processes)
{
  const std::vector<Time>& times = merger.Times();
  const Block block = AddUp(mine, processes);
  if (!block.anySite)
  {
    run.Discard();
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
  run.End([&] { WriteIndex(report.index, report.files, times); });
  return report;
}

// Throws Error where the volumes would stand beside others of another grid.
void RequireRoom(const GridJob& job, const SeriesMerger& merger)
{
  std::set<std::string> own;
  for (const Time time : merger.Times())
  {
    own.insert(VolumeFileName(time, job.format).string());
  }
  RequireSameGrid(job.folder, job.format, own, merger.Grid());
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
  processes.Together([&] { RequireRoom(job, merger); });
  UnfinishedRun run(job.folder, RecipeOf(job, merger.Files()), processes);
  LearnFromNotes(run, merger);
  for (;;)
  {
    Block block;
    const double from = merger.IsScanned() ? ScanShare : 0.0;
    processes.Together([&]
      { block = BlockWriter(job, merger, run).Write(ShareOf(progress, from, 1.0), processes); });
    if (merger.Confirm())
    {
      return Conclude(job, merger, block, run, processes);
    }
    run.Discard();
    RequireDone(merger.Scan(ShareOf(progress, 0.0, ScanShare)));
  }
}

} // namespace nexrad::application
