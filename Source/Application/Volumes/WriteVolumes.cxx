// SPDX-License-Identifier: BSD-3-Clause
#include "WriteVolumes.h"

#include "Codec/NxvFile.h"
#include "Model/Error.h"
#include "OutputFile.h"
#include "ProgressShare.h"
#include "VolumeSeries.h"
#include "VtkMessages.h"
#include "vtkNexradFieldData.h"
#include "vtkNexradVolumeWriter.h"

#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkXMLImageDataWriter.h>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

void WriteVti(vtkImageData* volume, const fs::path& path)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  VtkMessages messages;
  messages.Watch(writer);
  writer->SetInputData(volume);
  // To memory first: VTK's writer leaves a cut file behind when the disk is full.
  writer->WriteToOutputStringOn();
  writer->Write();
  messages.ThrowFirstError();
  const std::string bytes = writer->GetOutputString();
  WriteFile(path, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

void WriteNxvFile(vtkImageData* volume, const fs::path& path)
{
  vtkNew<vtkNexradVolumeWriter> writer;
  VtkMessages messages;
  messages.Watch(writer);
  writer->SetInputData(volume);
  writer->SetFileName(path.c_str());
  const bool written = writer->Write() != 0;
  messages.ThrowFirstError();
  if (!written)
  {
    throw Error(path.string() + ": cannot be written");
  }
}

void RemoveFiles(const std::vector<fs::path>& files)
{
  for (const fs::path& file : files)
  {
    std::error_code ignored;
    fs::remove(file, ignored);
  }
}

// What one process makes.
struct Block
{
  std::vector<fs::path> files;
  std::uintmax_t bytes = 0;
  bool anySite = false; ///< some radar took part in a volume
};

fs::path PathOf(const GridJob& job, Time time)
{
  return job.folder /
         (FormatForFileName(time) + (job.format == VolumeFormat::Nxv ? ".nxv" : ".vti"));
}

Block WriteBlock(
  const GridJob& job, VolumeSeries& series, const Progress& progress, const Processes& processes)
{
  const auto [begin, end] = processes.Part(series.Times().size());
  Block block;
  for (std::size_t i = begin; i < end; ++i)
  {
    const auto volume = series.Load(i, ShareOf(progress, i - begin, end - begin));
    if (i == begin)
    {
      MakeFolder(job.folder); // not earlier: a failure so far leaves nothing behind
    }
    const fs::path path = PathOf(job, series.Times()[i]);
    job.format == VolumeFormat::Nxv ? WriteNxvFile(volume, path) : WriteVti(volume, path);
    block.anySite = block.anySite || !vtkNexradGetTexts(volume->GetFieldData(), "Sites").empty();
    block.bytes += fs::file_size(path);
    block.files.push_back(path);
  }
  return block;
}

// The blocks of all processes as one; the files are those of this process.
Block AddUp(const Block& mine, const Processes& processes)
{
  Block all;
  all.files = mine.files;
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

} // namespace

GridReport WriteVolumes(const GridJob& job, const Progress& progress, const Processes& processes)
{
  std::unique_ptr<VolumeSeries> series;
  Block block;
  processes.Together(
    [&]
    {
      series =
        OpenRadarFiles(job.inputs, job.options, ShareOf(progress, 0.0, scanShare), processes);
      block = WriteBlock(job, *series, ShareOf(progress, scanShare, 1.0), processes);
    });
  block = AddUp(block, processes);
  const std::vector<Time>& times = series->Times();
  if (!block.anySite)
  {
    RemoveFiles(block.files);
    throw Error("no radar has a volume within --max-gap of any time asked for, from " +
                FormatIso8601(times.front()) + " to " + FormatIso8601(times.back()));
  }
  GridReport report;
  for (const Time time : times)
  {
    report.files.push_back(PathOf(job, time));
  }
  report.bytes = block.bytes;
  report.index =
    job.folder / (job.format == VolumeFormat::Nxv ? "volumes.nxv.series" : "volumes.vti.series");
  report.problems = series->Problems();
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

} // namespace nexrad::application
