// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradExtent.h
 * @brief  pieces of a merged volume: what a pipeline asks for, and where it stands
 *
 * A pipeline that runs in several processes, or that streams, asks for boxes of the voxels
 * (UPDATE_EXTENT). Origin and spacing of an image are those of the whole grid; its extent says
 * which part it is.
 */
#ifndef vtkNexradExtent_h
#define vtkNexradExtent_h

#include "vtkNexradIOModule.h" // For export macro

class vtkImageData;
class vtkInformation;

namespace nexrad
{
struct GridSpecification;
struct VoxelBlock;
} // namespace nexrad

/**
 * Says in an output's information that there are so many voxels along each axis, of which any box
 * can be asked for.
 */
VTKNEXRADIO_EXPORT void vtkNexradOfferExtent(
  vtkInformation* outputInformation, const int dimensions[3]);

/**
 * The voxels of the grid that a request asks for: all where it does not say it; it may be none.
 */
VTKNEXRADIO_EXPORT nexrad::VoxelBlock vtkNexradRequestedBlock(
  vtkInformation* outputInformation, const nexrad::GridSpecification& grid);

/**
 * Makes an image of the block alone the block's part of an image of the grid.
 */
VTKNEXRADIO_EXPORT void vtkNexradPlaceBlock(
  const nexrad::GridSpecification& grid, const nexrad::VoxelBlock& block, vtkImageData* image);

#endif
// VTK-HeaderTest-Exclude: vtkNexradExtent.h
