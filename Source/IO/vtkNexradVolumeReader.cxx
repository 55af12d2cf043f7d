// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeReader.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"
#include "vtkNexradArrayChoice.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradVolumeFile.h"
#include "vtkNexradVolumeSteps.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

vtkStandardNewMacro(vtkNexradVolumeReader);

vtkNexradVolumeReader::vtkNexradVolumeReader() = default;

vtkNexradVolumeReader::~vtkNexradVolumeReader() = default;

int vtkNexradVolumeReader::CanReadFile(const char* path)
{
  if (vtkNexradPathError(path) != vtkErrorCode::NoError || std::filesystem::is_directory(path))
  {
    return 0;
  }
  try
  {
    if (vtkNexradIsIndex(path))
    {
      vtkNexradListedSteps(path);
      return 1;
    }
  }
  catch (const nexrad::Error&)
  {
    return 0;
  }
  std::array<char, 4> magic{};
  std::ifstream(path, std::ios::binary).read(magic.data(), magic.size());
  return std::string(magic.data(), magic.size()) == "NXV1" ? 1 : 0;
}

// What the file name stands for when it is a bare stream, without values.
nexrad::GriddedVolume vtkNexradVolumeReader::BareVolume() const
{
  nexrad::GriddedVolume volume;
  std::copy_n(this->RawDimensions, 3, volume.grid.dimensions.begin());
  std::copy_n(this->RawOrigin, 3, volume.grid.origin.begin());
  std::copy_n(this->RawSpacing, 3, volume.grid.spacing.begin());
  volume.fill = 0.0F;
  return volume;
}

vtkNexradVolumeSteps vtkNexradVolumeReader::ListSteps()
{
  const std::filesystem::path path = this->FileName;
  vtkNexradVolumeSteps steps;
  if (this->RawStream)
  {
    steps.Steps.push_back({0.0, path});
    steps.HasTimes = false;
    steps.Grid = this->BareVolume().grid;
    return steps;
  }
  steps.Steps = vtkNexradListedSteps(path);
  const std::filesystem::path firstFile = steps.Steps.front().File;
  const nexrad::GriddedVolume first = nexrad::ReadNxvHeader(firstFile);
  if (!vtkNexradIsIndex(path))
  {
    steps.Steps.front().Time = nexrad::ToSeconds(first.time);
  }
  steps.Grid = first.grid;
  steps.OfOneRadar = first.ofOneRadar;
  steps.Ancillary = nexrad::ReadNxvAncillaryArrayNames(firstFile);
  nexrad::NxvReadOptions options;
  options.moments = vtkNexradMomentsToRead(this->Moments);
  steps.AsCodes = this->ScalarsAsCodes && nexrad::HasNxvCodes(firstFile, options);
  return steps;
}

void vtkNexradVolumeReader::ReadStep(const vtkNexradVolumeStep& step, vtkImageData* image)
{
  if (this->RawStream)
  {
    vtkNexradVolumeToImage(nexrad::ReadRaw(step.File, this->BareVolume()), image);
    return;
  }
  if (nexrad::ReadNxvHeader(step.File).grid != this->OpenedSteps().Grid)
  {
    throw nexrad::Error(
      step.File.string() + ": its grid is not that of the first volume of the series");
  }
  vtkNexradReadVolumeFile(
    {step.File.string(), vtkNexradNamesToLeaveOut(this->GetAncillaryArraySelection()),
      vtkNexradMomentsToRead(this->Moments), this->ScalarsAsCodes},
    image);
}

void vtkNexradVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ScalarsAsCodes: " << this->ScalarsAsCodes << "\n";
  os << indent << "RawStream: " << this->RawStream << "\n";
  os << indent << "RawDimensions: " << this->RawDimensions[0] << ", " << this->RawDimensions[1]
     << ", " << this->RawDimensions[2] << "\n";
  os << indent << "RawOrigin: " << this->RawOrigin[0] << ", " << this->RawOrigin[1] << ", "
     << this->RawOrigin[2] << "\n";
  os << indent << "RawSpacing: " << this->RawSpacing[0] << ", " << this->RawSpacing[1] << ", "
     << this->RawSpacing[2] << "\n";
}
