// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeWriter.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"

#include "vtkObjectFactory.h"

#include <filesystem>

vtkStandardNewMacro(vtkNexradVolumeWriter);

vtkNexradVolumeWriter::vtkNexradVolumeWriter() = default;

vtkNexradVolumeWriter::~vtkNexradVolumeWriter() = default;

nexrad::NxvWriteOptions vtkNexradVolumeWriter::MakeOptions() const
{
  nexrad::NxvWriteOptions options;
  options.offset = this->CodeOffset;
  options.scale = this->CodeScale;
  switch (this->Encoding)
  {
  case RADAR_STEPS:
    options.encoding = nexrad::NxvEncoding::RadarSteps;
    break;
  case RUN_LENGTH:
    options.encoding = nexrad::NxvEncoding::RunLength;
    break;
  case RUN_LENGTH_DEFLATED:
    options.encoding = nexrad::NxvEncoding::RunLengthDeflated;
    break;
  case FLOAT:
    options.encoding = nexrad::NxvEncoding::Float;
    break;
  default:
    break;
  }
  return options;
}

void vtkNexradVolumeWriter::BeginSteps()
{
  this->Index.clear();
}

void vtkNexradVolumeWriter::WriteVolume(const nexrad::GriddedVolume& volume)
{
  std::filesystem::path path = this->FileName;
  if (this->IsSeries())
  {
    if (this->RawStream)
    {
      throw nexrad::Error("a series of bare streams cannot be written: name one file");
    }
    const std::string name = nexrad::FormatForFileName(volume.time) + ".nxv";
    path = path.parent_path() / name;
    Attempt([&]() { nexrad::WriteNxv(path, volume, this->MakeOptions()); });
    this->Index.emplace_back(name, nexrad::ToSeconds(volume.time));
  }
  else if (this->RawStream)
  {
    Attempt([&]() { nexrad::WriteRaw(path, volume, this->MakeOptions()); });
  }
  else
  {
    Attempt([&]() { nexrad::WriteNxv(path, volume, this->MakeOptions()); });
  }
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
  os << indent << "CodeScale: " << this->CodeScale << "\n";
  os << indent << "CodeOffset: " << this->CodeOffset << "\n";
  os << indent << "RawStream: " << this->RawStream << "\n";
}
