// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradDayReader.h"

#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/Merging/PolarCache.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Series/SiteSeries.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Error.h"
#include "vtkNexradExchange.h"
#include "vtkNexradExtent.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradSeriesReader.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <cmath>
#include <tuple>

vtkStandardNewMacro(vtkNexradDayReader);

/// The scanned inputs, what they were scanned from, and the grid of the last information request.
struct vtkNexradDayReader::Day
{
  using Origin = std::tuple<std::vector<std::string>, std::string, std::string, vtkTypeInt64, int>;

  Day(Origin from, const nexrad::SeriesOptions& options)
    : From(std::move(from))
    , Cache(*options.moment, static_cast<std::size_t>(std::get<vtkTypeInt64>(From)), options.level2,
        options.quality)
  {
  }

  Origin From;
  nexrad::PolarCache Cache;
  nexrad::SeriesScan Scan;
  nexrad::GridSpecification Grid;
  nexrad::MergeRun Run;
};

vtkNexradDayReader::vtkNexradDayReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkNexradDayReader::~vtkNexradDayReader() = default;

void vtkNexradDayReader::AddFileName(const char* path)
{
  if (path && *path)
  {
    this->FileNames.emplace_back(path);
    this->Modified();
  }
}

void vtkNexradDayReader::ClearFileNames()
{
  if (!this->FileNames.empty())
  {
    this->FileNames.clear();
    this->Modified();
  }
}

int vtkNexradDayReader::GetNumberOfFileNames() const
{
  return static_cast<int>(this->FileNames.size());
}

const char* vtkNexradDayReader::GetFileName(int index) const
{
  return index >= 0 && index < this->GetNumberOfFileNames()
           ? this->FileNames[static_cast<std::size_t>(index)].c_str()
           : nullptr;
}

int vtkNexradDayReader::CanReadFile(const char* path)
{
  return vtkNexradSeriesReader::CanReadFile(path);
}

void vtkNexradDayReader::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkNexradDayReader::GetController() const
{
  return this->Controller;
}

int vtkNexradDayReader::GetNumberOfDecodedFiles() const
{
  return this->Scanned ? static_cast<int>(this->Scanned->Cache.DecodedFiles()) : 0;
}

vtkStringArray* vtkNexradDayReader::GetDamage()
{
  return this->Damage;
}

vtkStringArray* vtkNexradDayReader::GetLeftOut()
{
  return this->LeftOut;
}

vtkDoubleArray* vtkNexradDayReader::GetTimeSteps()
{
  return this->TimeSteps;
}

vtkStringArray* vtkNexradDayReader::GetSites()
{
  return this->Sites;
}

int vtkNexradDayReader::Scan()
{
  const Day::Origin from = {
    this->FileNames, this->Moment, this->SiteName, this->MemoryLimit, this->FewestNeighbours};
  if (this->Scanned && this->Scanned->From == from)
  {
    return 1;
  }
  this->Scanned.reset();
  this->Damage->Initialize();
  this->LeftOut->Initialize();
  if (this->FileNames.empty())
  {
    return this->Fail(vtkErrorCode::NoFileNameError, "no file name was added");
  }
  vtkNexradForgetAbort(this);
  nexrad::SeriesOptions options;
  options.moment = this->CheckMoment();
  options.requirePosition = true;
  options.level2.siteName = this->SiteName;
  options.quality.neighbours = this->FewestNeighbours;
  options.digests = true;
  vtkMultiProcessController* controller = this->Controller;
  if (!controller && this->UseGlobalController)
  {
    controller = vtkMultiProcessController::GetGlobalController();
  }
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    options.share.rank = static_cast<std::size_t>(controller->GetLocalProcessId());
    options.share.count = static_cast<std::size_t>(controller->GetNumberOfProcesses());
    // VTK shares a volume out along its longest axis; of x and y alike, along y.
    options.share.order = this->Dimensions[1] >= this->Dimensions[0]
                            ? nexrad::ScanOrder::ByLatitude
                            : nexrad::ScanOrder::ByLongitude;
    options.share.exchange = [controller](const std::string& mine)
    { return vtkNexradExchange(controller, mine); };
  }
  auto day = std::make_unique<Day>(from, options);
  std::optional<nexrad::SeriesScan> scan;
  try
  {
    scan = nexrad::ScanInputs(
      {this->FileNames.begin(), this->FileNames.end()}, options,
      [&day](const nexrad::SeriesVolume& key, const nexrad::RadarVolume& volume)
      { day->Cache.Offer(key, volume); },
      vtkNexradProgress(this));
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileNotFoundError, error.what());
  }
  if (!scan)
  {
    return 1;
  }
  day->Scan = std::move(*scan);
  this->Scanned = std::move(day);
  this->ReportProblems();
  if (this->Scanned->Scan.sites.empty())
  {
    this->Scanned.reset();
    return this->Fail(vtkErrorCode::FileFormatError, "no input holds a volume that can be used");
  }
  return 1;
}

void vtkNexradDayReader::ReportProblems()
{
  for (const nexrad::InputProblem& problem : this->Scanned->Scan.problems)
  {
    this->Damage->InsertNextValue(problem.Line());
    if (problem.leftOut)
    {
      this->LeftOut->InsertNextValue(problem.file);
    }
    vtkWarningMacro(<< problem.Line());
  }
  this->Sites->Initialize();
  for (const nexrad::SiteSeries& series : this->Scanned->Scan.sites)
  {
    this->Sites->InsertNextValue(series.site.name);
  }
}

void vtkNexradDayReader::MakeTimeSteps()
{
  const nexrad::SeriesScan& scan = this->Scanned->Scan;
  const bool fromBegin = !(this->BeginTime > VTK_DOUBLE_MIN);
  const bool toEnd = !(this->EndTime < VTK_DOUBLE_MAX);
  const nexrad::Time first = fromBegin ? *scan.First() : nexrad::FromSeconds(this->BeginTime);
  const nexrad::Time last = toEnd ? *scan.Last() : nexrad::FromSeconds(this->EndTime);
  const auto pause = nexrad::FindPause(scan.Spans(), first, last, nexrad::LongestPause);
  if (pause && (fromBegin || toEnd))
  {
    throw nexrad::Error("nothing was scanned for days, from " +
                        nexrad::FormatIso8601(pause->first) + " to " +
                        nexrad::FormatIso8601(pause->last) + ": set BeginTime and EndTime");
  }
  const auto step = std::llround(this->TimeStep * 1000.0);
  std::vector<nexrad::Time> steps =
    nexrad::TimeSteps(first, last, nexrad::Duration(static_cast<nexrad::Duration::rep>(step)));
  if (steps.empty() && fromBegin && toEnd)
  {
    steps.push_back(nexrad::MiddleTime(first, last));
  }
  if (steps.empty())
  {
    throw nexrad::Error("no multiple of the time step lies from " + nexrad::FormatIso8601(first) +
                        " to " + nexrad::FormatIso8601(last) +
                        ": set a shorter step, or other begin and end times");
  }
  for (const nexrad::Time time : steps)
  {
    this->TimeSteps->InsertNextValue(nexrad::ToSeconds(time));
  }
}

int vtkNexradDayReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->TimeSteps->Initialize();
  try
  {
    if (!this->Scan())
    {
      return 0;
    }
    if (!this->Scanned)
    {
      return 1; // the scan was aborted
    }
    this->Scanned->Grid =
      nexrad::MakeGrid(this->MakeGridRequest(), this->Scanned->Scan.Positions());
    this->MakeTimeSteps();
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::UserError, error.what());
  }
  vtkInformation* info = output->GetInformationObject(0);
  this->SetOutputExtent(info);
  info->Set(vtkDataObject::ORIGIN(), this->Scanned->Grid.origin.data(), 3);
  info->Set(vtkDataObject::SPACING(), this->Scanned->Grid.spacing.data(), 3);
  const vtkIdType count = this->TimeSteps->GetNumberOfValues();
  const double range[2] = {this->TimeSteps->GetValue(0), this->TimeSteps->GetValue(count - 1)};
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), this->TimeSteps->GetPointer(0),
    static_cast<int>(count));
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkNexradDayReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  auto* image = vtkImageData::GetData(output);
  image->Initialize();
  if (this->TimeSteps->GetNumberOfValues() == 0)
  {
    // The information request failed, and said why; or the scan was aborted.
    return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  vtkInformation* info = output->GetInformationObject(0);
  const double time = info->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
                        ? info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP())
                        : this->TimeSteps->GetValue(0);
  const nexrad::GridSpecification& grid = this->Scanned->Grid;
  const nexrad::VoxelBlock block = vtkNexradRequestedBlock(info, grid);
  if (block.VoxelCount() == 0)
  {
    return 1;
  }
  try
  {
    const std::optional<nexrad::GriddedVolume> merged = nexrad::MergeSeries(this->Scanned->Scan,
      this->Scanned->Cache, this->MakeMergeRequest(grid, block, time, this->MaximumGap),
      vtkNexradProgress(this), &this->Scanned->Run);
    if (merged)
    {
      vtkNexradVolumeToImage(*merged, image);
      vtkNexradPlaceBlock(grid, block, image);
      image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    }
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::UserError, error.what());
  }
  return 1;
}

void vtkNexradDayReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TimeStep: " << this->TimeStep << "\n";
  os << indent << "BeginTime: " << this->BeginTime << "\n";
  os << indent << "EndTime: " << this->EndTime << "\n";
  os << indent << "MaximumGap: " << this->MaximumGap << "\n";
  os << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
  os << indent << "SiteName: " << this->SiteName << "\n";
  os << indent << "Controller: " << this->Controller << "\n";
  os << indent << "UseGlobalController: " << this->UseGlobalController << "\n";
  os << indent << "DecodedFiles: " << this->GetNumberOfDecodedFiles() << "\n";
  os << indent << "FileNames:\n";
  for (const std::string& name : this->FileNames)
  {
    os << indent.GetNextIndent() << name << "\n";
  }
  os << indent << "Sites: " << this->Sites->GetNumberOfValues() << "\n";
  os << indent << "TimeSteps: " << this->TimeSteps->GetNumberOfValues() << "\n";
  os << indent << "Damage: " << this->Damage->GetNumberOfValues() << " lines\n";
}
