// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradNetCDFGrid.h
 * @brief  the grid of a merged volume in a NetCDF file: dimensions, coordinates, projection
 */
#ifndef vtkNexradNetCDFGrid_h
#define vtkNexradNetCDFGrid_h

#include "nexrad/Grid/GridSpecification.h"

#include <array>

class vtkNexradNetCDFFile;

/// Numbers of the dimensions that all volumes of a file share.
struct vtkNexradNetCDFDimensions
{
  int Time = -1;                          ///< grows with each volume
  std::array<int, 3> Axes = {-1, -1, -1}; ///< x, y, z
};

/// Name of the grid mapping variable.
constexpr char vtkNexradGridMapping[] = "projection";

/**
 * Defines the dimensions of a grid, and writes its coordinates: x, y and z in m (longitude and
 * latitude in degrees with geographic axes), the grid mapping, and for a projected grid the
 * latitude and longitude of each column.
 */
vtkNexradNetCDFDimensions vtkNexradWriteGrid(
  const vtkNexradNetCDFFile& file, const nexrad::GridSpecification& grid);

#endif
// VTK-HeaderTest-Exclude: vtkNexradNetCDFGrid.h
