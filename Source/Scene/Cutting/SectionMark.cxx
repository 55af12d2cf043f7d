// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Cutting/SectionMark.h"

#include "Scene/Elements/LineBuilder.h"
#include "Scene/Elements/Marker.h"

#include <vtkActor.h>

#include <algorithm>

namespace nexrad::scene
{
namespace
{

constexpr double lineWidth = 2.5; // pixels
constexpr double rimWidth = 5.0;

Label EndLabel(const char* name, const ScenePoint& point, double gap, const TextStyle& style)
{
  Label label;
  label.text = name;
  label.point = point;
  label.style = style;
  label.sides = {LabelSide::Above, LabelSide::Right, LabelSide::Left, LabelSide::Below};
  label.gap = gap;
  return label;
}

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
    layer.labels.push_back(EndLabel(name, point, radius + 0.25 * textSize, style));
  }
  return layer;
}

} // namespace nexrad::scene
