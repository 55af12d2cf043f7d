// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/LabelLayout.h"

#include <algorithm>
#include <limits>

namespace nexrad::scene
{
namespace
{

double AreaOutside(const PixelBox& box, const std::array<int, 2>& size)
{
  const PixelBox picture = {0.0, 0.0, static_cast<double>(size[0]), static_cast<double>(size[1])};
  return (box.right - box.left) * (box.top - box.bottom) - box.Shared(picture);
}

// The marker at the point of a label.
PixelBox MarkerOf(const Label& label, const Projection& project)
{
  const auto place = project(label.point);
  const double radius = 0.6 * label.gap;
  return {place[0] - radius, place[1] - radius, place[0] + radius, place[1] + radius};
}

} // namespace

std::vector<std::optional<LabelSide>> ChooseSides(const std::vector<Label>& labels,
  const Projection& project, TextPictures& pictures, std::vector<PixelBox> taken)
{
  for (const Label& label : labels)
  {
    taken.push_back(MarkerOf(label, project));
  }
  std::vector<std::optional<LabelSide>> chosen;
  for (const Label& label : labels)
  {
    const TextPicture& picture = pictures.Get(label.text, label.style);
    double least = std::numeric_limits<double>::infinity();
    LabelSide best = label.sides.front();
    for (const LabelSide side : label.sides)
    {
      const PixelBox box = picture.BoxAt(project(label.point), side, label.gap);
      double covered = AreaOutside(box, project.Size());
      for (const PixelBox& other : taken)
      {
        covered += box.Shared(other);
      }
      best = covered < least ? side : best;
      least = std::min(least, covered);
    }
    if (label.optional && least > 0.0)
    {
      chosen.emplace_back();
      continue;
    }
    chosen.emplace_back(best);
    taken.push_back(picture.BoxAt(project(label.point), best, label.gap));
  }
  return chosen;
}

} // namespace nexrad::scene
