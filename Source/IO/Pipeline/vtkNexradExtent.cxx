// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradExtent.h"

#include "nexrad/Grid/VoxelBlock.h"

#include "vtkAlgorithm.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cstddef>

void vtkNexradOfferExtent(vtkInformation* outputInformation, const int dimensions[3])
{
  int extent[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    extent[2 * axis] = 0;
    extent[2 * axis + 1] = std::max(0, dimensions[axis] - 1);
  }
  outputInformation->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  outputInformation->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
}

nexrad::VoxelBlock vtkNexradRequestedBlock(
  vtkInformation* outputInformation, const nexrad::GridSpecification& grid)
{
  nexrad::VoxelBlock block = nexrad::VoxelBlock::Of(grid);
  if (const int* extent = outputInformation->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()))
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      block.begin[axis] = extent[2 * axis];
      block.end[axis] = extent[2 * axis + 1] + 1;
    }
  }
  return block;
}

void vtkNexradPlaceBlock(
  const nexrad::GridSpecification& grid, const nexrad::VoxelBlock& block, vtkImageData* image)
{
  image->SetExtent(block.begin[0], block.end[0] - 1, block.begin[1], block.end[1] - 1,
    block.begin[2], block.end[2] - 1);
  image->SetOrigin(grid.origin.data());
}
