// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <vector>

class vtkCamera;
class vtkRenderer;

namespace nexrad::scene
{

/// A place that the camera looks at.
struct LookAt
{
  std::array<double, 3> place{}; ///< x and y of the volume, or longitude and latitude in degrees;
                                 ///< height in m above mean sea level
  bool geographic = false;       ///< whether it is longitude and latitude

  bool operator==(const LookAt& other) const
  {
    return place == other.place && geographic == other.geographic;
  }
};

/// From where the scene is looked at.
struct CameraView
{
  double azimuth = 200.0; ///< degrees clockwise from north, from the domain's centre to the camera:
                          ///< 180 looks north
  double tilt = 35.0;     ///< degrees above the horizon, −90…90; 90 looks straight down
  double zoom = 1.0;      ///< above 0; 1 shows the whole box, 2 half of it
  bool parallel = false;  ///< parallel in place of perspective projection
  std::optional<LookAt> lookAt = {}; ///< what is in the middle of the picture, once the camera has
                                     ///< moved sideways to it; empty: the domain fills the picture
  double nearness = 1.0;             ///< 0…1, how far the camera has moved on its way to lookAt

  bool operator==(const CameraView& other) const
  {
    return azimuth == other.azimuth && tilt == other.tilt && zoom == other.zoom &&
           parallel == other.parallel && lookAt == other.lookAt && nearness == other.nearness;
  }
};

/// The part of the picture that the scene may fill, each −1 (left, bottom) … 1 (right, top).
struct PictureArea
{
  double left = -1.0;
  double right = 1.0;
  double bottom = -1.0;
  double top = 1.0;
};

/// Points the camera so that a box (west, east, south, north, bottom, top) just fits the area of a
/// picture whose width is `aspect` times its height.
void PointCamera(vtkCamera* camera, const CameraView& view, const std::array<double, 6>& box,
  double aspect, const PictureArea& area);

/// The same for points of the scene; at least one.
void PointCamera(vtkCamera* camera, const CameraView& view,
  const std::vector<std::array<double, 3>>& points, double aspect, const PictureArea& area);

/// Moves the camera sideways until a point of the scene is in the middle of the picture, or a part
/// of this way, 0…1. What the camera sees keeps its direction and its size.
void CentreOn(vtkCamera* camera, const std::array<double, 3>& point, double part = 1.0);

/// The view at a part of the way, 0…1, on which the camera flies from the whole frame to `view`. It
/// starts and ends gently; what `view` looks at comes straight to the middle of the picture.
CameraView OnTheWayTo(const CameraView& view, double part);

/// The camera's right-hand direction, a unit vector on the ground.
std::array<double, 2> RightOf(const CameraView& view);

/// How far a point of the scene lies before the camera.
double DepthBefore(vtkCamera* camera, const double point[3]);

/// Half the height of what a picture shows at the distance of a point, in scene units.
double HalfHeightAt(vtkCamera* camera, const double point[3]);

/// What a picture shows of a box of the scene.
struct SeenPart
{
  std::array<double, 4> faces = {0.0, 0.0, 0.0, 0.0}; ///< west, east, south, north, in scene units
  double pixel = 0.0; ///< side of a pixel where the box is nearest to the camera, in scene units
};

/// The part of a box (west, east, south, north, bottom, top) that a picture of `size` pixels shows
/// through a renderer's camera. Nothing where it shows none.
std::optional<SeenPart> FindSeen(
  vtkRenderer* renderer, const std::array<int, 2>& size, const std::array<double, 6>& box);

} // namespace nexrad::scene
