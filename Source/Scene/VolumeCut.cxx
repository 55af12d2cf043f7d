// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/VolumeCut.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Shapes/Shapes.h"
#include "nexrad/System/Error.h"

#include <vtkActor.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
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

void AddPlane(
  vtkPlaneCollection* planes, const std::array<double, 3>& origin, std::array<double, 3> normal)
{
  vtkMath::Normalize(normal.data());
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.data());
  planes->AddItem(plane);
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

void CheckCutUnit(const CutOptions& cut, vtkImageData* volume)
{
  if (cut.box || cut.plane || cut.section)
  {
    CheckPlaceUnit(cut.unit, PlaceUnitOf(volume), "the crop box, clip plane or section is");
  }
}

vtkSmartPointer<vtkPlaneCollection> CutPlanesOf(const CutOptions& cut, const SceneFrame& frame)
{
  auto planes = vtkSmartPointer<vtkPlaneCollection>::New();
  if (cut.box)
  {
    // Cropping planes would do, but there is one set of them, and a finer volume in place of a part
    // of the volume needs it.
    const auto& box = *cut.box;
    const std::array<double, 3> low = frame.ToScene({box[0], box[2], box[4]});
    const std::array<double, 3> high = frame.ToScene({box[1], box[3], box[5]});
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::array<double, 3> normal{};
      normal[axis] = 1.0;
      AddPlane(planes, low, normal);
      normal[axis] = -1.0;
      AddPlane(planes, high, normal);
    }
  }
  if (cut.plane)
  {
    // A normal is divided by what lengths are multiplied by.
    const std::array<double, 3> zero = frame.ToScene({0.0, 0.0, 0.0});
    const std::array<double, 3> one = frame.ToScene({1.0, 1.0, 1.0});
    std::array<double, 3> normal = cut.plane->normal;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      normal[axis] /= one[axis] - zero[axis];
    }
    AddPlane(planes, frame.ToScene(cut.plane->origin), normal);
  }
  return planes;
}

namespace
{

constexpr double lineWidth = 2.5; // pixels
constexpr double rimWidth = 5.0;

} // namespace

SceneLayer MakeSectionMark(
  const SectionLine& line, const SceneFrame& frame, double height, int textSize, const Theme& theme)
{
  const auto from = frame.FromVolume(line.from);
  const auto to = frame.FromVolume(line.to);
  const ScenePoint a = {from[0], from[1], height};
  const ScenePoint b = {to[0], to[1], height};
  // The rim lies a little lower, so that the two do not fight for the same depth.
  const double drop = 4e-4 * (frame.Framed()[1] - frame.Framed()[0]);
  LineBuilder rim;
  rim.Add({{a[0], a[1], height - drop}, {b[0], b[1], height - drop}});
  LineBuilder middle;
  middle.Add({a, b});
  SceneLayer layer;
  layer.props = {rim.MakeActor(theme.rim, rimWidth), middle.MakeActor(theme.warning, lineWidth)};
  const double radius = std::max(3.0, 0.3 * textSize);
  const TextStyle style = {textSize + textSize / 4, theme.warning, theme.rim, true};
  for (const auto& [name, point] : {std::pair{"A", a}, std::pair{"B", b}})
  {
    layer.props.push_back(MakeMarker(point, radius, theme.warning, theme.rim));
    layer.labels.push_back(
      {name, point, style, {LabelSide::Above, LabelSide::Right, LabelSide::Left, LabelSide::Below},
        radius + 0.25 * textSize});
  }
  return layer;
}

SceneLayer MakeBoxMark(const std::array<double, 4>& faces, const std::optional<Time>& time,
  const SceneFrame& frame, int textSize, const Theme& theme)
{
  constexpr double edgeWidth = 1.5; // pixels
  const auto& [west, east, south, north] = faces;
  const ScenePoint lower = frame.ToScene({west, south, 0.0});
  const ScenePoint upper = frame.ToScene({east, north, 0.0});
  const std::array<double, 6> box = {
    lower[0], upper[0], lower[1], upper[1], frame.Bounds()[4], frame.Bounds()[5]};
  LineBuilder edges;
  for (const int level : {0, 4})
  {
    edges.Add({CornerOfBox(box, level), CornerOfBox(box, level + 1), CornerOfBox(box, level + 3),
      CornerOfBox(box, level + 2), CornerOfBox(box, level)});
  }
  for (const int corner : {0, 2, 1, 3})
  {
    edges.Add({CornerOfBox(box, corner), CornerOfBox(box, corner + 4)});
  }
  SceneLayer layer;
  layer.props = {edges.MakeActor(theme.marker, edgeWidth)};
  if (time)
  {
    constexpr std::size_t day = 11; // letters before the time of day
    constexpr std::size_t ofTime = 8;
    const ScenePoint top = {0.5 * (box[0] + box[1]), box[3], box[5]}; // of the northern face
    layer.labels.push_back(
      {FormatIso8601(*time).substr(day, ofTime) + " UTC", top, {textSize, theme.marker, theme.rim},
        {LabelSide::Above, LabelSide::Right, LabelSide::Left, LabelSide::Below}, 0.5 * textSize});
  }
  return layer;
}

} // namespace nexrad::scene
