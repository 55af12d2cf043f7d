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

} // namespace

GridReport WriteVolumes(const GridJob& job, const Progress& progress)
{
  const auto series = OpenRadarFiles(job.inputs, job.options, ShareOf(progress, 0.0, scanShare));
  const Progress merging = ShareOf(progress, scanShare, 1.0);
  const bool nxv = job.format == VolumeFormat::Nxv;
  const std::string extension = nxv ? ".nxv" : ".vti";
  const std::vector<Time>& times = series->Times();
  GridReport report;
  NxvSeries index;
  bool anySite = false;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const auto volume = series->Load(i, ShareOf(merging, i, times.size()));
    if (i == 0)
    {
      MakeFolder(job.folder); // not earlier: a failure so far leaves nothing behind
    }
    const fs::path path = job.folder / (FormatForFileName(times[i]) + extension);
    nxv ? WriteNxvFile(volume, path) : WriteVti(volume, path);
    anySite = anySite || !vtkNexradGetTexts(volume->GetFieldData(), "Sites").empty();
    report.bytes += fs::file_size(path);
    report.files.push_back(path);
    index.emplace_back(path.filename().string(), ToSeconds(times[i]));
  }
  if (!anySite)
  {
    RemoveFiles(report.files);
    throw Error("no radar has a volume within --max-gap of any time asked for, from " +
                FormatIso8601(times.front()) + " to " + FormatIso8601(times.back()));
  }
  report.index = job.folder / ("volumes" + extension + ".series");
  WriteNxvSeries(report.index, index);
  report.problems = series->Problems();
  return report;
}

} // namespace nexrad::application
