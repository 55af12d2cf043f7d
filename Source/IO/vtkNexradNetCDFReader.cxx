// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNetCDFReader.h"

#include "nexrad/Codec/NxvSeries.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradArrayChoice.h"
#include "vtkNexradExtent.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradNetCDFInput.h"
#include "vtkNexradPipeline.h"

#include "vtkDataArraySelection.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

vtkStandardNewMacro(vtkNexradNetCDFReader);

/// The times that the file name stands for, ascending, and what the first file holds.
struct vtkNexradNetCDFReader::Files
{
  struct Step
  {
    double Time;
    fs::path File;
    std::size_t Index; // of the time in the file
  };
  std::vector<Step> Steps;
  vtkNexradNetCDFContents First;

  /// The latest at or before the time; before the first, the first.
  const Step& At(double time) const
  {
    const auto next = std::upper_bound(Steps.begin(), Steps.end(), time,
      [](double wanted, const Step& step) { return wanted < step.Time; });
    return next == Steps.begin() ? Steps.front() : *(next - 1);
  }
};

namespace
{

// The files that a path stands for, in the order of the index.
std::vector<fs::path> FilesOf(const fs::path& path)
{
  if (path.extension() != ".series")
  {
    return {path};
  }
  std::vector<fs::path> files;
  for (const auto& [name, time] : nexrad::ReadNxvSeries(path))
  {
    files.push_back(path.parent_path() / name);
  }
  if (files.empty())
  {
    throw nexrad::Error(path.string() + ": the index names no file");
  }
  return files;
}

} // namespace

vtkNexradNetCDFReader::vtkNexradNetCDFReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkNexradNetCDFReader::~vtkNexradNetCDFReader()
{
  this->SetFileName(nullptr);
}

vtkDataArraySelection* vtkNexradNetCDFReader::GetAncillaryArraySelection()
{
  return this->AncillaryArraySelection;
}

vtkMTimeType vtkNexradNetCDFReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->AncillaryArraySelection->GetMTime());
}

int vtkNexradNetCDFReader::CanReadFile(const char* path)
{
  if (vtkNexradPathError(path) != vtkErrorCode::NoError || fs::is_directory(path))
  {
    return 0;
  }
  try
  {
    vtkNexradReadNetCDFContents(FilesOf(path).front());
    return 1;
  }
  catch (const nexrad::Error&)
  {
    return 0;
  }
}

int vtkNexradNetCDFReader::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  vtkErrorMacro(<< line);
  return 0;
}

void vtkNexradNetCDFReader::ListFiles()
{
  auto files = std::make_unique<Files>();
  for (const fs::path& path : FilesOf(this->FileName))
  {
    vtkNexradNetCDFContents contents = vtkNexradReadNetCDFContents(path);
    for (std::size_t i = 0; i < contents.Times.size(); ++i)
    {
      files->Steps.push_back({nexrad::ToSeconds(contents.Times[i]), path, i});
    }
    if (files->First.Times.empty())
    {
      files->First = std::move(contents);
    }
    else if (contents.Grid != files->First.Grid)
    {
      throw nexrad::Error(path.string() + ": its grid is not that of the first file of the series");
    }
  }
  std::sort(files->Steps.begin(), files->Steps.end(),
    [](const Files::Step& a, const Files::Step& b) { return a.Time < b.Time; });
  this->Opened = std::move(files);
}

void vtkNexradNetCDFReader::ListAncillaryArrays()
{
  std::vector<std::string> names = this->Opened->First.Ancillary;
  if (this->Opened->First.OfOneRadar)
  {
    names.insert(names.end(), {"azimuth", "elevation", "slant_range"});
  }
  vtkNexradListArrays(names, this->AncillaryArraySelection);
}

int vtkNexradNetCDFReader::RequestInformation(
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
    this->ListFiles();
    this->ListAncillaryArrays();
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  vtkInformation* info = output->GetInformationObject(0);
  const nexrad::GridSpecification& grid = this->Opened->First.Grid;
  vtkNexradOfferExtent(info, grid.dimensions.data());
  info->Set(vtkDataObject::ORIGIN(), grid.origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), grid.spacing.data(), 3);
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  std::vector<double> times;
  for (const Files::Step& step : this->Opened->Steps)
  {
    times.push_back(step.Time);
  }
  const double range[2] = {times.front(), times.back()};
  info->Set(
    vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkNexradNetCDFReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (!this->Opened)
  {
    return 0; // the information request failed, and said why
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  vtkInformation* info = output->GetInformationObject(0);
  const Files::Step& step =
    info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
      ? this->Opened->At(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
      : this->Opened->Steps.front();
  const nexrad::Progress progress = vtkNexradProgress(this);
  vtkImageData* image = vtkImageData::GetData(output);
  image->Initialize();
  const nexrad::VoxelBlock block = vtkNexradRequestedBlock(info, this->Opened->First.Grid);
  if (block.VoxelCount() == 0 || !progress(0.0))
  {
    return 1;
  }
  try
  {
    const vtkNexradNetCDFRequest request{step.Index, vtkNexradMomentsToRead(this->Moments),
      vtkNexradNamesToLeaveOut(this->AncillaryArraySelection)};
    const nexrad::GriddedVolume volume = vtkNexradReadNetCDF(step.File, request);
    if (volume.grid != this->Opened->First.Grid)
    {
      throw nexrad::Error(step.File.string() + ": its grid has changed since it was opened");
    }
    vtkNexradVolumeToImage(volume, image);
    const int extent[6] = {block.begin[0], block.end[0] - 1, block.begin[1], block.end[1] - 1,
      block.begin[2], block.end[2] - 1};
    image->Crop(extent);
    vtkNexradAddRadarView(image, request.LeaveOut);
    image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.Time);
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

void vtkNexradNetCDFReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Moments: " << this->Moments << "\n";
  os << indent << "AncillaryArraySelection:\n";
  this->AncillaryArraySelection->PrintSelf(os, indent.GetNextIndent());
}
