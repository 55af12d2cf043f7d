// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Theme.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Products/VerticalSection.h"

#include <vtkSmartPointer.h>

#include <array>
#include <optional>

class vtkImageData;
class vtkPlaneCollection;
class vtkVolumeMapper;

namespace nexrad::scene
{

/// A plane in the coordinates of the volume. The part of the volume towards which the normal points
/// is shown.
struct CutPlane
{
  std::array<double, 3> origin = {0.0, 0.0, 0.0}; ///< x and y as the volume has them, m upward
  std::array<double, 3> normal = {0.0, 1.0, 0.0}; ///< of any length but 0, in the same units

  bool operator==(const CutPlane& other) const
  {
    return origin == other.origin && normal == other.normal;
  }
};

/// Which part of the volume is shown, and where it is cut.
struct CutOptions
{
  PlaceUnit unit = PlaceUnit::OfVolume; ///< of x and y of all that follows
  /// What is shown: west, east, south, north in x and y of the volume, bottom and top in m above
  /// mean sea level; empty: all.
  std::optional<std::array<double, 6>> box;
  std::optional<CutPlane> plane;      ///< empty: none
  std::optional<SectionLine> section; ///< drawn on the ground with its ends A and B; empty: none

  bool operator==(const CutOptions& other) const
  {
    return unit == other.unit && box == other.box && plane == other.plane &&
           section == other.section;
  }
  bool operator!=(const CutOptions& other) const { return !(*this == other); }
};

/// Throws Error for a box whose upper bounds are not above the lower ones, for a plane whose normal
/// is 0, and for numbers that are not finite.
void CheckCut(const CutOptions& cut);

/// Throws Error for cuts in another unit than that of the volume's x and y.
void CheckCutUnit(const CutOptions& cut, vtkImageData* volume);

/// The planes of the scene that the box and the plane are. What all their normals point to is left.
vtkSmartPointer<vtkPlaneCollection> CutPlanesOf(const CutOptions& cut, const SceneFrame& frame);

/// The line of a section on the ground, with discs at its ends, and their names A and B. `height`:
/// of the ground in the scene.
SceneLayer MakeSectionMark(const SectionLine& line, const SceneFrame& frame, double height,
  int textSize, const Theme& theme);

/// The edges of a box of the domain (west, east, south and north), and the time of what is drawn in
/// it, where it is known.
SceneLayer MakeBoxMark(const std::array<double, 4>& faces, const std::optional<Time>& time,
  const SceneFrame& frame, int textSize, const Theme& theme);

} // namespace nexrad::scene
