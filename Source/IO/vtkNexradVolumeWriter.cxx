// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeWriter.h"

#include "nexrad/Codec/NxvWriter.h"

#include "vtkObjectFactory.h"

#include <optional>

vtkStandardNewMacro(vtkNexradVolumeWriter);

void vtkNexradVolumeWriter::WriteVolume(const nexrad::GriddedVolume& volume)
{
  const std::string path = this->FileOf(volume, ".nxv");
  std::optional<nexrad::NxvEncoding> encoding;
  if (this->Encoding != AUTOMATIC)
  {
    encoding =
      this->Encoding == FLOAT ? nexrad::NxvEncoding::Float : nexrad::NxvEncoding::RadarSteps;
  }
  Attempt([&]() { nexrad::WriteNxv(path, volume, encoding); });
  this->Written.push_back(path);
}

void vtkNexradVolumeWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Encoding: " << this->Encoding << "\n";
}
