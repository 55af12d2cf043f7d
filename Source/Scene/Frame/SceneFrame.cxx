// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/SceneFrame.h"

#include "Scene/Frame/VolumeInformation.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/System/Error.h"

#include <vtkImageData.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace nexrad::scene
{
namespace
{

// The number behind "+name=" in a PROJ string.
std::optional<double> Parameter(const std::string& projection, const std::string& name)
{
  const std::string key = "+" + name + "=";
  const std::size_t position = projection.find(key);
  if (position == std::string::npos)
  {
    return std::nullopt;
  }
  return std::strtod(projection.c_str() + position + key.size(), nullptr);
}

} // namespace

SceneFrame::SceneFrame(vtkImageData* volume, double verticalExaggeration)
  : SceneFrame(volume, ReadVolumeInformation(volume), verticalExaggeration)
{
}

SceneFrame::SceneFrame(
  vtkImageData* volume, const VolumeInformation& information, double verticalExaggeration)
  : exaggeration(verticalExaggeration)
{
  double cells[6];
  volume->GetBounds(cells);
  const double* spacing = volume->GetSpacing();
  if (information.IsGeographic())
  {
    centre = {(cells[0] + cells[1]) / 2.0, (cells[2] + cells[3]) / 2.0};
    // Equirectangular, on a sphere: that only has to look right.
    constexpr double degree = MetresPerDegree / 1000.0;
    kilometres = {degree * std::cos(centre[1] * RadiansPerDegree), degree};
    map.emplace();
    map->axes = GridAxes::Geographic;
  }
  else if (const auto latitude = Parameter(information.projection, "lat_0"))
  {
    map.emplace();
    map->centreLatitude = *latitude;
    map->centreLongitude = Parameter(information.projection, "lon_0").value_or(0.0);
  }
  const std::array<double, 3> scale = {kilometres[0], kilometres[1], exaggeration / 1000.0};
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = axis < 2 ? centre[axis] : 0.0;
    bounds[2 * axis] = (cells[2 * axis] - spacing[axis] / 2.0 - middle) * scale[axis];
    bounds[2 * axis + 1] = (cells[2 * axis + 1] + spacing[axis] / 2.0 - middle) * scale[axis];
  }
  framed = bounds;
}

std::array<double, 2> SceneFrame::FromVolume(const std::array<double, 2>& point) const
{
  return {(point[0] - centre[0]) * kilometres[0], (point[1] - centre[1]) * kilometres[1]};
}

std::array<double, 2> SceneFrame::Place(double longitude, double latitude) const
{
  return this->FromVolume(map->axes == GridAxes::Geographic
                            ? std::array<double, 2>{longitude, latitude}
                            : map->FromGeographic(longitude, latitude));
}

std::array<double, 2> SceneFrame::Geographic(double x, double y) const
{
  const std::array<double, 3> point = this->ToVolume({x, y, 0.0});
  return map->axes == GridAxes::Geographic ? std::array{point[0], point[1]}
                                           : map->ToGeographic(point[0], point[1]);
}

std::array<double, 3> SceneFrame::ToScene(const std::array<double, 3>& place) const
{
  const auto [x, y] = this->FromVolume({place[0], place[1]});
  return {x, y, this->Height(place[2])};
}

std::array<double, 3> SceneFrame::ToVolume(const std::array<double, 3>& point) const
{
  return {point[0] / kilometres[0] + centre[0], point[1] / kilometres[1] + centre[1],
    1000.0 * point[2] / exaggeration};
}

std::array<double, 3> SceneFrame::PlaceOf(const LookAt& lookAt) const
{
  if (!lookAt.geographic)
  {
    return lookAt.place;
  }
  if (!map)
  {
    throw Error("the volume has no projection: no latitude and longitude of it can be looked at");
  }
  const std::array<double, 2> point = this->Place(lookAt.place[0], lookAt.place[1]);
  return this->ToVolume({point[0], point[1], this->Height(lookAt.place[2])});
}

void SceneFrame::MoveToScene(vtkImageData* volume) const
{
  const double* origin = volume->GetOrigin();
  const double* spacing = volume->GetSpacing();
  const double vertical = exaggeration / 1000.0;
  volume->SetOrigin((origin[0] - centre[0]) * kilometres[0],
    (origin[1] - centre[1]) * kilometres[1], origin[2] * vertical);
  volume->SetSpacing(spacing[0] * kilometres[0], spacing[1] * kilometres[1], spacing[2] * vertical);
}

void SceneFrame::SetFramed(const std::array<double, 6>& box)
{
  const std::array<double, 3> lower = this->ToScene({box[0], box[2], box[4]});
  const std::array<double, 3> upper = this->ToScene({box[1], box[3], box[5]});
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    framed[2 * axis] = std::max(bounds[2 * axis], lower[axis]);
    framed[2 * axis + 1] = std::min(bounds[2 * axis + 1], upper[axis]);
  }
}

std::array<double, 6> SceneFrame::FramedInVolume() const
{
  const auto lower = this->ToVolume({framed[0], framed[2], framed[4]});
  const auto upper = this->ToVolume({framed[1], framed[3], framed[5]});
  return {lower[0], upper[0], lower[1], upper[1], lower[2], upper[2]};
}

bool SceneFrame::Holds(const std::array<double, 6>& box) const
{
  SceneFrame joined = *this;
  joined.SetFramed(box);
  bool within = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    within = within && joined.framed[2 * axis] >= framed[2 * axis] &&
             joined.framed[2 * axis + 1] <= framed[2 * axis + 1];
  }
  return within;
}

double DefaultExaggeration(double width, double height)
{
  constexpr double least = 3.0;
  constexpr double most = 8.0;
  constexpr double widthForEach = 120.0; // km
  constexpr double heightToWidth = 0.75;
  const double ofWidth = std::clamp(width / widthForEach, least, most);
  const double ofHeight = height > 0.0 ? heightToWidth * width / height : least;
  return std::max(1.0, 0.5 * std::floor(2.0 * std::min(ofWidth, ofHeight)));
}

} // namespace nexrad::scene
