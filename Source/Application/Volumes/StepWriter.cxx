// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/StepWriter.h"

#include "Output/OutputFile.h"
#include "Volumes/VtiFile.h"

namespace fs = std::filesystem;

namespace nexrad::application
{
fs::path VolumeFileName(Time time, VolumeFormat format)
{
  return FormatForFileName(time) + (format == VolumeFormat::Nxv ? ".nxv" : ".vti");
}

StepWriter::StepWriter(fs::path toFolder, VolumeFormat theFormat, const NxvWriteOptions& nxvOptions)
  : folder(std::move(toFolder))
  , format(theFormat)
  , nxv(nxvOptions)
{
}

GriddedVolume StepWriter::TakeLast()
{
  if (!writing.valid())
  {
    return {};
  }
  GriddedVolume last = writing.get();
  bytes += fs::file_size(place);
  return last;
}

GriddedVolume StepWriter::Write(GriddedVolume volume)
{
  GriddedVolume last = this->TakeLast();
  if (files.IsEmpty())
  {
    MakeFolder(folder); // not earlier: a failure so far leaves nothing behind
  }
  const fs::path path = folder / VolumeFileName(volume.time, format);
  place = WrittenFiles::PlaceFor(path);
  files.Add(place, path); // now, so that it is not forgotten when the next step fails
  const auto write = [path = place, as = format, options = nxv](GriddedVolume&& one)
  {
    as == VolumeFormat::Nxv ? WriteNxv(path, one, options) : WriteVti(path, one);
    return std::move(one);
  };
  writing = std::async(std::launch::async, write, std::move(volume));
  return last;
}

void StepWriter::Finish()
{
  this->TakeLast();
}

} // namespace nexrad::application
