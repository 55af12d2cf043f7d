// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/LabelLayout.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace nexrad::scene
{
namespace
{

double AreaOutside(const PixelBox& box, const std::array<int, 2>& size)
{
  const PixelBox picture = {0.0, 0.0, static_cast<double>(size[0]), static_cast<double>(size[1])};
  return (box.right - box.left) * (box.top - box.bottom) - box.Shared(picture);
}

bool IsInPicture(const std::array<double, 2>& point, const std::array<int, 2>& size)
{
  return point[0] >= 0.0 && point[0] <= size[0] && point[1] >= 0.0 && point[1] <= size[1];
}

// The marker at the point of a label.
PixelBox MarkerOf(const Label& label, const Projection& project)
{
  const auto place = project(label.point);
  const double radius = label.optional ? 0.0 : 0.5 * label.gap;
  return {place[0] - radius, place[1] - radius, place[0] + radius, place[1] + radius};
}

PixelBox Grown(const PixelBox& box, double by)
{
  return {box.left - by, box.bottom - by, box.right + by, box.top + by};
}

double SharedWith(const std::vector<PixelBox>& others, const PixelBox& box)
{
  return std::accumulate(others.begin(), others.end(), 0.0,
    [&](double sum, const PixelBox& other) { return sum + box.Shared(other); });
}

// An optional label keeps its gap from other letters, and so does its dot.
double CoveredBy(const Label& label, const PixelBox& box, const std::array<double, 2>& place,
  const std::vector<PixelBox>& taken)
{
  const PixelBox dot = Grown({place[0], place[1], place[0], place[1]}, label.dot);
  return label.optional ? SharedWith(taken, Grown(box, label.gap)) + SharedWith(taken, dot)
                        : SharedWith(taken, box);
}

// Twice the area of the triangle; its sign is the sense of turn.
double Turn(const std::array<double, 2>& a, const std::array<double, 2>& b, double x, double y)
{
  return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
}

// True when all corners of the box lie on the same side of all edges of the ground.
bool IsOver(const PixelBox& box, const std::array<ScenePoint, 4>& ground, const Projection& project)
{
  bool left = true;
  bool right = true;
  for (std::size_t i = 0; i < ground.size(); ++i)
  {
    const auto from = project(ground[i]);
    const auto to = project(ground[(i + 1) % ground.size()]);
    for (const double x : {box.left, box.right})
    {
      for (const double y : {box.bottom, box.top})
      {
        const double turn = Turn(from, to, x, y);
        left = left && turn >= 0.0;
        right = right && turn <= 0.0;
      }
    }
  }
  return left || right;
}

} // namespace

std::vector<std::optional<LabelSide>> ChooseSides(const std::vector<Label>& labels,
  const std::array<ScenePoint, 4>& ground, const Projection& project, TextPictures& pictures,
  std::vector<PixelBox> taken)
{
  for (const Label& label : labels)
  {
    taken.push_back(MarkerOf(label, project));
  }
  std::vector<PixelBox> apart; // of labels with room about them
  std::vector<std::optional<LabelSide>> chosen;
  for (const Label& label : labels)
  {
    if (label.optional && !IsInPicture(project(label.point), project.Size()))
    {
      chosen.emplace_back();
      continue;
    }
    const TextPicture& picture = pictures.Get(label.text, label.style);
    double least = std::numeric_limits<double>::infinity();
    LabelSide best = label.sides.front();
    for (const LabelSide side : label.sides)
    {
      const PixelBox box = picture.BoxAt(project(label.point), side, label.gap);
      const double covered = AreaOutside(box, project.Size()) +
                             CoveredBy(label, box, project(label.point), taken) +
                             SharedWith(apart, Grown(box, label.room));
      best = covered < least ? side : best;
      least = std::min(least, covered);
    }
    const PixelBox box = picture.BoxAt(project(label.point), best, label.gap);
    if (label.optional && (least > 0.0 || !IsOver(box, ground, project)))
    {
      chosen.emplace_back();
      continue;
    }
    chosen.emplace_back(best);
    taken.push_back(box);
    if (label.room > 0.0)
    {
      apart.push_back(box);
    }
  }
  return chosen;
}

} // namespace nexrad::scene
