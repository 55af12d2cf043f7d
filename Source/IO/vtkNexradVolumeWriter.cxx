// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeWriter.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"

#include "vtkObjectFactory.h"

#include <filesystem>

vtkStandardNewMacro(vtkNexradVolumeWriter);

vtkNexradVolumeWriter::vtkNexradVolumeWriter() = default;

vtkNexradVolumeWriter::~vtkNexradVolumeWriter() = default;

void vtkNexradVolumeWriter::BeginSteps()
{
  this->Index.clear();
}

void vtkNexradVolumeWriter::WriteVolume(const nexrad::GriddedVolume& volume)
{
  std::filesystem::path path = this->FileName;
  if (this->IsSeries())
  {
    const std::string name = nexrad::FormatForFileName(volume.time) + ".nxv";
    path = path.parent_path() / name;
    this->Index.emplace_back(name, nexrad::ToSeconds(volume.time));
  }
  nexrad::NxvWriteOptions options;
  if (this->Encoding != AUTOMATIC)
  {
    options.encoding =
      this->Encoding == FLOAT ? nexrad::NxvEncoding::Float : nexrad::NxvEncoding::RadarSteps;
  }
  Attempt([&]() { nexrad::WriteNxv(path, volume, options); });
  this->Written.push_back(path.string());
}

void vtkNexradVolumeWriter::EndSteps()
{
  if (this->IsSeries())
  {
    Attempt([this]() { nexrad::WriteNxvSeries(this->FileName, this->Index); });
    this->Written.emplace_back(this->FileName);
  }
}

void vtkNexradVolumeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
}
