// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradPolarConversion.h
 * @brief  from the readers' sweeps back to the rays that the classes of echo are found of
 *
 * The inverse of vtkNexradSweepConversion.h: times, angles and gate geometry come from the field
 * data, so that nothing is lost on the way through the points' coordinates. The values of a sweep
 * are rounded to steps of a power of two, at most 1/32000 of their range (0.002 dB of 60 dB). The
 * half decibels that files hold are multiples of such a step, and stay exact.
 */
#ifndef vtkNexradPolarConversion_h
#define vtkNexradPolarConversion_h

#include "nexrad/Polar/PolarVolume.h"

#include <vector>

class vtkPartitionedDataSetCollection;
class vtkStructuredGrid;

/**
 * Where a polar sweep comes from: its grid, and of each of its rays the row in it.
 */
struct vtkNexradSweepOrigin
{
  vtkStructuredGrid* Grid = nullptr;
  std::vector<int> Rows;
};

/**
 * The volumes whose sweeps are in the collection: those of one site with one start time make one
 * volume, which has its site's name, its start and its sweeps alone. Grids without the moment are
 * passed over, and so are, in each grid, rays that it has no gate of. What decides which gates
 * count (`Waveform`, `UnambiguousRange`) may be absent; then all do. The moment is a measured one.
 * Throws nexrad::Error, naming the sweep and the array, for a grid with the moment that lacks its
 * field data, or in which they do not fit its dimensions. `origins`, when given, takes those of all
 * sweeps of all volumes, in the order of the result.
 */
std::vector<nexrad::PolarVolume> vtkNexradSweepsToPolar(vtkPartitionedDataSetCollection* sweeps,
  nexrad::MomentName moment, std::vector<std::vector<vtkNexradSweepOrigin>>* origins = nullptr);

#endif
// VTK-HeaderTest-Exclude: vtkNexradPolarConversion.h
