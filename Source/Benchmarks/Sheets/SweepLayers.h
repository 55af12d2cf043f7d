// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/SiteSeries.h"

#include <vtkSmartPointer.h>

#include <array>
#include <cstddef>
#include <vector>

class vtkProp;
class vtkScalarsToColors;
class vtkStructuredGrid;

namespace nexrad::scene
{

/// One sweep of a volume: a cone, with the reflectivity at the centres of those gates that lie in
/// the scene.
struct SweepLayer
{
  double elevation = 0.0; ///< degrees, the mean of its rays
  std::size_t rays = 0;
  std::size_t gates = 0;  ///< of each ray, in the scene
  std::size_t echoes = 0; ///< gates of the least reflectivity that is drawn, or more
  double largest = 0.0;   ///< dBZ; of no meaning without echoes
  vtkSmartPointer<vtkStructuredGrid> grid; ///< m east and north of the centre, m above mean sea
                                           ///< level
};

/// What of the sweeps is shown.
struct SweepReach
{
  std::array<double, 2> centre{}; ///< of the scene: latitude and longitude, degrees
  double range = 230'000.0;       ///< m along the ray
  double top = 20'000.0;          ///< m above mean sea level
  double least = 5.0;             ///< least reflectivity that counts as echo, dBZ
};

/// The sweeps of a volume from the lowest to the highest; of several at one elevation (within a
/// quarter of a degree) the first with reflectivity. Throws Error when the file cannot be read.
std::vector<SweepLayer> ReadSweepLayers(const SeriesVolume& volume, const SweepReach& reach);

/// How a sweep is shown in a scene.
struct SweepStyle
{
  vtkScalarsToColors* colours = nullptr; ///< of dBZ
  double least = 5.0;                    ///< dBZ
  double exaggeration = 1.0;             ///< of heights
  double labelAzimuth = 90.0; ///< degrees clockwise from north, where the elevation stands beside
                              ///< the ring
  int textSize = 10;          ///< pixels
};

/// A sweep's echo in flat colours, and a ring at its last gates with the elevation beside.
std::vector<vtkSmartPointer<vtkProp>> MakeSweepProps(
  const SweepLayer& layer, const SweepStyle& style);

} // namespace nexrad::scene
