// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradVolumeFile.h
 * @brief  reads a .nxv file into a vtkImageData
 */
#ifndef vtkNexradVolumeFile_h
#define vtkNexradVolumeFile_h

#include "vtkNexradIOModule.h" // For export macro

#include "nexrad/Grid/VoxelBlock.h"
#include "nexrad/Model/Moment.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

/**
 * What of a file is wanted, and as what.
 */
struct vtkNexradVolumeFile
{
  std::string FileName;
  /// Names of ancillary arrays not to read.
  std::vector<std::string> LeaveOut;
  /// Moments to read, the first as the active scalars; empty: all, in the order of the file.
  std::vector<nexrad::MomentName> Moments;
  /// Scalars are codes where one moment is read and the file has codes of one byte of it
  /// (vtkNexradImageConversion.h).
  bool Codes = false;
  /// Bytes that the caller makes of each voxel of the image; with the image's own they count for
  /// the limit of memory (nexrad::NxvReadOptions).
  std::size_t BytesBesides = 0;
  /// The part of the level's grid to read; empty: all. The image is one of the part alone.
  std::optional<nexrad::VoxelBlock> Block = {};
  /// Which of nexrad::ReadNxvLevels is read.
  std::size_t Level = 0;
};

/**
 * Fills the image with voxels of the file, unpacked on several threads. Throws nexrad::Error as
 * nexrad::ReadNxv does.
 */
VTKNEXRADIO_EXPORT void vtkNexradReadVolumeFile(
  const vtkNexradVolumeFile& file, vtkImageData* image);

#endif
// VTK-HeaderTest-Exclude: vtkNexradVolumeFile.h
