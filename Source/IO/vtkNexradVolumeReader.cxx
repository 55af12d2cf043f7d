// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeReader.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/VolumePart.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradArrayChoice.h"
#include "vtkNexradExtent.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradVolumeFile.h"

#include "vtkDataArraySelection.h"
#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkNexradVolumeReader);

/// The volumes that the file name stands for, by time, and the grid of the first.
struct vtkNexradVolumeReader::Files
{
  std::vector<std::pair<double, std::filesystem::path>> Steps;
  nexrad::GriddedVolume First; ///< without values
  bool HasCodes = false;       ///< the first has codes of one byte

  /// The latest at or before the time; before the first, the first.
  const std::pair<double, std::filesystem::path>& At(double time) const
  {
    const auto next = std::upper_bound(Steps.begin(), Steps.end(), time,
      [](double wanted, const auto& step) { return wanted < step.first; });
    return next == Steps.begin() ? Steps.front() : *(next - 1);
  }
};

namespace
{

bool IsIndex(const std::filesystem::path& path)
{
  return path.extension() == ".series";
}

} // namespace

vtkNexradVolumeReader::vtkNexradVolumeReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkNexradVolumeReader::~vtkNexradVolumeReader()
{
  this->SetFileName(nullptr);
}

vtkDataArraySelection* vtkNexradVolumeReader::GetAncillaryArraySelection()
{
  return this->AncillaryArraySelection;
}

vtkMTimeType vtkNexradVolumeReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->AncillaryArraySelection->GetMTime());
}

int vtkNexradVolumeReader::CanReadFile(const char* path)
{
  if (vtkNexradPathError(path) != vtkErrorCode::NoError || std::filesystem::is_directory(path))
  {
    return 0;
  }
  try
  {
    if (IsIndex(path))
    {
      return nexrad::ReadNxvSeries(path).empty() ? 0 : 1;
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

int vtkNexradVolumeReader::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< line);
  return 0;
}

void vtkNexradVolumeReader::ReadHeader()
{
  auto files = std::make_unique<Files>();
  const std::filesystem::path path = this->FileName;
  if (this->RawStream)
  {
    nexrad::GridSpecification& grid = files->First.grid;
    std::copy_n(this->RawDimensions, 3, grid.dimensions.begin());
    std::copy_n(this->RawOrigin, 3, grid.origin.begin());
    std::copy_n(this->RawSpacing, 3, grid.spacing.begin());
    files->First.fill = 0.0F;
    files->Steps.emplace_back(0.0, path);
  }
  else if (IsIndex(path))
  {
    for (const auto& [name, time] : nexrad::ReadNxvSeries(path))
    {
      files->Steps.emplace_back(time, path.parent_path() / name);
    }
    if (files->Steps.empty())
    {
      throw nexrad::Error(path.string() + ": the index names no file");
    }
    std::sort(files->Steps.begin(), files->Steps.end());
    files->First = nexrad::ReadNxvHeader(files->Steps.front().second);
  }
  else
  {
    files->First = nexrad::ReadNxvHeader(path);
    files->Steps.emplace_back(nexrad::ToSeconds(files->First.time), path);
  }
  this->Opened = std::move(files);
}

void vtkNexradVolumeReader::ListAncillaryArrays()
{
  std::vector<std::string> names;
  if (!this->RawStream)
  {
    names = nexrad::ReadNxvAncillaryArrayNames(this->Opened->Steps.front().second);
  }
  if (this->Opened->First.ofOneRadar)
  {
    names.insert(names.end(), {"azimuth", "elevation", "slant_range"});
  }
  vtkNexradListArrays(names, this->AncillaryArraySelection);
}

int vtkNexradVolumeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->Opened.reset();
  const unsigned long pathError = vtkNexradPathError(this->FileName);
  if (pathError != vtkErrorCode::NoError)
  {
    return this->Fail(pathError, vtkNexradPathErrorText(pathError, this->FileName));
  }
  try
  {
    this->ReadHeader();
    this->ListAncillaryArrays();
    nexrad::NxvReadOptions options;
    options.moments = vtkNexradMomentsToRead(this->Moments);
    this->Opened->HasCodes =
      !this->RawStream && nexrad::HasNxvCodes(this->Opened->Steps.front().second, options);
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  vtkInformation* info = output->GetInformationObject(0);
  const nexrad::GridSpecification& grid = this->Opened->First.grid;
  vtkNexradOfferExtent(info, grid.dimensions.data());
  info->Set(vtkDataObject::ORIGIN(), grid.origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  const bool codes = this->ScalarsAsCodes && this->Opened->HasCodes;
  vtkDataObject::SetPointDataActiveScalarInfo(info, codes ? VTK_UNSIGNED_CHAR : VTK_FLOAT, 1);
  if (!this->RawStream)
  {
    std::vector<double> times;
    for (const auto& step : this->Opened->Steps)
    {
      times.push_back(step.first);
    }
    const double range[2] = {times.front(), times.back()};
    info->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

void vtkNexradVolumeReader::ReadImage(
  const std::filesystem::path& path, const nexrad::VoxelBlock& block, vtkImageData* image)
{
  const nexrad::GridSpecification& grid = this->Opened->First.grid;
  if (this->RawStream)
  {
    vtkNexradVolumeToImage(
      nexrad::TakePart(nexrad::ReadRaw(path, this->Opened->First), block), image);
    vtkNexradPlaceBlock(grid, block, image);
    return;
  }
  if (nexrad::ReadNxvHeader(path).grid != grid)
  {
    throw nexrad::Error(path.string() + ": its grid is not that of the first volume of the series");
  }
  vtkNexradReadVolumeFile({path.string(), vtkNexradNamesToLeaveOut(this->AncillaryArraySelection),
                            vtkNexradMomentsToRead(this->Moments), this->ScalarsAsCodes},
    image);
  const int extent[6] = {block.begin[0], block.end[0] - 1, block.begin[1], block.end[1] - 1,
    block.begin[2], block.end[2] - 1};
  image->Crop(extent);
  vtkNexradAddRadarView(image, vtkNexradNamesToLeaveOut(this->AncillaryArraySelection));
}

int vtkNexradVolumeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (!this->Opened)
  {
    return 0; // the information request failed, and said why
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  vtkInformation* info = output->GetInformationObject(0);
  const auto& step =
    info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
      ? this->Opened->At(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
      : this->Opened->Steps.front();
  const nexrad::Progress progress = vtkNexradProgress(this);
  vtkImageData* image = vtkImageData::GetData(output);
  image->Initialize();
  const nexrad::GridSpecification& grid = this->Opened->First.grid;
  const nexrad::VoxelBlock block = vtkNexradRequestedBlock(info, grid);
  if (block.VoxelCount() == 0 || !progress(0.0))
  {
    return 1;
  }
  try
  {
    this->ReadImage(step.second, block, image);
    image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.first);
    if (!progress(0.9))
    {
      image->Initialize();
    }
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  return 1;
}

void vtkNexradVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "ScalarsAsCodes: " << this->ScalarsAsCodes << "\n";
  os << indent << "Moments: " << this->Moments << "\n";
  os << indent << "RawStream: " << this->RawStream << "\n";
  os << indent << "RawDimensions: " << this->RawDimensions[0] << ", " << this->RawDimensions[1]
     << ", " << this->RawDimensions[2] << "\n";
  os << indent << "RawOrigin: " << this->RawOrigin[0] << ", " << this->RawOrigin[1] << ", "
     << this->RawOrigin[2] << "\n";
  os << indent << "RawSpacing: " << this->RawSpacing[0] << ", " << this->RawSpacing[1] << ", "
     << this->RawSpacing[2] << "\n";
  os << indent << "AncillaryArraySelection:\n";
  this->AncillaryArraySelection->PrintSelf(os, indent.GetNextIndent());
}
