// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/WriteVolumes.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/Series/SharedScan.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradNetCDFOutput.h"
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

// The files of all radars, or of one.
struct FileSeries
{
  // What has all times, an index or one file: "volumes.nxv.series", "KEAX.nxv.series"; of one file
  // "volumes.nc", "KEAX.nc".
  std::string name;
  std::vector<std::string> files; // one for each time
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
    const auto changed = ChangedAt(path).time_since_epoch().count();
    recipe +=
      '\n' + path.string() + ' ' + std::to_string(StoredSize(path)) + ' ' + std::to_string(changed);
  }
  return recipe;
}

// How the volume of each time is written. One NetCDF file of all times is made of exact volumes at
// the end of the run: such a file that a killed run left could not be continued.
VolumeFiles FilesOfTimes(const GridJob& job)
{
  VolumeFiles files = job.written;
  if (job.oneFile)
  {
    files.format = VolumeFormat::Nxv;
    files.nxv.encoding = NxvEncoding::Float;
  }
  return files;
}

// Names of the files that a run makes in its folder.
std::vector<FileSeries> SeriesOf(const GridJob& job, const SeriesMerger& merger)
{
  std::vector<FileSeries> all;
  for (const std::string& radar : job.perRadar ? merger.Sites() : std::vector<std::string>{""})
  {
    FileSeries series;
    series.name = (radar.empty() ? "volumes" : radar) + ExtensionOf(job.written.format) +
                  (job.oneFile ? "" : ".series");
    for (const Time time : merger.Times())
    {
      series.files.push_back(VolumeFileName(time, FilesOfTimes(job).format, radar).string());
    }
    all.push_back(std::move(series));
  }
  return all;
}

// Merges and writes the steps of this process that are not there.
class BlockWriter
{
public:
  BlockWriter(const GridJob& theJob, SeriesMerger& theMerger, UnfinishedRun& theRun)
    : job(theJob)
    , merger(theMerger)
    , run(theRun)
    , all(SeriesOf(theJob, theMerger))
    , writer(theRun, FilesOfTimes(theJob))
  {
  }

  // Whether some radar took part in a volume.
  bool Write(const Progress& progress, const Processes& processes)
  {
    const std::vector<Time>& times = merger.Times();
    const auto [begin, end] = processes.Part(times.size());
    if (begin < end)
    {
      merger.EndAt(times[end - 1]);
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      this->Make(i, ShareOf(progress, i - begin, end - begin));
    }
    writer.Finish();
    return anySite;
  }

private:
  using Clock = std::chrono::steady_clock;

  bool HasAll(std::size_t step)
  {
    return std::all_of(all.begin(), all.end(),
      [&](const FileSeries& series) { return run.Has(series.files[step]); });
  }

  void Make(std::size_t step, const Progress& progress)
  {
    const Time time = merger.Times()[step];
    const std::optional<std::size_t> volumes = this->HasAll(step) ? merger.Skip(time, progress)
                                               : job.perRadar     ? this->MakeEach(time, progress)
                                                              : this->MakeMerged(time, progress);
    if (!volumes)
    {
      this->Stop();
    }
    anySite = anySite || *volumes > 0;
    if (Clock::now() - noted > betweenNotes)
    {
      this->Note();
    }
  }

  // Both return how many radars or volumes took part; nothing when asked to stop.
  std::optional<std::size_t> MakeMerged(Time time, const Progress& progress)
  {
    auto volume = merger.Merge(time, progress, {}, std::move(memory));
    if (!volume)
    {
      return std::nullopt;
    }
    const std::size_t radars = volume->sites.size();
    memory = writer.Write(std::move(*volume));
    return radars;
  }

  std::optional<std::size_t> MakeEach(Time time, const Progress& progress)
  {
    return merger.MergeEachRadar(
      time, [this](GriddedVolume volume) { writer.Write(std::move(volume)); }, progress);
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
  const std::vector<FileSeries> all;
  StepWriter writer;
  bool anySite = false;
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

// The index of all volumes, whichever process made them.
void WriteIndex(
  const fs::path& path, const std::vector<std::string>& files, const std::vector<Time>& times)
{
  NxvSeries index;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    index.emplace_back(files[i], ToSeconds(times[i]));
  }
  WriteNxvSeries(path, index);
}

// Appends the volumes of all times, which wait in the run's folder, to one file in their place.
// Returns its size in bytes.
std::uintmax_t JoinFiles(
  const FileSeries& series, const std::string& history, const UnfinishedRun& run)
{
  vtkNexradNetCDFOutput joined(run.PlaceFor(series.name), history);
  NxvReadOptions options;
  options.loop = vtkNexradRangeLoop();
  for (const std::string& file : series.files)
  {
    joined.Add(ReadNxv(run.PlaceFor(file), options));
  }
  joined.Commit();
  for (const std::string& file : series.files)
  {
    std::error_code ignored;
    fs::remove(run.PlaceFor(file), ignored);
  }
  return fs::file_size(run.PlaceFor(series.name));
}

// The last files of a run: indices of the volumes, or files of all times.
void FinishFiles(const GridJob& job, const std::vector<FileSeries>& all,
  const std::vector<Time>& times, UnfinishedRun& run, const Processes& processes,
  GridReport& report)
{
  for (const FileSeries& series : all)
  {
    report.indices.push_back(job.folder / series.name);
    for (const std::string& file : series.files)
    {
      report.files.push_back(job.folder / file);
    }
  }
  if (job.oneFile)
  {
    report.files = report.indices;
    report.bytes = 0;
    processes.Together(
      [&]
      {
        for (const FileSeries& series : all)
        {
          report.bytes += processes.IsFirst() ? JoinFiles(series, job.written.history, run) : 0;
        }
      });
  }
  run.End(
    [&]
    {
      for (std::size_t i = 0; i < all.size() && !job.oneFile; ++i)
      {
        WriteIndex(report.indices[i], all[i].files, times);
      }
    });
}

// The rest, once all volumes are there.
GridReport Conclude(const GridJob& job, const SeriesMerger& merger, bool anySite,
  UnfinishedRun& run, const Processes& processes)
{
  const std::vector<Time>& times = merger.Times();
  const std::vector<FileSeries> all = SeriesOf(job, merger);
  GridReport report;
  for (const FileSeries& series : all)
  {
    for (const std::string& file : series.files)
    {
      report.bytes += run.SizeOf(file); // as long as no process can have ended the run
    }
  }
  if (processes.InAll(!anySite))
  {
    run.Discard();
    throw Error("no radar has a volume within --max-gap of any time asked for, from " +
                FormatIso8601(times.front()) + " to " + FormatIso8601(times.back()));
  }
  for (const InputProblem& problem : merger.Problems())
  {
    report.problems.push_back(problem.Line());
  }
  report.notes = merger.Notes();
  report.comparison = merger.CompareRadars();
  report.takenOff = merger.BiasesTakenOff();
  report.echo = merger.Echo();
  FinishFiles(job, all, times, run, processes, report);
  return report;
}

// Throws Error where the volumes would stand beside others of another grid.
void RequireRoom(const GridJob& job, const SeriesMerger& merger)
{
  if (job.written.format != VolumeFormat::Nxv)
  {
    return;
  }
  std::set<std::string> own;
  for (const FileSeries& series : SeriesOf(job, merger))
  {
    own.insert(series.files.begin(), series.files.end());
    own.insert(series.name);
  }
  RequireSameGrid(job.folder, own, merger.Grid());
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
  setup.use = UseOfWriting(FilesOfTimes(job), job.options);
  MergeOptions options = job.options;
  options.compareRadars = true;
  SeriesMerger merger(job.inputs, options, setup);
  RequireDone(merger.Open(ShareOf(progress, 0.0, ScanShare)));
  processes.Together([&] { RequireRoom(job, merger); });
  UnfinishedRun run(job.folder, RecipeOf(job, merger.Files()), processes);
  LearnFromNotes(run, merger);
  if (job.oneFile)
  {
    run.HoldBack();
  }
  for (;;)
  {
    bool anySite = false;
    const double from = merger.IsScanned() ? ScanShare : 0.0;
    processes.Together([&]
      { anySite = BlockWriter(job, merger, run).Write(ShareOf(progress, from, 1.0), processes); });
    if (merger.Confirm())
    {
      return Conclude(job, merger, anySite, run, processes);
    }
    run.Discard();
    RequireDone(merger.Scan(ShareOf(progress, 0.0, ScanShare)));
  }
}

} // namespace nexrad::application
