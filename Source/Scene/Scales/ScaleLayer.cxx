// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/ScaleLayer.h"

#include "Scene/Elements/LineBuilder.h"
#include "Scene/Elements/SceneText.h"

#include <vtkActor.h>
#include <vtkTextActor.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace nexrad::scene
{
namespace
{

using Props = std::vector<vtkSmartPointer<vtkProp>>;

constexpr Colour frameColour = {0.36, 0.40, 0.45};
constexpr Colour textColour = {0.80, 0.84, 0.88};
constexpr double steepTilt = 70.0; // degrees; above, heights have no length in the picture

std::string Number(double value)
{
  std::ostringstream stream;
  stream << value;
  return stream.str();
}

ScenePoint Corner(const std::array<double, 6>& box, int index)
{
  return {box[index & 1], box[2 + (index >> 1 & 1)], box[4 + (index >> 2)]};
}

// The corner of the ground that lies farthest along a direction.
int FarthestCorner(const std::array<double, 6>& box, const std::array<double, 2>& direction)
{
  int best = 0;
  double farthest = -1e30;
  for (int corner = 0; corner < 4; ++corner)
  {
    const ScenePoint point = Corner(box, corner);
    const double along = point[0] * direction[0] + point[1] * direction[1];
    if (along > farthest)
    {
      farthest = along;
      best = corner;
    }
  }
  return best;
}

void AddFrame(Props& props, const std::array<double, 6>& box)
{
  LineBuilder lines;
  for (int corner = 0; corner < 8; ++corner)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const int other = corner | 1 << axis;
      if (other != corner)
      {
        lines.Add({Corner(box, corner), Corner(box, other)});
      }
    }
  }
  props.push_back(lines.MakeActor(frameColour, 1.0, 0.6));
}

void AddHeights(Props& props, const SceneFrame& frame, const CameraView& view, int textSize)
{
  const auto& box = frame.Bounds();
  const auto right = RightOf(view);
  const ScenePoint foot = Corner(box, FarthestCorner(box, {-right[0], -right[1]}));
  const double bottom = box[4] / frame.Exaggeration(); // km
  const double top = box[5] / frame.Exaggeration();
  const double step = RoundLength((top - bottom) / 3.0);
  const double tick = 0.012 * (box[1] - box[0]);
  LineBuilder ticks;
  for (double height = std::ceil(bottom / step) * step; height <= top + 1e-6; height += step)
  {
    const double z = frame.Height(height * 1000.0);
    const ScenePoint end = {foot[0] - tick * right[0], foot[1] - tick * right[1], z};
    ticks.Add({{foot[0], foot[1], z}, end});
    props.push_back(MakeLabel(Number(height) + (height + step > top + 1e-6 ? " km " : " "), end,
      textSize, textColour, LabelSide::Left));
  }
  props.push_back(ticks.MakeActor(textColour, 1.5));
}

void AddGroundScale(Props& props, const SceneFrame& frame, const CameraView& view, int textSize)
{
  const auto& box = frame.Bounds();
  const auto right = RightOf(view);
  // The ground edge that faces the camera most: its outward normal lies in the plane of view.
  const std::array<double, 2> toCamera = {right[1], -right[0]};
  const bool alongX = std::abs(toCamera[1]) >= std::abs(toCamera[0]);
  const int axis = alongX ? 0 : 1;
  const int across = 1 - axis;
  const double outward = toCamera[across] > 0.0 ? 1.0 : -1.0;
  const double edge = box[2 * across + (outward > 0.0 ? 1 : 0)];
  const double width = box[2 * axis + 1] - box[2 * axis];
  const double length = RoundLength(width / 4.0);
  const double tick = 0.015 * width;
  const double base = edge + outward * 2.0 * tick;
  // The bar starts at the end of the edge that is on the right in the picture.
  const double sign = right[axis] > 0.0 ? 1.0 : -1.0;
  const double start = box[2 * axis + (sign > 0.0 ? 1 : 0)];
  const auto at = [&](double along, double out)
  {
    ScenePoint point{};
    point[axis] = start - sign * along;
    point[across] = base + outward * out;
    point[2] = box[4];
    return point;
  };
  LineBuilder lines;
  lines.Add({at(0.0, -0.5 * tick), at(0.0, 0.5 * tick)});
  lines.Add({at(length, -0.5 * tick), at(length, 0.5 * tick)});
  lines.Add({at(0.0, 0.0), at(length, 0.0)});
  props.push_back(lines.MakeActor(textColour, 1.5));
  props.push_back(MakeLabel(
    Number(length) + " km", at(length / 2.0, 1.2 * tick), textSize, textColour, LabelSide::Below));
}

void AddNorth(Props& props, const SceneFrame& frame, int textSize)
{
  const auto& box = frame.Bounds();
  const double middle = (box[0] + box[1]) / 2.0;
  const double size = 0.015 * (box[1] - box[0]);
  LineBuilder arrow;
  arrow.Add({{middle - size, box[3] + 0.5 * size, box[4]}, {middle, box[3] + 2.5 * size, box[4]},
    {middle + size, box[3] + 0.5 * size, box[4]}});
  props.push_back(arrow.MakeActor(textColour, 1.5));
  props.push_back(MakeLabel("N", {middle + 1.5 * size, box[3] + 2.0 * size, box[4]}, textSize,
    textColour, LabelSide::Right));
}

} // namespace

double RoundLength(double limit)
{
  const double decade = std::pow(10.0, std::floor(std::log10(limit)));
  for (const double factor : {5.0, 2.0})
  {
    if (factor * decade <= limit * (1.0 + 1e-9))
    {
      return factor * decade;
    }
  }
  return decade;
}

Props MakeScaleLayer(const SceneFrame& frame, const CameraView& view, int textSize)
{
  Props props;
  AddFrame(props, frame.Bounds());
  const bool flat = frame.Bounds()[5] <= frame.Bounds()[4];
  if (std::abs(view.tilt) < steepTilt && !flat)
  {
    AddHeights(props, frame, view, textSize);
  }
  AddGroundScale(props, frame, view, textSize);
  AddNorth(props, frame, textSize);
  return props;
}

} // namespace nexrad::scene
