// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradGridAlgorithm.h"

#include "nexrad/Calibration/RadarComparison.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/Moments/MomentMaker.h"
#include "nexrad/System/Error.h"
#include "vtkNexradExtent.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradPolarConversion.h"
#include "vtkNexradThreads.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>

namespace
{

nexrad::OverlapStrategy StrategyOf(int strategy)
{
  switch (strategy)
  {
  case vtkNexradGridAlgorithm::MEAN:
    return nexrad::OverlapStrategy::Mean;
  case vtkNexradGridAlgorithm::NEAREST:
    return nexrad::OverlapStrategy::Nearest;
  case vtkNexradGridAlgorithm::MAXIMUM:
    return nexrad::OverlapStrategy::Maximum;
  default:
    return nexrad::OverlapStrategy::Distance;
  }
}

std::vector<nexrad::Position> PositionsOf(const std::vector<nexrad::PolarVolume>& volumes)
{
  std::vector<nexrad::Position> positions;
  for (const nexrad::PolarVolume& volume : volumes)
  {
    if (!volume.site.position)
    {
      throw nexrad::Error(
        "the position of site \"" + volume.site.name + "\" is unknown: set it in the reader");
    }
    positions.push_back(*volume.site.position);
  }
  return positions;
}

// The biases that are taken off the reflectivity of volumes.
nexrad::RadarBiases BiasesFor(
  const nexrad::MergeOptions& options, const std::vector<nexrad::PolarVolume>& volumes)
{
  std::vector<std::string> radars;
  nexrad::LowEchoes echoes;
  for (const nexrad::PolarVolume& volume : volumes)
  {
    radars.push_back(volume.site.name);
    if (options.measureBiases && volume.moment == nexrad::MomentName::REF)
    {
      echoes.push_back(std::make_shared<const nexrad::LowEcho>(volume));
    }
  }
  nexrad::RequireRadars(options.beam.biases, radars);
  return options.measureBiases ? nexrad::CompareRadars(echoes).biases : options.beam.biases;
}

} // namespace

vtkNexradGridAlgorithm::vtkNexradGridAlgorithm() = default;

vtkNexradGridAlgorithm::~vtkNexradGridAlgorithm() = default;

void vtkNexradGridAlgorithm::SetMethod(int method)
{
  if (method != THESIS && method != BEAM)
  {
    vtkErrorMacro("method " << method << " is unknown: it can be THESIS (" << THESIS
                            << ") or BEAM (" << BEAM << ")");
    return;
  }
  if (this->Method != method)
  {
    this->Method = method;
    this->Modified();
  }
}

std::vector<nexrad::MomentName> vtkNexradGridAlgorithm::CheckMoments() const
{
  std::vector<nexrad::MomentName> moments = nexrad::ParseMomentNames(this->Moment);
  if (moments.empty())
  {
    throw nexrad::Error("moment " + this->Moment + " is unknown: set " + nexrad::MomentNameList());
  }
  for (const nexrad::MomentName moment : moments)
  {
    nexrad::RequireMoment(
      this->Method == THESIS ? nexrad::MergeMethod::Thesis : nexrad::MergeMethod::Beam, moment);
  }
  return moments;
}

nexrad::MomentName vtkNexradGridAlgorithm::CheckMoment() const
{
  const std::vector<nexrad::MomentName> moments = this->CheckMoments();
  if (moments.size() > 1)
  {
    throw nexrad::Error(
      "moments " + this->Moment + ": set one; vtkNexradDayReader merges several in one run");
  }
  return moments.front();
}

nexrad::GridRequest vtkNexradGridAlgorithm::MakeGridRequest() const
{
  nexrad::GridRequest request;
  std::copy_n(this->Dimensions, 3, request.dimensions.begin());
  request.range = this->Range;
  request.bottom = this->HeightRange[0];
  request.top = this->HeightRange[1];
  if (this->UseGeographicBounds)
  {
    request.bounds = nexrad::GeographicBounds{this->GeographicBounds[0], this->GeographicBounds[1],
      this->GeographicBounds[2], this->GeographicBounds[3]};
  }
  request.axes =
    this->Axes == GEOGRAPHIC ? nexrad::GridAxes::Geographic : nexrad::GridAxes::Projected;
  return request;
}

nexrad::MergeOptions vtkNexradGridAlgorithm::MakeMergeOptions() const
{
  nexrad::MergeOptions options;
  options.furtherMoments = this->CheckMoments();
  options.moment = options.furtherMoments.front();
  options.furtherMoments.erase(options.furtherMoments.begin());
  options.grid = this->MakeGridRequest();
  options.method = this->Method == THESIS ? nexrad::MergeMethod::Thesis : nexrad::MergeMethod::Beam;
  options.quality.level = static_cast<nexrad::QualityLevel>(this->Quality);
  options.quality.neighbours = this->FewestNeighbours;
  options.dealias = this->Dealiasing;
  if (this->UseStormMotion)
  {
    options.stormMotion = nexrad::Wind{this->StormMotion[0], this->StormMotion[1]};
  }
  const nexrad::BiasRequest bias = nexrad::ParseBiasRequest(this->Bias);
  options.measureBiases = bias.measured;
  options.beam.biases = bias.given;
  options.beam.strategy = StrategyOf(this->OverlapStrategy);
  options.beam.overlapLength = this->OverlapLength;
  options.beam.linearReflectivity = this->LinearReflectivity;
  options.beam.sharpen = this->Sharpening;
  options.beam.fillColumns = this->ColumnFilling;
  options.beam.ancillary = this->AncillaryArrays;
  options.interpolation = this->TimeInterpolation == LINEAR
                            ? nexrad::TimeInterpolationMethod::Linear
                            : nexrad::TimeInterpolationMethod::AlongMotion;
  if (this->UseGivenMotion)
  {
    options.motion = nexrad::Velocity{this->GivenMotion[0], this->GivenMotion[1]};
  }
  return options;
}

std::vector<nexrad::PolarVolume> vtkNexradGridAlgorithm::ReadSweeps(vtkInformationVector* inputs)
{
  const nexrad::MomentName moment = this->CheckMoment();
  const nexrad::MomentOptions options = nexrad::MomentOptionsOf(this->MakeMergeOptions());
  std::vector<nexrad::PolarVolume> volumes;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    vtkNexradPolarVolumes input(vtkPartitionedDataSetCollection::GetData(inputs, i));
    for (const nexrad::PolarVolume& each : input.Of(nexrad::MeasuredFor(moment)))
    {
      nexrad::MomentMaker maker([&](nexrad::MomentName measured, const nexrad::WantedRange&)
        { return input.Find(measured, each); },
        options);
      volumes.push_back(maker.Make(moment));
      if (!maker.Note().empty())
      {
        vtkWarningMacro(<< each.site.name << ": " << maker.Note());
      }
    }
  }
  return volumes;
}

void vtkNexradGridAlgorithm::MergeSweeps(const std::vector<nexrad::PolarVolume>& volumes,
  double time, double maximumGap, vtkInformationVector* output)
{
  const nexrad::MergeOptions options = this->MakeMergeOptions();
  nexrad::MergeRequest request = nexrad::MergeRequestOf(options, vtkNexradRangeLoop());
  request.grid = nexrad::MakeGrid(options.grid, PositionsOf(volumes));
  request.beam.biases = BiasesFor(options, volumes);
  request.block = vtkNexradRequestedBlock(output->GetInformationObject(0), request.grid);
  request.time = nexrad::FromSeconds(time);
  request.maximumGap = nexrad::DurationOf(maximumGap);
  if (request.block->VoxelCount() == 0)
  {
    return;
  }
  std::vector<const nexrad::PolarVolume*> chosen;
  for (const nexrad::PolarVolume& volume : volumes)
  {
    chosen.push_back(&volume);
  }
  if (const auto merged = nexrad::MergeVolumes(chosen, request, vtkNexradProgress(this)))
  {
    FillOutput(*merged, request.grid, *request.block, time, vtkImageData::GetData(output));
  }
}

vtkImageData* vtkNexradGridAlgorithm::BeginOutput(vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  auto* image = vtkImageData::GetData(output);
  image->Initialize();
  return image;
}

void vtkNexradGridAlgorithm::FillOutput(const nexrad::GriddedVolume& merged,
  const nexrad::GridSpecification& grid, const nexrad::VoxelBlock& block, double time,
  vtkImageData* image)
{
  vtkNexradVolumeToImage(merged, image);
  vtkNexradPlaceBlock(grid, block, image);
  image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
}

int vtkNexradGridAlgorithm::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkNexradGridAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetOutputExtent(output->GetInformationObject(0));
  return 1;
}

void vtkNexradGridAlgorithm::SetOutputExtent(vtkInformation* outputInformation) const
{
  vtkNexradOfferExtent(outputInformation, this->Dimensions);
  vtkDataObject::SetPointDataActiveScalarInfo(outputInformation, VTK_FLOAT, 1);
}

int vtkNexradGridAlgorithm::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < input[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = input[port]->GetInformationObject(i);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

int vtkNexradGridAlgorithm::Fail(unsigned long code, const std::string& line)
{
  this->SetErrorCode(code);
  return vtkNexradFail(this, line);
}

void vtkNexradGridAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << ", " << this->Dimensions[1] << ", "
     << this->Dimensions[2] << "\n";
  os << indent << "Range: " << this->Range << "\n";
  os << indent << "HeightRange: " << this->HeightRange[0] << ", " << this->HeightRange[1] << "\n";
  os << indent << "UseGeographicBounds: " << this->UseGeographicBounds << "\n";
  os << indent << "GeographicBounds: " << this->GeographicBounds[0] << ", "
     << this->GeographicBounds[1] << ", " << this->GeographicBounds[2] << ", "
     << this->GeographicBounds[3] << "\n";
  os << indent << "Axes: " << this->Axes << "\n";
  os << indent << "Moment: " << this->Moment << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "FewestNeighbours: " << this->FewestNeighbours << "\n";
  os << indent << "Quality: " << this->Quality << "\n";
  os << indent << "Dealiasing: " << this->Dealiasing << "\n";
  os << indent << "UseStormMotion: " << this->UseStormMotion << "\n";
  os << indent << "StormMotion: " << this->StormMotion[0] << ", " << this->StormMotion[1] << "\n";
  os << indent << "Bias: " << this->Bias << "\n";
  os << indent << "OverlapStrategy: " << this->OverlapStrategy << "\n";
  os << indent << "OverlapLength: " << this->OverlapLength << "\n";
  os << indent << "TimeInterpolation: " << this->TimeInterpolation << "\n";
  os << indent << "GivenMotion: " << this->GivenMotion[0] << ", " << this->GivenMotion[1] << "\n";
  os << indent << "UseGivenMotion: " << this->UseGivenMotion << "\n";
  os << indent << "LinearReflectivity: " << this->LinearReflectivity << "\n";
  os << indent << "Sharpening: " << this->Sharpening << "\n";
  os << indent << "ColumnFilling: " << this->ColumnFilling << "\n";
  os << indent << "AncillaryArrays: " << this->AncillaryArrays << "\n";
}
