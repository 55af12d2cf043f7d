// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Time.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

class vtkImageData;

namespace nexrad::scene
{

/// The part of the echo from which on words say that it is biological.
constexpr double MostlyBiological = 0.5;

/// What the field data of a merged volume say about it.
struct VolumeInformation
{
  std::optional<Time> time;
  std::vector<std::string> sites;
  std::string method;     ///< "thesis" or "beam", "" when unknown
  std::string projection; ///< PROJ string of x and y, "" when unknown
  bool synthetic = false; ///< made from simulated files
  bool sharpened = false; ///< REF was deconvolved in elevation
  /// Part of the echo that quality control calls biological, 0…1; 0 when unknown.
  double biologicalShare = 0.0;
  std::vector<std::string> notes; ///< GriddedVolume::notes

  /// Whether x and y are longitude and latitude in degrees; else they are m.
  bool IsGeographic() const { return projection.find("+proj=longlat") != std::string::npos; }
};

VolumeInformation ReadVolumeInformation(vtkImageData* volume);

/// The unit of x and y of a volume: degrees on geographic axes, else metres.
PlaceUnit PlaceUnitOf(vtkImageData* volume);

/// Outer faces of a volume: west, east, south, north, bottom and top, half a voxel beyond the
/// middles of its outermost voxels.
std::array<double, 6> FacesOf(vtkImageData* volume);
/// Those on the ground: west, east, south and north.
std::array<double, 4> SidesOf(vtkImageData* volume);

/// Name of the array that a volume shows, as "REF"; "" where there is no volume, or no name.
std::string ArrayOf(vtkImageData* volume);

} // namespace nexrad::scene
