// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/WriteVolumes.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Merging/ScannedSteps.h"
#include "nexrad/Merging/StreamedSteps.h"
#include "nexrad/Series/SharedScan.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/ProgressShare.h"
#include "vtkNexradSmpLoop.h"

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

using Merge = std::function<std::optional<GriddedVolume>(
  Time time, const Progress& progress, GriddedVolume memory)>;

// Merges and writes the steps of this process.
Block WriteBlock(const GridJob& job, const std::vector<Time>& times, const Merge& merge,
  const Progress& progress, const Processes& processes)
{
  const auto [begin, end] = processes.Part(times.size());
  StepWriter writer(job.folder, job.format, job.nxv);
  Block block;
  GriddedVolume memory;
  for (std::size_t i = begin; i < end; ++i)
  {
    auto volume = merge(times[i], ShareOf(progress, i - begin, end - begin), std::move(memory));
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
GridReport Conclude(const GridJob& job, const std::vector<Time>& times, Block& mine,
  const std::vector<InputProblem>& problems, const Processes& processes)
{
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
  std::transform(problems.begin(), problems.end(), std::back_inserter(report.problems),
    [](const InputProblem& problem) { return problem.Line(); });
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

// What is known of the inputs before any is decoded.
struct Inputs
{
  InputFiles found;
  std::optional<std::vector<SiteOutline>> outline;
};

Inputs FindInputs(const GridJob& job, const Processes& processes)
{
  Inputs inputs;
  processes.Together(
    [&]
    {
      SeriesOptionsOf(job.options); // throws for what cannot be met, before anything is read
      inputs.found = FindInputFiles(job.inputs);
      inputs.outline = OutlineSeries(inputs.found.paths, job.options.siteName);
    });
  std::string names = inputs.outline ? "outlined" : "unknown";
  for (const fs::path& path : inputs.found.paths)
  {
    names += '\n' + path.filename().string();
  }
  const std::vector<std::string> all = processes.Exchange(names);
  if (std::any_of(all.begin(), all.end(), [&](const std::string& other) { return other != names; }))
  {
    throw Error("the processes do not find the same input files; all need the same folders");
  }
  return inputs;
}

// True when it is true in all processes.
bool InAll(bool mine, const Processes& processes)
{
  const std::vector<std::string> all = processes.Exchange(mine ? "1" : "0");
  return std::all_of(all.begin(), all.end(), [](const std::string& each) { return each == "1"; });
}

// What all processes decoded, in the order of the inputs.
SeriesScan GatherScans(const Inputs& inputs, const StreamedSteps& steps, const Processes& processes)
{
  std::vector<ScannedFile> files(inputs.found.paths.size());
  for (const std::string& message : processes.Exchange(PackScannedFiles(steps.Scanned())))
  {
    std::vector<ScannedFile> part = UnpackScannedFiles(message);
    for (std::size_t i = 0; i < part.size(); ++i)
    {
      if (files[i].volumes.empty() && files[i].problems.empty())
      {
        files[i] = std::move(part[i]);
      }
    }
  }
  return CollectSeries(inputs.found.problems, files);
}

// Decodes, merges and writes side by side. Empty when the files' headers err, with nothing left
// behind.
std::optional<GridReport> WriteStreamed(
  const GridJob& job, const Inputs& inputs, const Progress& progress, const Processes& processes)
{
  std::unique_ptr<StreamedSteps> steps;
  bool planned = false;
  processes.Together(
    [&]
    {
      steps = std::make_unique<StreamedSteps>(
        inputs.found, *inputs.outline, job.options, vtkNexradSmpLoop(), vtkNexradThreadCount());
      planned = steps->Plan();
    });
  if (!InAll(planned, processes))
  {
    return std::nullopt;
  }
  Block block;
  processes.Together(
    [&]
    {
      const auto [begin, end] = processes.Part(steps->Times().size());
      if (begin < end)
      {
        steps->EndAt(steps->Times()[end - 1]);
      }
      const auto merge = [&](Time time, const Progress& share, GriddedVolume memory)
      { return steps->Merge(time, share, std::move(memory)); };
      block = WriteBlock(job, steps->Times(), merge, progress, processes);
    });
  const SeriesScan scan = GatherScans(inputs, *steps, processes);
  if (!InAll(steps->IsAsIn(scan), processes))
  {
    block.files.Remove();
    return std::nullopt;
  }
  return Conclude(job, steps->Times(), block, scan.problems, processes);
}

// Decodes all files first.
GridReport WriteScanned(const GridJob& job, const Progress& progress, const Processes& processes)
{
  ScanShare share;
  share.rank = processes.Rank();
  share.count = processes.Count();
  share.exchange = [&processes](const std::string& mine) { return processes.Exchange(mine); };
  ScannedSteps steps(
    job.inputs, job.options, vtkNexradSmpLoop(), share, ShareOf(progress, 0.0, scanShare));
  processes.Together([&] { steps.Plan(); }); // nobody writes before all know what to write
  Block block;
  processes.Together(
    [&]
    {
      const auto merge = [&](Time time, const Progress& part, GriddedVolume)
      { return steps.Merge(time, part); };
      block = WriteBlock(job, steps.Times(), merge, ShareOf(progress, scanShare, 1.0), processes);
    });
  return Conclude(job, steps.Times(), block, steps.Problems(), processes);
}

} // namespace

GridReport WriteVolumes(const GridJob& job, const Progress& progress, const Processes& processes)
{
  const Inputs inputs = FindInputs(job, processes);
  if (inputs.outline)
  {
    if (auto report = WriteStreamed(job, inputs, progress, processes))
    {
      return *report;
    }
  }
  return WriteScanned(job, progress, processes);
}

} // namespace nexrad::application
