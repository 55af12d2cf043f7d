// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/StepWriter.h"

#include "Volumes/VtiFile.h"

namespace fs = std::filesystem;

namespace nexrad::application
{
fs::path VolumeFileName(Time time, VolumeFormat format)
{
  return FormatForFileName(time) + (format == VolumeFormat::Nxv ? ".nxv" : ".vti");
}

StepWriter::StepWriter(
  UnfinishedRun& theRun, VolumeFormat theFormat, const NxvWriteOptions& nxvOptions)
  : run(theRun)
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
  run.Add(name);
  return last;
}

GriddedVolume StepWriter::Write(GriddedVolume volume)
{
  GriddedVolume last = this->TakeLast();
  name = VolumeFileName(volume.time, format).string();
  const auto write = [place = run.PlaceFor(name), as = format, options = nxv](GriddedVolume&& one)
  {
    as == VolumeFormat::Nxv ? WriteNxv(place, one, options) : WriteVti(place, one);
    return std::move(one);
  };
  writing = std::async(std::launch::async | std::launch::deferred, write, std::move(volume));
  return last;
}

void StepWriter::Finish()
{
  this->TakeLast();
}

} // namespace nexrad::application
