// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Scales/HeightWalls.h"

#include "Scene/Scales/ScaleLayer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad::scene
{
namespace
{

// The corner of the ground that is nearest to the camera.
int NearestCorner(const SceneFrame& frame, const CameraView& view)
{
  const auto right = RightOf(view);
  return FarthestCorner(frame.Framed(), {right[1], -right[0]});
}

} // namespace

ScenePoint CornerOfBox(const std::array<double, 6>& box, int index)
{
  return {box[index & 1], box[2 + (index >> 1 & 1)], box[4 + (index >> 2)]};
}

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

std::unique_ptr<LineBuilder> MakeEdges(const SceneFrame& frame, const CameraView& view, bool open)
{
  auto lines = std::make_unique<LineBuilder>();
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
        lines->Add({CornerOfBox(frame.Framed(), corner), CornerOfBox(frame.Framed(), other)});
      }
    }
  }
  return lines;
}

std::unique_ptr<LineBuilder> MakeHeightLines(const SceneFrame& frame, const CameraView& view)
{
  auto lines = std::make_unique<LineBuilder>();
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
      lines->Add(line);
    }
  }
  return lines;
}

} // namespace nexrad::scene
