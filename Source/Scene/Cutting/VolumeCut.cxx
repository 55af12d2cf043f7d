// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Cutting/VolumeCut.h"

#include "nexrad/System/Error.h"

#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkVolumeMapper.h>

#include <algorithm>
#include <cmath>

namespace nexrad::scene
{
namespace
{

template <class Numbers>
bool AreFinite(const Numbers& numbers)
{
  return std::all_of(
    numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

std::array<double, 3> PlaceOf(const SceneFrame& frame, const std::array<double, 3>& point)
{
  const auto [x, y] = frame.FromVolume({point[0], point[1]});
  return {x, y, frame.Height(point[2])};
}

} // namespace

void CheckCut(const CutOptions& cut)
{
  if (cut.box)
  {
    const auto& box = *cut.box;
    if (!AreFinite(box) || !(box[0] < box[1] && box[2] < box[3] && box[4] < box[5]))
    {
      throw Error("the crop box has no inside: its east, north and top must be above its west, "
                  "south and bottom");
    }
  }
  if (cut.plane)
  {
    const auto& normal = cut.plane->normal;
    const bool none = normal == std::array<double, 3>{0.0, 0.0, 0.0};
    if (none || !AreFinite(normal) || !AreFinite(cut.plane->origin))
    {
      throw Error("the clip plane has no direction: its normal must not be 0");
    }
  }
}

void CutVolume(vtkVolumeMapper* mapper, const CutOptions& cut, const SceneFrame& frame)
{
  mapper->SetCropping(cut.box ? 1 : 0);
  if (cut.box)
  {
    const auto& box = *cut.box;
    const std::array<double, 3> low = PlaceOf(frame, {box[0], box[2], box[4]});
    const std::array<double, 3> high = PlaceOf(frame, {box[1], box[3], box[5]});
    mapper->SetCroppingRegionFlagsToSubVolume();
    mapper->SetCroppingRegionPlanes(low[0], high[0], low[1], high[1], low[2], high[2]);
  }
  mapper->RemoveAllClippingPlanes();
  if (cut.plane)
  {
    // A normal is divided by what lengths are multiplied by.
    const std::array<double, 3> origin = PlaceOf(frame, cut.plane->origin);
    const std::array<double, 3> zero = PlaceOf(frame, {0.0, 0.0, 0.0});
    const std::array<double, 3> one = PlaceOf(frame, {1.0, 1.0, 1.0});
    const auto& normal = cut.plane->normal;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.data());
    std::array<double, 3> turned{};
    double length = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      turned[axis] = normal[axis] / (one[axis] - zero[axis]);
      length = std::hypot(length, turned[axis]);
    }
    plane->SetNormal(turned[0] / length, turned[1] / length, turned[2] / length);
    mapper->AddClippingPlane(plane);
  }
}

} // namespace nexrad::scene
