// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/WriteVolumes.h"

#include "Volumes/UnfinishedRun.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/Series/Steps.h"
#include "nexrad/System/Error.h"
#include "vtkNexradNetCDFOutput.h"
#include "vtkNexradThreads.h"

#include <algorithm>
#include <exception>
#include <future>
#include <limits>
#include <set>
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

// How the volume of each time is written. One NetCDF file of all times is made of exact volumes at
// the end of the run: such a file that a killed run left could not be continued. Bricks hold merged
// volumes alone.
VolumeFiles FilesOfTimes(const GridJob& job)
{
  VolumeFiles files = job.written;
  if (job.oneFile || job.perRadar)
  {
    files.largestWhole = std::numeric_limits<std::size_t>::max();
  }
  if (job.oneFile)
  {
    files.format = VolumeFormat::Nxv;
    files.encoding = NxvEncoding::Float;
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

// Whether several processes make each volume together; else each makes volumes of its own.
bool ShareEachVolume(const GridJob& job, const Processes& processes)
{
  return processes.Count() > 1 && AreInBricks(FilesOfTimes(job), job.options);
}

// The rows that the process of a rank makes; none where there are more processes than parts.
VoxelBlock RowsOf(const GridSpecification& grid, const Processes& processes, std::size_t rank)
{
  VoxelBlock rows = VoxelBlock::Of(grid);
  const int height = rows.end[1];
  const auto parts = static_cast<std::size_t>((height - 1) / NxvBandWriter::PartRows + 1);
  const auto [begin, end] = processes.PartOf(parts, rank);
  rows.begin[1] = std::min(static_cast<int>(begin) * NxvBandWriter::PartRows, height);
  rows.end[1] = std::min(static_cast<int>(end) * NxvBandWriter::PartRows, height);
  return rows;
}

// Merges rows of a volume into a file for NxvBandWriter::AddPart; without rows into none. False
// when `progress` asked to stop.
bool WriteRows(SeriesMerger& merger, Time time, const VoxelBlock& rows, const fs::path& place,
  std::optional<NxvEncoding> encoding, const Progress& progress)
{
  if (rows.Size(1) == 0)
  {
    return true;
  }
  NxvBandWriter bricks(place, merger.Grid(), rows, encoding);
  if (!merger.MergeInBands(time, NxvBandWriter::Rows, PackInto(bricks), progress, rows))
  {
    return false;
  }
  bricks.Commit();
  return true;
}

// Merges and writes the steps of this process that are due.
class BlockWriter
{
public:
  BlockWriter(const GridJob& theJob, SeriesMerger& theMerger, UnfinishedRun& theRun,
    Steps& theSteps, const Processes& theProcesses)
    : job(theJob)
    , merger(theMerger)
    , run(theRun)
    , steps(theSteps)
    , processes(theProcesses)
    , all(SeriesOf(theJob, theMerger))
    , part(theProcesses.Part(theMerger.Times().size()))
    , ofTimes(FilesOfTimes(theJob))
  {
  }

  // All processes call it.
  void Write(const Progress& progress)
  {
    if (ShareEachVolume(job, processes))
    {
      this->WriteShared(progress);
      return;
    }
    processes.Together([&] { this->WriteOwn(progress); });
  }

  // By what is known of the files now, which may be more than when the step was made.
  bool HasDue() const
  {
    const auto first = merger.Times().begin();
    return std::any_of(first + part.first, first + part.second,
      [this](const Time time) { return steps.IsDue(time, merger.MadeOf(time)); });
  }

private:
  void WriteOwn(const Progress& progress)
  {
    const auto [begin, end] = part;
    if (begin < end)
    {
      merger.EndAt(merger.Times()[end - 1]);
    }
    for (std::size_t i = begin; i < end; ++i)
    {
      this->Make(i, ShareOf(progress, i - begin, end - begin));
    }
    this->FinishWriting();
  }

  // Each process makes rows of each volume, and the first one joins them.
  void WriteShared(const Progress& progress)
  {
    constexpr double decoding = 0.3; // of the work
    const std::size_t count = merger.Times().size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const Progress own = ShareOf(progress, i, count);
      merger.EndAt(merger.Times()[i]); // nobody decodes ahead what others may decode as well
      this->StopUnless(merger.KnowTogether(merger.Times()[i], ShareOf(own, 0.0, decoding)));
      bool isThere = false;
      processes.Together([&] { isThere = this->IsThere(i, own); });
      if (!processes.InAll(isThere))
      {
        processes.Together([&] { this->MakeRows(i, ShareOf(own, decoding, 1.0)); });
        processes.Together([&] { this->JoinRows(i); });
      }
    }
  }

  // The hidden file of the rows of a process.
  fs::path PlaceForRows(std::size_t step, std::size_t rank) const
  {
    return run.PlaceFor("." + all.front().files[step] + ".part-" + std::to_string(rank));
  }

  void MakeRows(std::size_t step, const Progress& progress)
  {
    const std::size_t rank = processes.Rank();
    this->StopUnless(WriteRows(merger, merger.Times()[step], RowsOf(merger.Grid(), processes, rank),
      this->PlaceForRows(step, rank), job.written.encoding, progress));
  }

  // The first process joins them; to the others the step is made then as well.
  void JoinRows(std::size_t step)
  {
    const Time time = merger.Times()[step];
    if (!processes.IsFirst())
    {
      steps.Make(time, merger.MadeOf(time));
      return;
    }
    const std::string& name = all.front().files[step];
    NxvBandWriter bricks(run.PlaceFor(name), merger.Grid(), job.written.encoding);
    for (std::size_t rank = 0; rank < processes.Count(); ++rank)
    {
      if (RowsOf(merger.Grid(), processes, rank).Size(1) > 0)
      {
        bricks.AddPart(this->PlaceForRows(step, rank), vtkNexradRangeLoop());
        fs::remove(this->PlaceForRows(step, rank));
      }
    }
    this->Begin(step, merger.MadeOf(time));
    bricks.Commit();
    run.Add(name);
  }

  bool IsThere(std::size_t step, const Progress& progress)
  {
    const bool written = std::all_of(all.begin(), all.end(),
      [&](const FileSeries& series) { return run.Has(series.files[step]); });
    const Time time = merger.Times()[step];
    this->StopUnless(!written || merger.Know(time, progress));
    return written && !steps.IsDue(time, merger.MadeOf(time));
  }

  void Make(std::size_t step, const Progress& progress)
  {
    if (!this->IsThere(step, progress))
    {
      job.perRadar ? this->MakeEach(step, progress) : this->MakeMerged(step, progress);
    }
  }

  void MakeInBricks(std::size_t step, const Progress& progress)
  {
    const std::string& name = all.front().files[step];
    NxvBandWriter bricks(run.PlaceFor(name), merger.Grid(), job.written.encoding);
    this->Begin(step,
      job.task ? this->JoinTasks(step, bricks, progress) : this->MergeInto(step, bricks, progress));
    bricks.Commit();
    run.Add(name);
  }

  // Both return what the volume is made of.
  std::string MergeInto(std::size_t step, NxvBandWriter& bricks, const Progress& progress)
  {
    this->StopUnless(
      merger.MergeInBands(merger.Times()[step], NxvBandWriter::Rows, PackInto(bricks), progress));
    return this->LastMadeOf(step);
  }

  std::string JoinTasks(std::size_t step, NxvBandWriter& bricks, const Progress& progress)
  {
    const Time time = merger.Times()[step];
    this->StopUnless(merger.Know(time, progress));
    std::string made = merger.MadeOf(time);
    const TaskFolder tasks(job.folder, job.recipe);
    for (const fs::path& rows : tasks.RowsOf(all.front().files[step], made))
    {
      bricks.AddPart(rows, vtkNexradRangeLoop());
    }
    return made;
  }

  void MakeMerged(std::size_t step, const Progress& progress)
  {
    if (AreInBricks(ofTimes, job.options))
    {
      this->MakeInBricks(step, progress);
      return;
    }
    auto volume = merger.Merge(merger.Times()[step], progress, {}, std::move(memory));
    this->StopUnless(volume.has_value());
    this->Begin(step, this->LastMadeOf(step));
    memory = this->StartWriting(std::move(*volume));
  }

  void MakeEach(std::size_t step, const Progress& progress)
  {
    bool begun = false;
    const auto write = [&](GriddedVolume volume)
    {
      if (!std::exchange(begun, true))
      {
        this->Begin(step, this->LastMadeOf(step));
      }
      this->StartWriting(std::move(volume));
    };
    this->StopUnless(merger.MergeEachRadar(merger.Times()[step], write, progress));
  }

  // Writes a volume on another thread when the one before is there; returns that, whose arrays are
  // free again.
  GriddedVolume StartWriting(GriddedVolume volume)
  {
    GriddedVolume last = this->FinishWriting();
    const std::string radar = volume.ofOneRadar ? volume.sites.front() : "";
    name = VolumeFileName(volume.time, ofTimes.format, radar).string();
    const auto write = [place = run.PlaceFor(name), as = ofTimes](GriddedVolume&& one)
    {
      if (as.format == VolumeFormat::Nxv)
      {
        WriteNxv(place, one, as.encoding);
      }
      else
      {
        vtkNexradWriteNetCDF(place, one, as.history);
      }
      return std::move(one);
    };
    writing = std::async(std::launch::async | std::launch::deferred, write, std::move(volume));
    return last;
  }

  GriddedVolume FinishWriting()
  {
    if (!writing.valid())
    {
      return {};
    }
    GriddedVolume last = writing.get();
    run.Add(name);
    return last;
  }

  std::string LastMadeOf(std::size_t step) const { return merger.LastMadeOf(merger.Times()[step]); }

  // A file that is there was written after it was kept of what: whenever the run ends, a file of
  // something else is gone.
  void Begin(std::size_t step, const std::string& made)
  {
    for (const FileSeries& series : all)
    {
      run.Remove(series.files[step]);
    }
    const Time time = merger.Times()[step];
    steps.Make(time, made);
    Steps own;
    own.Make(time, made);
    this->Keep(own);
  }

  // What the files hold, a run that continues this one need not find out again.
  void Keep(const Steps& made) { run.Keep(made.Pack() + '\n' + merger.KnownFiles()); }

  void StopUnless(bool goesOn)
  {
    if (!goesOn)
    {
      this->FinishWriting();
      this->Keep({});
      throw Error("stopped before all volumes were made; the same command makes the rest");
    }
  }

  const GridJob& job;
  SeriesMerger& merger;
  UnfinishedRun& run;
  Steps& steps;
  const Processes& processes;
  const std::vector<FileSeries> all;
  const std::pair<std::size_t, std::size_t> part; // of this process
  const VolumeFiles ofTimes;
  std::string name;                   // of the volume that is being written
  std::future<GriddedVolume> writing; // the volume comes back
  GriddedVolume memory;
};

// What the interrupted run made, and knew of the files. What cannot be read is found out again.
void TakeUp(const UnfinishedRun& run, SeriesMerger& merger, Steps& steps)
{
  for (const std::string& record : run.Kept())
  {
    try
    {
      const std::size_t line = std::min(record.find('\n'), record.size());
      steps.Unpack(record.substr(0, line));
      merger.LearnFiles(record.substr(line + 1));
    }
    catch (const std::exception&)
    {
      continue;
    }
  }
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
        WriteVolumeIndex(report.indices[i], all[i].files, times);
      }
    });
}

// The rest, once all volumes are there.
GridReport Conclude(
  const GridJob& job, const SeriesMerger& merger, UnfinishedRun& run, const Processes& processes)
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
  if (processes.InAll(!merger.TakesVolumes()))
  {
    run.Discard();
    throw Error("no radar has a volume within --max-gap of any time asked for, from " +
                FormatIso8601(times.front()) + " to " + FormatIso8601(times.back()));
  }
  report.problems = ProblemLines(merger.Problems());
  report.notes = merger.Notes();
  report.comparison = merger.CompareRadars();
  report.takenOff = merger.BiasesTakenOff();
  report.echo = merger.Echo();
  FinishFiles(job, all, times, run, processes, report);
  return report;
}

// Names of all files of a run.
std::set<std::string> NamesOf(const GridJob& job, const SeriesMerger& merger)
{
  std::set<std::string> names;
  for (const FileSeries& series : SeriesOf(job, merger))
  {
    names.insert(series.files.begin(), series.files.end());
    names.insert(series.name);
  }
  return names;
}

void RequireDone(bool done)
{
  if (!done)
  {
    throw Error("stopped before all inputs were read");
  }
}

// A task that tells the others what a part of the files hold.
GridReport ScanPart(const GridJob& job, SeriesMerger& merger, const Progress& progress)
{
  RequireDone(merger.KnowPart(job.task->part, job.task->parts, progress));
  GridReport report;
  report.files = {TaskFolder(job.folder, job.recipe).PutKnown(*job.task, merger.KnownFiles())};
  return report;
}

// A task that makes rows of each volume, for the one that joins them.
GridReport MakeRows(const GridJob& job, SeriesMerger& merger, const Progress& progress)
{
  const TaskFolder folder(job.folder, job.recipe);
  RequireDone(merger.Open(ShareOf(progress, 0.0, ScanShare)));
  const Progress making = ShareOf(progress, ScanShare, 1.0);
  const VoxelBlock rows =
    RowsOf(merger.Grid(), Processes(job.task->part, job.task->parts, {}), job.task->part);
  const std::vector<Time>& times = merger.Times();
  GridReport report;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const std::string name = VolumeFileName(times[i], job.written.format).string();
    const fs::path place = folder.PlaceForRows(name, *job.task);
    merger.EndAt(times[i]);
    RequireDone(merger.Know(times[i]) && WriteRows(merger, times[i], rows, place,
                                           job.written.encoding, ShareOf(making, i, times.size())));
    folder.PutMade(name, *job.task, merger.MadeOf(times[i]));
    report.files.push_back(place);
  }
  if (!merger.Settle())
  {
    throw Error("some files hold other radars or times than their headers say: make these volumes "
                "without --task");
  }
  return report;
}

MergerSetup SetupOf(const GridJob& job, const Processes& processes)
{
  MergerSetup setup;
  setup.loop = vtkNexradRangeLoop();
  setup.threads = vtkNexradThreadCount();
  setup.processes = processes;
  setup.sharesBlocks = job.task || ShareEachVolume(job, processes);
  setup.order = setup.sharesBlocks ? ScanOrder::ByLatitude : ScanOrder::ByTime;
  if (job.task && job.task->kind != GridTask::Kind::Scan)
  {
    setup.known = TaskFolder(job.folder, job.recipe).Known();
  }
  return setup;
}

// Throws Error for a task that divides nothing.
void CheckTask(const GridJob& job, const Processes& processes)
{
  if (job.task && !AreInBricks(FilesOfTimes(job), job.options))
  {
    throw Error(
      "--task divides volumes in bricks alone: merged, nxv, of more than 134 million voxels");
  }
  if (job.task && processes.Count() > 1)
  {
    throw Error("--task is of one process; start the tasks one by one, without mpiexec");
  }
}

} // namespace

GridReport WriteVolumes(const GridJob& job, const Progress& progress, const Processes& processes)
{
  CheckTask(job, processes);
  MergerSetup setup = SetupOf(job, processes);
  // Where some do other things than the others, all would wait for each other in two places.
  processes.RequireSame(setup.sharesBlocks ? "shared\n" + job.recipe : std::string(),
    "the processes do not make the same volumes; all need the same options");
  MergeOptions options = job.options;
  options.compareRadars = true;
  options.beam.codes = AreCodes(FilesOfTimes(job), options);
  setup.use = UseOfWriting(FilesOfTimes(job), options);
  SeriesMerger merger(job.inputs, options, setup);
  const bool isPart = job.task && job.task->kind != GridTask::Kind::Join;
  if (isPart)
  {
    return job.task->kind == GridTask::Kind::Scan ? ScanPart(job, merger, progress)
                                                  : MakeRows(job, merger, progress);
  }
  RequireDone(merger.Open(ShareOf(progress, 0.0, ScanShare)));
  const std::set<std::string> names = NamesOf(job, merger);
  processes.Together(
    [&]
    {
      if (job.written.format == VolumeFormat::Nxv)
      {
        RequireSameGrid(job.folder, names, merger.Grid());
      }
    });
  UnfinishedRun run(job.folder, job.recipe, processes);
  Steps steps;
  TakeUp(run, merger, steps);
  processes.Together([&] { processes.IsFirst() ? run.KeepOnly(names) : void(); });
  if (job.oneFile)
  {
    run.HoldBack();
  }
  for (;;)
  {
    BlockWriter writer(job, merger, run, steps, processes);
    const double from = merger.IsScanned() ? ScanShare : 0.0;
    writer.Write(ShareOf(progress, from, 1.0));
    if (!merger.Settle())
    {
      run.Discard();
      RequireDone(merger.Scan(ShareOf(progress, 0.0, ScanShare)));
    }
    else if (processes.InAll(!writer.HasDue()))
    {
      GridReport report = Conclude(job, merger, run, processes);
      job.task ? TaskFolder(job.folder, job.recipe).Remove() : void();
      return report;
    }
  }
}

} // namespace nexrad::application
