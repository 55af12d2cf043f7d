// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradSweepConversion.h
 * @brief  from a radar volume as the core knows it to structured grids
 *
 * One vtkPartitionedDataSet a sweep, one vtkStructuredGrid in it for each distinct gate geometry.
 * Point data of a grid:
 *
 * - `REF`, `VEL`, ..., float32: values in the moment's unit, NaN where there is none.
 * - `REF_state`, ..., uint8: 0 valid, 1 below threshold, 2 range folded, 3 not sampled.
 *
 * Field data of the collection and of each grid (absent when unknown):
 *
 * - `File`, string: path of the file.
 * - `Site`, string: name of the radar.
 * - `Position`, float64, three components: latitude and longitude in degrees, height of the antenna
 *   in m above mean sea level.
 * - `VCP`, int32: number of the volume coverage pattern.
 * - `StartTime`, `EndTime`, float64: first and last ray of the volume, seconds since
 *   1970-01-01T00:00:00Z.
 * - `Synthetic`, uint8: 1 for a simulated file.
 *
 * Field data of each grid:
 *
 * - `SweepIndex`, int32: from 0 in the order scanned.
 * - `ElevationNumber`, int32: number of the cut in the coverage pattern, from 1.
 * - `GateGeometry`, float64, two components: slant range of the first gate and spacing, m.
 * - `RayTime`, float64, a tuple for each ray: seconds since 1970-01-01T00:00:00Z.
 * - `RayAzimuth`, `RayElevation`, float32, a tuple for each ray: degrees.
 * - `NyquistVelocity`, float32, a tuple for each ray: m/s, 0 when unknown.
 * - `UnambiguousRange`, float32, a tuple for each ray: m, 0 when unknown.
 * - `Waveform`, int32: of the cut, as message 5 numbers it; 0 when unknown, 1 contiguous
 *   surveillance, 2 contiguous Doppler, 3 contiguous Doppler without ambiguity resolution, 4 batch,
 *   5 staggered pulse pair.
 *
 * A grid has one row more than rays when the first ray is repeated at its end.
 */
#ifndef vtkNexradSweepConversion_h
#define vtkNexradSweepConversion_h

#include "nexrad/Model/RadarVolume.h"
#include "nexrad/System/Progress.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkPartitionedDataSetCollection;

/// With the numbers of vtkNexradSweepReader::CoordinateSystem.
enum class vtkNexradCoordinates
{
  Local,      ///< m east, north and up of the antenna
  Geographic, ///< degrees east and north, m above mean sea level
  Projected   ///< m east and north of a centre, m above mean sea level, as in a merged volume
};

struct vtkNexradSweepOptions
{
  vtkNexradCoordinates Coordinates = vtkNexradCoordinates::Local;
  std::optional<std::array<double, 2>> Center; ///< latitude, longitude; the site's when empty
  double EffectiveRadiusFactor = 4.0 / 3.0;
  std::vector<nexrad::MomentName> Moments; ///< those wanted
  std::string NamePrefix;                  ///< before "Sweep 03 1.45 deg"
  unsigned int Piece = 0;  ///< of Pieces: of each Pieces data sets in turn, this one is filled
  unsigned int Pieces = 1; ///< at least 1; the others have no grids
};

/**
 * Appends the volume's sweeps to the collection, with their names and their nodes in the data
 * assembly. The collection's field data are those of the last volume. False when `progress` asked
 * to stop. Throws nexrad::Error when the site's position is needed and unknown.
 */
bool vtkNexradAppendSweeps(const nexrad::RadarVolume& volume, const vtkNexradSweepOptions& options,
  vtkPartitionedDataSetCollection* output, const nexrad::Progress& progress);

#endif
// VTK-HeaderTest-Exclude: vtkNexradSweepConversion.h
