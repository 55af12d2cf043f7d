// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradVolumeResampler.h"

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

vtkStandardNewMacro(vtkNexradVolumeResampler);

vtkNexradVolumeResampler::vtkNexradVolumeResampler() = default;

vtkNexradVolumeResampler::~vtkNexradVolumeResampler() = default;

int vtkNexradVolumeResampler::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkNexradVolumeResampler::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  this->SetOutputExtent(output->GetInformationObject(0));
  return 1;
}

int vtkNexradVolumeResampler::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  this->SetErrorCode(vtkErrorCode::NoError);
  vtkNexradForgetAbort(this);
  auto* image = vtkImageData::GetData(output);
  image->Initialize();
  try
  {
    std::vector<nexrad::PolarVolume> volumes = vtkNexradSweepsToPolar(
      vtkPartitionedDataSetCollection::GetData(input[0]), this->CheckMoment());
    if (volumes.size() != 1)
    {
      throw nexrad::Error("the input holds " + std::to_string(volumes.size()) + " volumes with " +
                          this->Moment + ": one is needed (vtkNexradSiteMerge takes several)");
    }
    nexrad::PolarVolume& volume = volumes.front();
    nexrad::Despeckle(volume, this->FewestNeighbours);
    if (!volume.site.position)
    {
      throw nexrad::Error(
        "the position of site \"" + volume.site.name + "\" is unknown: set it in the reader");
    }
    const double time = nexrad::ToSeconds(volume.start);
    constexpr double wholeDay = 86400.0; // no ray of the volume is too far from its start
    const nexrad::GridSpecification grid =
      nexrad::MakeGrid(this->MakeGridRequest(), {*volume.site.position});
    const nexrad::VoxelBlock block = vtkNexradRequestedBlock(output->GetInformationObject(0), grid);
    if (block.VoxelCount() == 0)
    {
      return 1;
    }
    const std::optional<nexrad::GriddedVolume> gridded = nexrad::MergeVolumes(
      {&volume}, this->MakeMergeRequest(grid, block, time, wholeDay), vtkNexradProgress(this));
    if (gridded)
    {
      vtkNexradVolumeToImage(*gridded, image);
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

void vtkNexradVolumeResampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}
