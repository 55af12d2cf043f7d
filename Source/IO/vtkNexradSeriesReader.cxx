// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSeriesReader.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Series/Catalogue.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/System/Error.h"
#include "vtkNexradLevel2Reader.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradSweepConversion.h"

#include "vtkDataObject.h"
#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

vtkStandardNewMacro(vtkNexradSeriesReader);

/// The scanned inputs, and what they were scanned from.
struct vtkNexradSeriesReader::Series
{
  using Origin = std::tuple<std::vector<std::string>, std::string, bool, std::array<double, 3>>;

  Origin From;
  nexrad::SeriesScan Scan;
  std::vector<double> Times;
};

vtkNexradSeriesReader::vtkNexradSeriesReader()
{
  this->Coordinates = PROJECTED;
}

vtkNexradSeriesReader::~vtkNexradSeriesReader() = default;

void vtkNexradSeriesReader::AddFileName(const char* path)
{
  if (path && *path)
  {
    this->FileNames.emplace_back(path);
    this->Modified();
  }
}

void vtkNexradSeriesReader::ClearFileNames()
{
  if (!this->FileNames.empty())
  {
    this->FileNames.clear();
    this->Modified();
  }
}

int vtkNexradSeriesReader::GetNumberOfFileNames() const
{
  return static_cast<int>(this->FileNames.size());
}

const char* vtkNexradSeriesReader::GetFileName(int index) const
{
  return index >= 0 && index < this->GetNumberOfFileNames()
           ? this->FileNames[static_cast<std::size_t>(index)].c_str()
           : nullptr;
}

int vtkNexradSeriesReader::CanReadFile(const char* path)
{
  if (vtkNexradPathError(path) != vtkErrorCode::NoError)
  {
    return 0;
  }
  if (nexrad::KindOf(path) != nexrad::StoredKind::Folder)
  {
    return vtkNexradLevel2Reader::CanReadFile(path);
  }
  try
  {
    return nexrad::FindInputFiles({path}).paths.empty() ? 0 : 1;
  }
  catch (const nexrad::Error&)
  {
    return 0; // an empty folder
  }
}

int vtkNexradSeriesReader::Scan()
{
  const Series::Origin from = {this->FileNames, this->SiteName, this->UseSitePosition,
    {this->SitePosition[0], this->SitePosition[1], this->SitePosition[2]}};
  if (this->Scanned && this->Scanned->From == from)
  {
    return 1;
  }
  this->Scanned.reset();
  this->Damage->Initialize();
  if (this->FileNames.empty())
  {
    return this->Fail(vtkErrorCode::NoFileNameError, "no file name was added");
  }
  auto series = std::make_unique<Series>();
  series->From = from;
  vtkNexradForgetAbort(this);
  try
  {
    nexrad::SeriesOptions options;
    options.level2 = this->MakeLevel2Options();
    std::optional<nexrad::SeriesScan> scan = nexrad::ScanInputs(
      {this->FileNames.begin(), this->FileNames.end()}, options, {}, vtkNexradProgress(this));
    if (!scan)
    {
      return 1;
    }
    series->Scan = std::move(*scan);
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::FileNotFoundError, error.what());
  }
  for (const nexrad::InputProblem& problem : series->Scan.problems)
  {
    this->AddDamage(problem.Line());
  }
  std::set<double> times;
  for (const nexrad::SiteSeries& site : series->Scan.sites)
  {
    for (const nexrad::SeriesVolume& volume : site.volumes)
    {
      times.insert(nexrad::ToSeconds(volume.start));
    }
  }
  if (times.empty())
  {
    return this->Fail(vtkErrorCode::FileFormatError, "no ray could be read from any input");
  }
  series->Times.assign(times.begin(), times.end());
  this->Scanned = std::move(series);
  return 1;
}

int vtkNexradSeriesReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  if (!this->Scan())
  {
    return 0;
  }
  if (!this->Scanned)
  {
    return 1; // the scan was aborted
  }
  const std::vector<double>& times = this->Scanned->Times;
  vtkInformation* info = output->GetInformationObject(0);
  vtkNexradOfferTimes(info, times.data(), static_cast<int>(times.size()));
  info->Set(vtkAlgorithm::CAN_HANDLE_PIECE_REQUEST(), 1);
  return 1;
}

int vtkNexradSeriesReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  if (!this->Scanned)
  {
    // The scan failed, and said why; or it was aborted, and the output stays empty.
    return this->GetErrorCode() == vtkErrorCode::NoError ? 1 : 0;
  }
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  vtkInformation* info = output->GetInformationObject(0);
  const double time = vtkNexradRequestedTime(info, this->Scanned->Times.front());
  auto* sweeps = vtkPartitionedDataSetCollection::GetData(output, 0);
  try
  {
    if (!this->ReadAt(time, info, sweeps))
    {
      sweeps->Initialize();
      return 1;
    }
  }
  catch (const nexrad::Error& error)
  {
    sweeps->Initialize();
    return this->Fail(vtkErrorCode::FileFormatError, error.what());
  }
  sweeps->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
  return 1;
}

int vtkNexradSeriesReader::ReadAt(
  double time, vtkInformation* outputInformation, vtkPartitionedDataSetCollection* sweeps)
{
  const nexrad::SeriesScan& scan = this->Scanned->Scan;
  vtkNexradSweepOptions options = this->MakeSweepOptions(outputInformation);
  const std::vector<nexrad::Position> positions = scan.Positions();
  if (!options.Center && !positions.empty())
  {
    const nexrad::GridSpecification grid = nexrad::MakeGrid({}, positions);
    options.Center = {grid.centreLatitude, grid.centreLongitude};
  }
  const nexrad::Time instant = nexrad::FromSeconds(time);
  for (std::size_t i = 0; i < scan.sites.size(); ++i)
  {
    const nexrad::SiteSeries& site = scan.sites[i];
    const auto next = std::upper_bound(site.volumes.begin(), site.volumes.end(), instant,
      [](nexrad::Time wanted, const nexrad::SeriesVolume& volume)
      { return wanted < volume.start; });
    if (next == site.volumes.begin())
    {
      continue;
    }
    const nexrad::SeriesVolume& latest = *(next - 1);
    const std::vector<nexrad::RadarVolume> cycles =
      nexrad::SplitCycles(nexrad::ReadLevel2(latest.file, this->MakeLevel2Options()));
    if (latest.cycle >= cycles.size())
    {
      throw nexrad::Error(latest.file.string() + ": the file changed since it was first read");
    }
    options.NamePrefix = site.site.name.empty() ? std::string() : site.site.name + " ";
    const auto share = static_cast<double>(scan.sites.size());
    const auto done = static_cast<double>(i);
    if (!vtkNexradAppendSweeps(cycles[latest.cycle], options, sweeps,
          vtkNexradProgress(this, done / share, (done + 1.0) / share)))
    {
      return 0;
    }
  }
  return 1;
}

void vtkNexradSeriesReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileNames:\n";
  for (const std::string& name : this->FileNames)
  {
    os << indent.GetNextIndent() << name << "\n";
  }
}
