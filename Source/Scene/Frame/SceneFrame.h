// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "nexrad/Grid/GridSpecification.h"

#include <array>
#include <optional>

class vtkImageData;

namespace nexrad::scene
{

/// How a volume stands in the scene. Scene coordinates are km east and north of the projection's
/// centre, and km above mean sea level times the vertical exaggeration, so that all three axes of
/// the scene have one unit and no actor needs a matrix.
class SceneFrame
{
public:
  SceneFrame() = default;

  /// The frame of a merged volume. `exaggeration` is above 0. A volume without a projection in its
  /// field data has no map: HasMap is then false.
  SceneFrame(vtkImageData* volume, double exaggeration);

  /// Outer faces of the volume: west, east, south, north, bottom, top.
  const std::array<double, 6>& Bounds() const { return bounds; }
  double Exaggeration() const { return exaggeration; }

  /// Scene height of a height in m above mean sea level.
  double Height(double metres) const { return metres / 1000.0 * exaggeration; }

  /// Scene x and y of x and y of the volume (m or degrees).
  std::array<double, 2> FromVolume(const std::array<double, 2>& point) const;

  bool HasMap() const { return map.has_value(); }
  /// Scene x and y of a longitude and latitude. Needs HasMap.
  std::array<double, 2> Place(double longitude, double latitude) const;
  /// Longitude and latitude of a scene point. Needs HasMap.
  std::array<double, 2> Geographic(double x, double y) const;

  /// The point of the scene at a place of the volume: x and y in its units, height in m; and back.
  std::array<double, 3> ToScene(const std::array<double, 3>& place) const;
  std::array<double, 3> ToVolume(const std::array<double, 3>& point) const;
  /// The place of the volume that a camera looks at. Throws Error for a longitude and latitude
  /// without a map.
  std::array<double, 3> PlaceOf(const LookAt& lookAt) const;

  /// Takes the height out of the bounds, for a scene that is a map.
  void Flatten() { bounds[5] = bounds[4]; }

  /// Gives the volume the origin and spacing of the scene. The arrays stay shared.
  void MoveToScene(vtkImageData* volume) const;

private:
  std::array<double, 6> bounds = {-1.0, 1.0, -1.0, 1.0, 0.0, 1.0};
  std::array<double, 2> kilometres = {0.001, 0.001}; // of one unit of the volume's x and y
  std::array<double, 2> centre = {0.0, 0.0};         // volume's x and y at the scene's origin
  double exaggeration = 1.0;
  std::optional<GridSpecification> map;
};

/// The length along a ray that opacities belong to, in scene units: km along the ground.
constexpr double OpacityUnitDistance = 5.0;

/// How much heights of wide domains are stretched when nobody says.
constexpr double UsualExaggeration = 8.0;

/// How much heights are stretched when nobody says: so much that the volume stands about a third as
/// high as it is wide, but at least 1 time, and at most UsualExaggeration, which the default domain
/// of one radar has, 460 km wide and 20 km high.
double DefaultExaggeration(vtkImageData* volume);

/// The frame of a volume with that exaggeration; with the default one for 0.
SceneFrame MakeSceneFrame(vtkImageData* volume, double exaggeration);

} // namespace nexrad::scene
