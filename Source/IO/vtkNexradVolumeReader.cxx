// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeReader.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/Progress.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"

#include "vtkDataArraySelection.h"
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
#include <tuple>
#include <vector>

vtkStandardNewMacro(vtkNexradVolumeReader);

struct vtkNexradVolumeReader::Step
{
  double Time; ///< s since 1970-01-01T00:00:00Z
  std::filesystem::path File;
};

/// The volumes that the file name stands for, and what the first of them holds.
struct vtkNexradVolumeReader::Contents
{
  std::vector<Step> Steps;         ///< at least one, ascending
  std::size_t Level = 0;           ///< which they all have
  nexrad::GridSpecification Grid;  ///< of that level
  std::vector<std::string> Arrays; ///< names of the ancillary arrays, as REF_age
  bool AsCodes = false;            ///< the active scalars are given as codes of one byte

  /// The latest at or before the time that is asked for; before the first, and without a time, the
  /// first.
  const Step& RequestedStep(vtkInformation* info) const
  {
    if (!info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
    {
      return this->Steps.front();
    }
    const auto next = std::upper_bound(this->Steps.begin(), this->Steps.end(),
      info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()),
      [](double wanted, const Step& step) { return wanted < step.Time; });
    return next == this->Steps.begin() ? this->Steps.front() : *(next - 1);
  }
};

namespace
{

bool IsIndex(const std::filesystem::path& path)
{
  return path.extension() == ".series";
}

// Of an index. Throws nexrad::Error for one that cannot be read, and for one that names no file.
nexrad::NxvSeries FilesIn(const std::filesystem::path& index)
{
  nexrad::NxvSeries files = nexrad::ReadNxvSeries(index);
  if (files.empty())
  {
    throw nexrad::Error(index.string() + ": the index names no file");
  }
  std::sort(files.begin(), files.end(),
    [](const auto& a, const auto& b)
    { return std::tie(a.second, a.first) < std::tie(b.second, b.first); });
  return files;
}

// The moments of a text as "VEL,REF"; empty: all that a file has. Throws nexrad::Error for another
// text.
std::vector<nexrad::MomentName> MomentsToRead(const std::string& names)
{
  std::vector<nexrad::MomentName> moments = nexrad::ParseMomentNames(names);
  if (moments.empty() && !names.empty())
  {
    throw nexrad::Error("moments " + names + " are unknown: set names as in REF,VEL");
  }
  return moments;
}

// Names of the arrays that are off.
std::vector<std::string> NamesToLeaveOut(vtkDataArraySelection* selection)
{
  std::vector<std::string> names;
  for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
  {
    if (selection->GetArraySetting(i) == 0)
    {
      names.emplace_back(selection->GetArrayName(i));
    }
  }
  return names;
}

// Makes a selection list these names: those that it knows keep what the user chose for them, new
// ones are on.
void ListArrays(const std::vector<std::string>& names, vtkDataArraySelection* selection)
{
  for (int i = selection->GetNumberOfArrays(); i-- > 0;)
  {
    const std::string known = selection->GetArrayName(i);
    if (std::find(names.begin(), names.end(), known) == names.end())
    {
      selection->RemoveArrayByIndex(i);
    }
  }
  for (const std::string& name : names)
  {
    selection->AddArray(name.c_str());
  }
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
      FilesIn(path);
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

vtkNexradVolumeReader::Contents vtkNexradVolumeReader::ReadContents() const
{
  const std::filesystem::path path = this->FileName;
  Contents contents;
  if (IsIndex(path))
  {
    for (const auto& [name, time] : FilesIn(path))
    {
      contents.Steps.push_back({time, path.parent_path() / name});
    }
  }
  const std::filesystem::path firstFile = IsIndex(path) ? contents.Steps.front().File : path;
  const nexrad::GriddedVolume first = nexrad::ReadNxvHeader(firstFile);
  if (!IsIndex(path))
  {
    contents.Steps.push_back({nexrad::ToSeconds(first.time), path});
  }
  const std::vector<nexrad::GridSpecification> levels = nexrad::ReadNxvLevels(firstFile);
  contents.Level = std::min(static_cast<std::size_t>(this->Level), levels.size() - 1);
  contents.Grid = levels[contents.Level];
  if (contents.Level == 0)
  {
    contents.Arrays = nexrad::ReadNxvAncillaryArrayNames(firstFile);
  }
  if (first.ofOneRadar)
  {
    contents.Arrays.insert(contents.Arrays.end(), {"azimuth", "elevation", "slant_range"});
  }
  nexrad::NxvReadOptions options;
  options.moments = MomentsToRead(this->Moments);
  options.level = contents.Level;
  contents.AsCodes = this->ScalarsAsCodes && nexrad::HasNxvCodes(firstFile, options);
  return contents;
}

void vtkNexradVolumeReader::ReadStep(
  const Step& step, const nexrad::VoxelBlock& block, vtkImageData* image)
{
  const std::size_t level = this->Opened->Level;
  const std::vector<nexrad::GridSpecification> levels = nexrad::ReadNxvLevels(step.File);
  if (level >= levels.size() || levels[level] != this->Opened->Grid)
  {
    throw nexrad::Error(
      step.File.string() + ": its grid is not that of the first volume of the series");
  }
  nexrad::NxvReadOptions options;
  options.leaveOut = NamesToLeaveOut(this->AncillaryArraySelection);
  options.moments = MomentsToRead(this->Moments);
  options.block = block;
  options.level = level;
  vtkNexradReadVolumeFile(step.File.string(), options, this->ScalarsAsCodes, image);
  vtkNexradPlaceBlock(this->Opened->Grid, block, image);
}

vtkDataArraySelection* vtkNexradVolumeReader::GetAncillaryArraySelection()
{
  return this->AncillaryArraySelection;
}

vtkMTimeType vtkNexradVolumeReader::GetMTime()
{
  return std::max(this->Superclass::GetMTime(), this->AncillaryArraySelection->GetMTime());
}

int vtkNexradVolumeReader::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  // What is wrong with a file that an index names is said of the index.
  const std::string name = this->FileName != nullptr ? this->FileName : "";
  return vtkNexradFail(this, line.rfind(name, 0) == 0 ? line : name + ": " + line);
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
    this->Opened = std::make_unique<Contents>(this->ReadContents());
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  ListArrays(this->Opened->Arrays, this->AncillaryArraySelection);
  this->Describe(output->GetInformationObject(0));
  return 1;
}

void vtkNexradVolumeReader::Describe(vtkInformation* info) const
{
  vtkNexradOfferGrid(info, this->Opened->Grid);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, this->Opened->AsCodes ? VTK_UNSIGNED_CHAR : VTK_FLOAT, 1);
  std::vector<double> times;
  for (const Step& step : this->Opened->Steps)
  {
    times.push_back(step.Time);
  }
  vtkNexradOfferTimes(info, times.data(), static_cast<int>(times.size()));
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
  const Step& step = this->Opened->RequestedStep(info);
  const nexrad::Progress progress = vtkNexradProgress(this);
  vtkImageData* image = vtkImageData::GetData(output);
  image->Initialize();
  const nexrad::VoxelBlock block = vtkNexradRequestedBlock(info, this->Opened->Grid);
  if (block.VoxelCount() == 0 || !progress(0.0))
  {
    return 1;
  }
  try
  {
    this->ReadStep(step, block, image);
    vtkNexradAddRadarView(image, NamesToLeaveOut(this->AncillaryArraySelection));
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), step.Time);
  if (!progress(0.9))
  {
    image->Initialize();
  }
  return 1;
}

void vtkNexradVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Moments: " << this->Moments << "\n";
  os << indent << "Level: " << this->Level << "\n";
  os << indent << "ScalarsAsCodes: " << this->ScalarsAsCodes << "\n";
  os << indent << "AncillaryArraySelection:\n";
  this->AncillaryArraySelection->PrintSelf(os, indent.GetNextIndent());
}
