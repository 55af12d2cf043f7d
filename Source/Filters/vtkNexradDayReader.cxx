// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradDayReader.h"

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Merging/MergeSettings.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/Merging/VolumeCache.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradProcesses.h"
#include "vtkNexradSeriesReader.h"
#include "vtkNexradThreads.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"
#include "vtkVariant.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkNexradDayReader);

namespace
{

// False for VTK_DOUBLE_MIN and VTK_DOUBLE_MAX, which stand for the times of the data.
bool IsTime(double seconds)
{
  return seconds >= nexrad::ToSeconds(nexrad::EarliestTime) &&
         seconds <= nexrad::ToSeconds(nexrad::LatestTime);
}

// Seconds; `none` for an empty text and for a number that is no time. Empty when the text is
// neither a time nor a number, which is an error of the reader; `property` is what is set.
std::optional<double> SecondsOf(
  vtkObject* reader, const char* property, const std::string& text, double none)
{
  if (text.empty())
  {
    return none;
  }
  if (const std::optional<nexrad::Time> time = nexrad::ParseIso8601(text))
  {
    return nexrad::ToSeconds(*time);
  }
  bool isNumber = false;
  const double seconds = vtkVariant(text).ToDouble(&isNumber);
  if (!isNumber || std::isnan(seconds))
  {
    vtkErrorWithObjectMacro(
      reader, << property << ": '" << text << "' is no time; write it as 2010-09-11T20:05 (UTC)");
    return std::nullopt;
  }
  return IsTime(seconds) ? seconds : none;
}

std::string TimeText(double seconds)
{
  return IsTime(seconds) ? nexrad::FormatIso8601(nexrad::FromSeconds(seconds)) : std::string();
}

using Setting = nexrad::Setting<nexrad::MergeOptions>;

} // namespace

/// What merges the inputs, and the settings that it cannot change.
struct vtkNexradDayReader::Day
{
  using Origin = std::tuple<std::vector<std::string>, std::string, std::string, vtkTypeInt64,
    nexrad::MomentOptions, bool>;

  Origin From;
  nexrad::SeriesMerger Merger;
  std::set<std::string> Reported; ///< lines of problems
  nexrad::VolumeCache Merged;     ///< outputs, as the settings of MergedWith make them
  vtkMTimeType MergedWith = 0;
  bool MergedByScan = false; ///< whether all files were known then
  int Merges = 0;

  Day(Origin origin, const nexrad::MergeOptions& options, nexrad::MergerSetup setup)
    : From(std::move(origin))
    , Merger({std::get<0>(From).begin(), std::get<0>(From).end()}, options, std::move(setup))
    , Merged(options.memory)
  {
  }

  std::optional<nexrad::GriddedVolume> Merge(nexrad::Time time, const nexrad::VoxelBlock& block,
    vtkMTimeType settings, const nexrad::Progress& progress)
  {
    // A scan may show that a header erred, and that another volume belongs to a time.
    if (MergedWith != settings || MergedByScan != Merger.IsScanned())
    {
      Merged.Clear();
      MergedWith = settings;
    }
    if (auto kept = Merged.Find(block, time))
    {
      return kept;
    }
    std::optional<nexrad::GriddedVolume> merged = Merger.Merge(time, progress, block);
    MergedByScan = Merger.IsScanned();
    if (merged)
    {
      ++Merges;
      Merged.Keep(block, *merged);
    }
    return merged;
  }
};

vtkNexradDayReader::vtkNexradDayReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkNexradDayReader::~vtkNexradDayReader() = default;

void vtkNexradDayReader::SetOption(const char* key, const char* text)
{
  if (nexrad::FindSetting(nexrad::MergeSettings(), key) == nullptr)
  {
    vtkErrorMacro("there is no option " << key << "; GetOptionTable lists them");
    return;
  }
  std::string& known = this->Texts[key];
  if (known != text)
  {
    known = text;
    this->Modified();
  }
}

void vtkNexradDayReader::SetOption(const char* key, double number)
{
  const Setting* setting = nexrad::FindSetting(nexrad::MergeSettings(), key);
  this->SetOption(key, setting ? setting->TextOf(number).c_str() : "");
}

std::string vtkNexradDayReader::GetOption(const char* key) const
{
  const Setting* setting = nexrad::FindSetting(nexrad::MergeSettings(), key);
  const auto text = this->Texts.find(key);
  const bool given = text != this->Texts.end() && !text->second.empty();
  return !setting ? "" : given ? nexrad::NormalText(*setting, text->second) : setting->Default();
}

std::string vtkNexradDayReader::GetOptionTable()
{
  return nexrad::SettingsJson({nexrad::MergeSettings().begin(), nexrad::MergeSettings().end()});
}

void vtkNexradDayReader::SetDimensions(int x, int y, int z)
{
  this->SetOption("dims", nexrad::DimensionsText({x, y, z}).c_str());
}

void vtkNexradDayReader::SetDimensions(const int dimensions[3])
{
  this->SetDimensions(dimensions[0], dimensions[1], dimensions[2]);
}

void vtkNexradDayReader::SetRange(double metres)
{
  this->SetOption("range", metres);
}

void vtkNexradDayReader::SetHeightRange(double lower, double upper)
{
  this->SetOption("height", nexrad::HeightRangeText(lower, upper).c_str());
}

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

const char* vtkNexradDayReader::GetFileName(int index) const
{
  return index >= 0 && index < this->GetNumberOfFileNames()
           ? this->FileNames[static_cast<std::size_t>(index)].c_str()
           : nullptr;
}

void vtkNexradDayReader::SetBeginTimeText(const std::string& text)
{
  if (const auto seconds = SecondsOf(this, "BeginTime", text, VTK_DOUBLE_MIN))
  {
    this->SetBeginTime(*seconds);
  }
}

std::string vtkNexradDayReader::GetBeginTimeText() const
{
  return TimeText(this->BeginTime);
}

void vtkNexradDayReader::SetEndTimeText(const std::string& text)
{
  if (const auto seconds = SecondsOf(this, "EndTime", text, VTK_DOUBLE_MAX))
  {
    this->SetEndTime(*seconds);
  }
}

std::string vtkNexradDayReader::GetEndTimeText() const
{
  return TimeText(this->EndTime);
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
  return this->Opened ? static_cast<int>(this->Opened->Merger.DecodedFiles()) : 0;
}

int vtkNexradDayReader::GetNumberOfMerges() const
{
  return this->Opened ? this->Opened->Merges : 0;
}

vtkStringArray* vtkNexradDayReader::GetRadarComparison()
{
  this->RadarComparison->Initialize();
  if (this->Opened)
  {
    for (const std::string& line : this->Opened->Merger.CompareRadars().Lines())
    {
      this->RadarComparison->InsertNextValue(line);
    }
  }
  return this->RadarComparison;
}

nexrad::MergeOptions vtkNexradDayReader::MakeDayOptions() const
{
  nexrad::MergeOptions options;
  options.grid.range = nexrad::DefaultRange; // of a terminal radar as well
  for (const Setting& setting : nexrad::MergeSettings())
  {
    const auto text = this->Texts.find(setting.key);
    if (text != this->Texts.end() && !text->second.empty())
    {
      nexrad::SetText(setting, text->second, options);
    }
  }
  for (const nexrad::MomentName moment : options.moments)
  {
    nexrad::RequireMoment(options.method, moment);
  }
  if (options.maximumGap == nexrad::MergeOptions().maximumGap)
  {
    options.maximumGap = nexrad::DurationOf(this->MaximumGap);
  }
  options.step = options.step.value_or(nexrad::DurationOf(this->TimeStep));
  options.atLeastOne = true;
  if (!options.begin && this->BeginTime > VTK_DOUBLE_MIN)
  {
    options.begin = nexrad::FromSeconds(this->BeginTime);
  }
  if (!options.end && this->EndTime < VTK_DOUBLE_MAX)
  {
    options.end = nexrad::FromSeconds(this->EndTime);
  }
  options.memory = static_cast<std::size_t>(this->MemoryLimit);
  options.siteName = options.siteName.empty() ? this->SiteName : options.siteName;
  options.compareRadars = true;
  return options;
}

nexrad::MergerSetup vtkNexradDayReader::MakeSetup(const std::array<int, 3>& dimensions) const
{
  vtkMultiProcessController* controller = this->Controller;
  if (!controller && this->UseGlobalController)
  {
    controller = vtkMultiProcessController::GetGlobalController();
  }
  nexrad::MergerSetup setup;
  setup.loop = vtkNexradRangeLoop();
  setup.threads = vtkNexradThreadCount();
  setup.anyOrder = true;
  setup.processes = vtkNexradProcessesOf(controller);
  // The pipeline may ask one process alone for an output, which then must know all volumes.
  setup.scanFirst = setup.processes.Count() > 1;
  // VTK shares a volume out along its longest axis; of x and y alike, along y.
  setup.order =
    dimensions[1] >= dimensions[0] ? nexrad::ScanOrder::ByLatitude : nexrad::ScanOrder::ByLongitude;
  return setup;
}

int vtkNexradDayReader::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  return vtkNexradFail(this, line);
}

bool vtkNexradDayReader::Open()
{
  const nexrad::MergeOptions options = this->MakeDayOptions();
  const Day::Origin from = {this->FileNames, this->GetMoment(), options.siteName, this->MemoryLimit,
    nexrad::MomentOptionsOf(options), options.measureBiases};
  if (this->Opened && this->Opened->From == from)
  {
    return this->Opened->Merger.SetOptions(options, vtkNexradProgress(this));
  }
  this->Damage->Initialize();
  this->LeftOut->Initialize();
  this->Opened = std::make_unique<Day>(from, options, this->MakeSetup(options.grid.dimensions));
  if (!this->Opened->Merger.Open(vtkNexradProgress(this)))
  {
    this->Opened.reset();
    return false;
  }
  return true;
}

void vtkNexradDayReader::ReportProblems()
{
  std::map<std::string, std::vector<std::string>> ofFile; // lines that are new
  for (const nexrad::InputProblem& problem : this->Opened->Merger.Problems())
  {
    if (this->Opened->Reported.insert(problem.Line()).second)
    {
      this->Damage->InsertNextValue(problem.Line());
      if (problem.leftOut)
      {
        this->LeftOut->InsertNextValue(problem.file);
      }
      ofFile[problem.file].push_back(problem.Line());
    }
  }
  // One message a file: a cut file has several faults, and one cause.
  for (const auto& [file, lines] : ofFile)
  {
    std::string text = lines.front();
    for (std::size_t i = 1; i < lines.size(); ++i)
    {
      text += "\n" + lines[i];
    }
    vtkWarningMacro(<< text);
  }
}

int vtkNexradDayReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  this->TimeSteps->Initialize();
  this->Sites->Initialize();
  this->FirstRay.clear();
  this->LastRay.clear();
  if (this->FileNames.empty())
  {
    this->Opened.reset();
    return this->Fail(vtkErrorCode::NoFileNameError, "no file name was added");
  }
  vtkNexradForgetAbort(this);
  try
  {
    if (!this->Open())
    {
      return 1; // it was aborted
    }
  }
  catch (const nexrad::InputError& error)
  {
    this->Opened.reset();
    return this->Fail(
      error.isMissing ? vtkErrorCode::FileNotFoundError : vtkErrorCode::FileFormatError,
      error.what());
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::UserError, error.what());
  }
  this->ReportProblems();
  const nexrad::SeriesMerger& merger = this->Opened->Merger;
  this->FirstRay = nexrad::FormatIso8601(merger.Rays().first);
  this->LastRay = nexrad::FormatIso8601(merger.Rays().last);
  for (const nexrad::Time time : merger.Times())
  {
    this->TimeSteps->InsertNextValue(nexrad::ToSeconds(time));
  }
  for (const std::string& site : merger.Sites())
  {
    this->Sites->InsertNextValue(site);
  }
  vtkInformation* info = output->GetInformationObject(0);
  vtkNexradOfferGrid(info, merger.Grid());
  vtkDataObject::SetPointDataActiveScalarInfo(info, VTK_FLOAT, 1);
  vtkNexradOfferTimes(
    info, this->TimeSteps->GetPointer(0), static_cast<int>(this->TimeSteps->GetNumberOfValues()));
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
  const double time = vtkNexradRequestedTime(info, this->TimeSteps->GetValue(0));
  const nexrad::GridSpecification grid = this->Opened->Merger.Grid();
  const nexrad::VoxelBlock block = vtkNexradRequestedBlock(info, grid);
  if (block.VoxelCount() == 0)
  {
    return 1;
  }
  try
  {
    const std::optional<nexrad::GriddedVolume> merged = this->Opened->Merge(
      nexrad::FromSeconds(time), block, this->GetMTime(), vtkNexradProgress(this));
    this->ReportProblems();
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

bool vtkNexradDayReader::MergeBox(double time, const double faces[4], vtkImageData* box)
{
  this->UpdateInformation();
  if (!this->Opened)
  {
    return false; // it said why
  }
  try
  {
    const std::optional<nexrad::GriddedVolume> merged = this->Opened->Merger.MergeBox(
      nexrad::FromSeconds(time), {{faces[0], faces[1], faces[2], faces[3]}});
    vtkNexradVolumeToImage(*merged, box);
    return true;
  }
  catch (const nexrad::Error& error)
  {
    this->Fail(vtkErrorCode::UserError, error.what());
    return false;
  }
}

void vtkNexradDayReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  for (const Setting& setting : nexrad::MergeSettings())
  {
    os << indent << setting.key << ": " << this->GetOption(setting.key.c_str()) << "\n";
  }
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
