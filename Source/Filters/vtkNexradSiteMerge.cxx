// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradSiteMerge.h"

#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Quality/Despeckling.h"
#include "nexrad/System/Error.h"
#include "vtkNexradExtent.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradPipeline.h"
#include "vtkNexradPolarConversion.h"

#include "vtkErrorCode.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <iterator>

vtkStandardNewMacro(vtkNexradSiteMerge);

namespace
{

std::vector<nexrad::PolarVolume> ReadInputs(
  vtkInformationVector* inputs, nexrad::MomentName moment, int fewestNeighbours)
{
  std::vector<nexrad::PolarVolume> volumes;
  for (int i = 0; i < inputs->GetNumberOfInformationObjects(); ++i)
  {
    std::vector<nexrad::PolarVolume> own =
      vtkNexradSweepsToPolar(vtkPartitionedDataSetCollection::GetData(inputs, i), moment);
    std::move(own.begin(), own.end(), std::back_inserter(volumes));
  }
  if (volumes.empty())
  {
    throw nexrad::Error(std::string("no input holds a sweep with ") + nexrad::ToString(moment));
  }
  for (nexrad::PolarVolume& volume : volumes)
  {
    nexrad::Despeckle(volume, fewestNeighbours);
  }
  return volumes;
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

} // namespace

vtkNexradSiteMerge::vtkNexradSiteMerge() = default;

vtkNexradSiteMerge::~vtkNexradSiteMerge() = default;

int vtkNexradSiteMerge::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  return 1;
}

int vtkNexradSiteMerge::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkInformation* info = output->GetInformationObject(0);
  this->SetOutputExtent(info);
  // The inputs' own times end here.
  const double range[2] = {this->Time, this->Time};
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_STEPS(), &this->Time, 1);
  info->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  return 1;
}

int vtkNexradSiteMerge::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  auto* image = vtkImageData::GetData(output);
  image->Initialize();
  try
  {
    const std::vector<nexrad::PolarVolume> volumes =
      ReadInputs(input[0], this->CheckMoment(), this->FewestNeighbours);
    const nexrad::GridSpecification grid =
      nexrad::MakeGrid(this->MakeGridRequest(), PositionsOf(volumes));
    const nexrad::VoxelBlock block = vtkNexradRequestedBlock(output->GetInformationObject(0), grid);
    if (block.VoxelCount() == 0)
    {
      return 1;
    }
    std::vector<const nexrad::PolarVolume*> chosen;
    for (const nexrad::PolarVolume& volume : volumes)
    {
      chosen.push_back(&volume);
    }
    const std::optional<nexrad::GriddedVolume> merged = nexrad::MergeVolumes(chosen,
      this->MakeMergeRequest(grid, block, this->Time, this->MaximumGap), vtkNexradProgress(this));
    if (merged)
    {
      vtkNexradVolumeToImage(*merged, image);
      vtkNexradPlaceBlock(grid, block, image);
      image->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), this->Time);
    }
  }
  catch (const nexrad::Error& error)
  {
    return this->Fail(vtkErrorCode::UserError, error.what());
  }
  return 1;
}

void vtkNexradSiteMerge::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Time: " << this->Time << "\n";
  os << indent << "MaximumGap: " << this->MaximumGap << "\n";
}
