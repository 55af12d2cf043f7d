// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/ScaleLayer.h"

#include <vtkActor.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad::scene
{

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

namespace
{

// Index of the corner of the ground that lies farthest along a direction of x and y.
int FarthestCorner(const std::array<double, 6>& box, const std::array<double, 2>& direction)
{
  int best = 0;
  double farthest = std::numeric_limits<double>::lowest();
  for (int corner = 0; corner < 4; ++corner)
  {
    const ScenePoint point = CornerOfBox(box, corner);
    const double along = point[0] * direction[0] + point[1] * direction[1];
    if (along > farthest)
    {
      farthest = along;
      best = corner;
    }
  }
  return best;
}

// The corner of the ground that is nearest to the camera.
int NearestCorner(const SceneFrame& frame, const CameraView& view)
{
  const auto right = RightOf(view);
  return FarthestCorner(frame.Framed(), {right[1], -right[0]});
}

// Round heights in the domain, in km above mean sea level: about three, and the ends where they are
// round.
std::vector<double> RoundHeights(const SceneFrame& frame)
{
  const auto& box = frame.Framed();
  const double bottom = box[4] / frame.Exaggeration(); // km
  const double top = box[5] / frame.Exaggeration();
  // Of a flat frame, numbers at every third of its height would lie on each other.
  constexpr double leastStep = 0.04; // of the frame's width
  const double least =
    leastStep * std::max(box[1] - box[0], box[3] - box[2]) / frame.Exaggeration();
  double step = RoundLength((top - bottom) / 3.0);
  while (step < least && 2.0 * step <= top - bottom)
  {
    step = RoundLength(2.5 * step);
  }
  std::vector<double> heights;
  for (double count = std::ceil(bottom / step); count * step <= top + 1e-6; ++count)
  {
    heights.push_back(count * step);
  }
  return heights;
}

// Edges of the domain: those of the ground, and of the two walls that are far from the camera; all
// where not `open`.
LineBuilder MakeEdges(const SceneFrame& frame, const CameraView& view, bool open)
{
  LineBuilder lines;
  const int nearest = NearestCorner(frame, view);
  for (int corner = 0; corner < 8; ++corner)
  {
    for (const int axis : {1, 2, 4})
    {
      const int other = corner | axis;
      // Above the ground, the edges that end at the nearest corner lie before the echo.
      const bool before = other >= 4 && ((corner & 3) == nearest || (other & 3) == nearest);
      if (other != corner && !(open && before))
      {
        lines.Add({CornerOfBox(frame.Framed(), corner), CornerOfBox(frame.Framed(), other)});
      }
    }
  }
  return lines;
}

// Lines at the round heights on the two far walls.
LineBuilder MakeHeightLines(const SceneFrame& frame, const CameraView& view)
{
  LineBuilder lines;
  const auto& box = frame.Framed();
  const int nearest = NearestCorner(frame, view);
  for (const double height : RoundHeights(frame))
  {
    const double z = frame.Height(height * 1000.0);
    if (z > box[4] && z < box[5])
    {
      // From one end of the walls over the far corner to the other.
      std::vector<ScenePoint> line;
      for (const int corner : {nearest ^ 1, nearest ^ 3, nearest ^ 2})
      {
        line.push_back(CornerOfBox(box, corner));
        line.back()[2] = z;
      }
      lines.Add(line);
    }
  }
  return lines;
}

constexpr double steepTilt = 70.0; // degrees; above, heights have no length in the picture

void AddHeights(
  ScaleLayer& layer, const SceneFrame& frame, const CameraView& view, const TextStyle& style)
{
  const auto& box = frame.Framed();
  const auto right = RightOf(view);
  const ScenePoint foot = CornerOfBox(box, FarthestCorner(box, {-right[0], -right[1]}));
  const double tick = 0.012 * (box[1] - box[0]);
  const std::vector<double> heights = RoundHeights(frame);
  LineBuilder ticks;
  for (const double height : heights)
  {
    const double z = frame.Height(height * 1000.0);
    const ScenePoint end = {foot[0] - tick * right[0], foot[1] - tick * right[1], z};
    ticks.Add({{foot[0], foot[1], z}, end});
    layer.labels.push_back({NumberWord(height) + (height == heights.back() ? " km" : ""), end,
      style, {LabelSide::Left}, 0.3 * style.size});
  }
  layer.props.push_back(ticks.MakeActor(style.colour, 1.5));
}

// The ground edge that faces the camera most, and places before it.
class NearEdge
{
public:
  NearEdge(const SceneFrame& frame, const CameraView& view)
    : box(frame.Framed())
  {
    const auto right = RightOf(view);
    // The edge's outward normal lies in the plane of view.
    const std::array<double, 2> toCamera = {right[1], -right[0]};
    axis = std::abs(toCamera[1]) >= std::abs(toCamera[0]) ? 0 : 1;
    across = 1 - axis;
    outward = toCamera[across] > 0.0 ? 1.0 : -1.0;
    sign = right[axis] > 0.0 ? 1.0 : -1.0;
  }

  double Width() const { return box[2 * axis + 1] - box[2 * axis]; }

  // The place so far along the edge from its end on the right in the picture, and so far before it.
  ScenePoint At(double along, double before) const
  {
    ScenePoint point{};
    point[axis] = box[2 * axis + (sign > 0.0 ? 1 : 0)] - sign * along;
    point[across] = box[2 * across + (outward > 0.0 ? 1 : 0)] + outward * before;
    point[2] = box[4];
    return point;
  }

  bool RunsNorth() const { return axis == 1; }

private:
  std::array<double, 6> box;
  std::size_t axis = 0; // along the edge
  std::size_t across = 1;
  double outward = 1.0; // direction of `across` away from the domain
  double sign = 1.0;    // direction of `axis` to the right in the picture
};

void AddLength(ScaleLayer& layer, const NearEdge& edge, const TextStyle& style)
{
  const double length = RoundLength(edge.Width() / 4.0);
  const double tick = 0.015 * edge.Width();
  const double before = 2.0 * tick;
  LineBuilder lines;
  lines.Add({edge.At(0.0, before - 0.5 * tick), edge.At(0.0, before + 0.5 * tick)});
  lines.Add({edge.At(length, before - 0.5 * tick), edge.At(length, before + 0.5 * tick)});
  lines.Add({edge.At(0.0, before), edge.At(length, before)});
  layer.props.push_back(lines.MakeActor(style.colour, 1.5));
  layer.outline.push_back(edge.At(0.0, before + tick));
  layer.outline.push_back(edge.At(length, before + tick));
  layer.labels.push_back({NumberWord(length) + " km", edge.At(length / 2.0, before + 0.5 * tick),
    style, {LabelSide::Below}, 0.25 * style.size});
}

// An arrow on the ground at the left end of the edge, wholly before it.
void AddNorth(ScaleLayer& layer, const NearEdge& edge, const TextStyle& style)
{
  const double length = 0.055 * edge.Width();
  const double before = edge.RunsNorth() ? 0.5 * length : 0.3 * length;
  ScenePoint tail = edge.At(edge.Width() - 0.4 * length, before);
  if (edge.RunsNorth())
  {
    const ScenePoint end = edge.At(edge.Width() - 1.4 * length, before);
    tail = tail[1] < end[1] ? tail : end;
  }
  else
  {
    const ScenePoint end = edge.At(edge.Width() - 0.4 * length, before + length);
    tail = tail[1] < end[1] ? tail : end;
  }
  const auto at = [&](double east, double north) -> ScenePoint {
    return {tail[0] + east * length, tail[1] + north * length, tail[2]};
  };
  LineBuilder arrow;
  arrow.Add({at(0.0, 0.0), at(0.0, 1.0)});
  arrow.Add({at(-0.25, 0.6), at(0.0, 1.0), at(0.25, 0.6)});
  layer.props.push_back(arrow.MakeActor(style.colour, 1.5));
  layer.outline.push_back(at(0.0, 0.0));
  layer.outline.push_back(at(0.0, 1.0));
  layer.labels.push_back(
    {"N", at(0.0, 0.5), style, {LabelSide::Right, LabelSide::Left}, 0.6 * style.size});
}

} // namespace

ScaleLayer MakeScaleLayer(
  const SceneFrame& frame, const CameraView& view, bool walls, int textSize, const Theme& theme)
{
  const TextStyle style = {textSize, theme.scale, theme.rim};
  ScaleLayer layer;
  for (int corner = 0; corner < 8; ++corner)
  {
    layer.outline.push_back(CornerOfBox(frame.Framed(), corner));
  }
  const bool flat = frame.Framed()[5] <= frame.Framed()[4];
  const bool steep = std::abs(view.tilt) >= steepTilt;
  layer.props.push_back(MakeEdges(frame, view, !steep && !flat).MakeActor(theme.frame, 1.0));
  if (!steep && !flat)
  {
    if (walls)
    {
      layer.props.push_back(MakeHeightLines(frame, view).MakeActor(theme.wall, 1.0));
    }
    AddHeights(layer, frame, view, style);
  }
  const NearEdge edge(frame, view);
  AddLength(layer, edge, style);
  AddNorth(layer, edge, style);
  return layer;
}

} // namespace nexrad::scene
