// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradSweepLayout.h
 * @brief  which grids a sweep needs
 */
#ifndef vtkNexradSweepLayout_h
#define vtkNexradSweepLayout_h

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <vector>

/**
 * Gates at the same ranges, and the moments that are measured there. Gates at negative range are
 * left out.
 */
struct vtkNexradGateGrid
{
  int FirstGate = 0;     ///< m, slant range of the first gate that is not negative
  int GateSpacing = 0;   ///< m
  std::size_t Gates = 0; ///< of the longest ray
  std::vector<nexrad::MomentName> Moments;
};

/**
 * The number of gates of a row at negative range.
 */
std::size_t vtkNexradNegativeGates(const nexrad::MomentRow& row);

/**
 * Whether the row's gates are gates of the grid.
 */
bool vtkNexradBelongsTo(const nexrad::MomentRow& row, const vtkNexradGateGrid& grid);

/**
 * One grid for each distinct gate geometry of the moments, in the order of the moments.
 */
std::vector<vtkNexradGateGrid> vtkNexradLayOutSweep(
  const nexrad::Sweep& sweep, const std::vector<nexrad::MomentName>& moments);

/**
 * True when the rays go all the way round: the gap from the last ray on to the first is not longer
 * than one and a half times the median step from ray to ray.
 */
bool vtkNexradIsFullCircle(const nexrad::Sweep& sweep);

#endif
// VTK-HeaderTest-Exclude: vtkNexradSweepLayout.h
