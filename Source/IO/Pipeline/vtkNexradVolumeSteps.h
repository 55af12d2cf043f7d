// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradVolumeSteps.h
 * @brief  the time steps of merged volumes that a file or an index of files has
 */
#ifndef vtkNexradVolumeSteps_h
#define vtkNexradVolumeSteps_h

#include "vtkNexradIOModule.h" // For export macro

#include "nexrad/Grid/GridSpecification.h"

#include <filesystem>
#include <string>
#include <vector>

/// One volume.
struct vtkNexradVolumeStep
{
  double Time; ///< s since 1970-01-01T00:00:00Z
  std::filesystem::path File;
};

/// The volumes that a file name stands for, and what the first of them holds.
struct vtkNexradVolumeSteps
{
  std::vector<vtkNexradVolumeStep> Steps; ///< at least one, ascending
  bool HasTimes = true;                   ///< false: of a single volume that does not know its time
  nexrad::GridSpecification Grid;
  bool OfOneRadar = false;            ///< GriddedVolume::ofOneRadar
  std::vector<std::string> Ancillary; ///< names of the arrays in the file, as REF_age
  bool AsCodes = false;               ///< the active scalars are given as codes of one byte
};

/**
 * Steps of an index (`.series`), ascending, at the times that it says; of the path of another file,
 * one step of that file at the time 0. Throws nexrad::Error for an index that cannot be read, and
 * for one that names no file.
 */
VTKNEXRADIO_EXPORT std::vector<vtkNexradVolumeStep> vtkNexradListedSteps(
  const std::filesystem::path& path);

/**
 * Whether a path is that of an index.
 */
VTKNEXRADIO_EXPORT bool vtkNexradIsIndex(const std::filesystem::path& path);

#endif
// VTK-HeaderTest-Exclude: vtkNexradVolumeSteps.h
