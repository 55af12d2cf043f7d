// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"
#include "nexrad/Grid/GridSpecification.h"

#include <array>
#include <optional>

class vtkImageData;

namespace nexrad::scene
{

struct VolumeInformation;

/// The length along a ray that the opacities of presets belong to, in scene units: km along the
/// ground.
constexpr double OpacityUnitDistance = 5.0;

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
  /// The same, where the volume's information was read.
  SceneFrame(vtkImageData* volume, const VolumeInformation& information, double exaggeration);

  /// Outer faces of the volume: west, east, south, north, bottom, top.
  const std::array<double, 6>& Bounds() const { return bounds; }
  /// The part of these that the camera looks at, with walls and scales about it. All of them, until
  /// SetFramed is called.
  const std::array<double, 6>& Framed() const { return framed; }
  /// Frames the part of the volume within a box in its x and y, and heights in m.
  void SetFramed(const std::array<double, 6>& box);
  /// That box, within the volume; all of the volume until SetFramed is called.
  std::array<double, 6> FramedInVolume() const;
  /// Whether such a box lies in what is framed.
  bool Holds(const std::array<double, 6>& box) const;

  /// The length along a ray to which opacities belong, in scene units.
  double OpacityDistance() const { return opacityDistance; }
  void SetOpacityDistance(double distance) { opacityDistance = distance; }
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
  void Flatten()
  {
    bounds[5] = bounds[4];
    framed[5] = framed[4];
  }

  /// Gives the volume the origin and spacing of the scene. The arrays stay shared.
  void MoveToScene(vtkImageData* volume) const;

private:
  std::array<double, 6> bounds = {-1.0, 1.0, -1.0, 1.0, 0.0, 1.0};
  std::array<double, 6> framed = bounds;
  std::array<double, 2> kilometres = {0.001, 0.001}; // of one unit of the volume's x and y
  std::array<double, 2> centre = {0.0, 0.0};         // volume's x and y at the scene's origin
  double exaggeration = 1.0;
  double opacityDistance = OpacityUnitDistance;
  std::optional<GridSpecification> map;
};

/// How much heights are stretched when nobody says, for what is framed, in km: 3 times for what one
/// radar sees, up to 8 times for what many see. A frame that is high for its width is stretched
/// less, so that it stands at most 3/4 as high as it is wide, but at least to scale.
double DefaultExaggeration(double width, double height);

} // namespace nexrad::scene
