// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFInput.h
 * @brief  reads merged volumes from NetCDF files that vtkNexradNetCDFOutput wrote
 */
#ifndef vtkNexradNetCDFInput_h
#define vtkNexradNetCDFInput_h

#include "vtkNexradIOModule.h" // For export macro

#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

/// What a file holds.
struct vtkNexradNetCDFContents
{
  nexrad::GridSpecification Grid;
  std::vector<nexrad::Time> Times; ///< ascending, at least one
  std::vector<nexrad::MomentName> Moments;
  bool OfOneRadar = false;            ///< GriddedVolume::ofOneRadar
  std::vector<std::string> Ancillary; ///< names of the arrays, as REF_age
};

/**
 * Reads what a file holds, without values. Throws nexrad::Error, naming the file, for a file that
 * cannot be read or is no file of merged volumes.
 */
VTKNEXRADIO_EXPORT vtkNexradNetCDFContents vtkNexradReadNetCDFContents(
  const std::filesystem::path& path);

/// What of a file is wanted.
struct vtkNexradNetCDFRequest
{
  std::size_t Time = 0; ///< which of the times, from 0
  /// Moments to read; the first is that of the volume. Empty: all, in the order of the file.
  std::vector<nexrad::MomentName> Moments = {};
  std::vector<std::string> LeaveOut = {};          ///< names of ancillary arrays not to read
  std::size_t MaximumBytes = std::size_t(4) << 30; ///< for the voxels in memory
};

/**
 * Reads the volume at one time. Throws nexrad::Error as vtkNexradReadNetCDFContents does, for a
 * moment or time that the file does not have, for more voxels than MaximumBytes hold, and for
 * arrays of another type, shape or range than Documentation/Formats/netcdf.md says.
 */
VTKNEXRADIO_EXPORT nexrad::GriddedVolume vtkNexradReadNetCDF(
  const std::filesystem::path& path, const vtkNexradNetCDFRequest& request = {});

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFInput.h
