// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/PictureLayout.h"

#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace nexrad::scene
{
namespace
{

constexpr double margin = 0.03;    // between the scene and the picture's edges, of its height
constexpr double pad = 4.0;        // pixels between words and the picture's edges
constexpr double steepTilt = 70.0; // degrees; the scene is a map, or nearly

// The area of the picture in pixels.
PictureArea AreaOf(const PixelBox& box, const std::array<int, 2>& size)
{
  return {2.0 * box.left / size[0] - 1.0, 2.0 * box.right / size[0] - 1.0,
    2.0 * box.bottom / size[1] - 1.0, 2.0 * box.top / size[1] - 1.0};
}

double AspectOf(const std::array<int, 2>& size)
{
  return static_cast<double>(size[0]) / size[1];
}

class Framing
{
public:
  Framing(vtkCamera* pointed, const CameraView& wanted, const FramedScene& shown,
    const FrameSpace& given, TextPictures& textPictures)
    : camera(pointed)
    , view(wanted)
    , scene(shown)
    , space(given)
    , pictures(textPictures)
  {
  }

  // The whole picture but for margins and the colour bar.
  PixelBox Whole() const
  {
    const double gap = margin * space.size[1];
    return {gap, gap, space.right - gap, space.size[1] - gap};
  }

  // Between the captions above and below.
  PixelBox BetweenCaptions() const
  {
    PixelBox box = this->Whole();
    for (const PixelBox& caption : space.taken)
    {
      if (caption.bottom + caption.top > space.size[1])
      {
        box.top = std::min(box.top, caption.bottom - margin * space.size[1]);
      }
      else
      {
        box.bottom = std::max(box.bottom, caption.top + margin * space.size[1]);
      }
    }
    return box;
  }

  // To the right of the captions above.
  PixelBox BesideCaptions() const
  {
    PixelBox box = this->BetweenCaptions();
    box.top = this->Whole().top;
    for (const PixelBox& caption : space.taken)
    {
      if (caption.bottom + caption.top > space.size[1])
      {
        box.left = std::max(box.left, caption.right + margin * space.size[1]);
      }
    }
    return box;
  }

  // Room for the words left of and below the scene.
  void LeaveRoomForWords(PixelBox& box) const
  {
    double left = 0.0;
    double below = 0.0;
    for (const Label& label : scene.labels)
    {
      const auto& size = pictures.Get(label.text, label.style).Size();
      left = label.sides.front() == LabelSide::Left ? std::max<double>(left, size[0]) : left;
      below = label.sides.front() == LabelSide::Below ? std::max<double>(below, size[1]) : below;
    }
    box.left += left;
    box.bottom += below;
  }

  // Moves one edge of the box outwards as far as the picture allows.
  void Grow(PixelBox& box, double PixelBox::*edge, double outermost) const
  {
    const double least = box.*edge;
    double good = 0.0;
    double bad = 1.0;
    for (int i = 0; i < 10; ++i)
    {
      const double share = i == 0 ? 1.0 : (good + bad) / 2.0;
      box.*edge = least + share * (outermost - least);
      (this->IsFree(box) ? good : bad) = share;
      if (good == 1.0)
      {
        break;
      }
    }
    box.*edge = least + good * (outermost - least);
  }

  // As large as the picture allows, from that box on.
  PixelBox Largest(PixelBox box) const
  {
    const PixelBox whole = this->Whole();
    this->LeaveRoomForWords(box);
    this->Grow(box, &PixelBox::top, whole.top);
    this->Grow(box, &PixelBox::bottom, whole.bottom);
    this->Grow(box, &PixelBox::left, whole.left);
    return box;
  }

  // How large the scene becomes in a box; 0 where it does not fit.
  double SizeIn(const PixelBox& box) const
  {
    const bool fits = box.left < box.right && box.bottom < box.top && this->IsFree(box);
    return fits ? 1.0 / camera->GetParallelScale() : 0.0; // which holds for both projections
  }

  void Point(const PixelBox& box, double zoom) const
  {
    CameraView pointed = view;
    pointed.zoom = zoom;
    PointCamera(camera, pointed, scene.outline, AspectOf(space.size), AreaOf(box, space.size));
  }

private:
  // True when a scene that fills the box touches no caption, and its words neither touch one nor
  // leave the picture.
  bool IsFree(const PixelBox& box) const
  {
    this->Point(box, 1.0);
    const Projection project(camera, space.size);
    std::vector<std::array<double, 2>> places;
    for (const ScenePoint& point : scene.outline)
    {
      places.push_back(project(point));
    }
    return std::none_of(space.taken.begin(), space.taken.end(),
             [&](const PixelBox& caption) { return Crosses(places, caption); }) &&
           std::all_of(scene.labels.begin(), scene.labels.end(),
             [&](const Label& label) { return this->IsFree(label, project); });
  }

  bool IsFree(const Label& label, const Projection& project) const
  {
    const PixelBox box = pictures.Get(label.text, label.style)
                           .BoxAt(project(label.point), label.sides.front(), label.gap);
    const PixelBox whole = {pad, pad, space.right, space.size[1] - pad};
    return box.left >= whole.left && box.bottom >= whole.bottom && box.right <= whole.right &&
           box.top <= whole.top &&
           std::none_of(space.taken.begin(), space.taken.end(),
             [&](const PixelBox& caption) { return caption.Shared(box) > 0.0; });
  }

  // True when a line between two of the points crosses the rectangle, or nearly does. The points
  // are the corners of a body, so that nothing of it lies beyond these lines.
  bool Crosses(const std::vector<std::array<double, 2>>& points, const PixelBox& box) const
  {
    const double gap = margin * space.size[1];
    const std::array<double, 4> rectangle = {
      box.left - gap, box.right + gap, box.bottom - gap, box.top + gap};
    double enters = 0.0;
    double leaves = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      for (std::size_t j = i + 1; j < points.size(); ++j)
      {
        if (ClipToRectangle(points[i], points[j], rectangle, enters, leaves))
        {
          return true;
        }
      }
    }
    return false;
  }

  vtkCamera* camera;
  const CameraView& view;
  const FramedScene& scene;
  const FrameSpace& space;
  TextPictures& pictures;
};

} // namespace

Projection::Projection(vtkCamera* camera, const std::array<int, 2>& pictureSize)
  : size(pictureSize)
{
  const vtkMatrix4x4* projection =
    camera->GetCompositeProjectionTransformMatrix(AspectOf(size), -1.0, 1.0);
  std::copy_n(projection->GetData(), matrix.size(), matrix.begin());
}

std::array<double, 2> Projection::operator()(const ScenePoint& point) const
{
  const double from[4] = {point[0], point[1], point[2], 1.0};
  double to[4];
  vtkMatrix4x4::MultiplyPoint(matrix.data(), from, to);
  if (to[3] <= 0.0)
  {
    return {-1e6, -1e6};
  }
  return {(to[0] / to[3] + 1.0) / 2.0 * size[0], (to[1] / to[3] + 1.0) / 2.0 * size[1]};
}

void FrameScene(vtkCamera* camera, const CameraView& view, const FramedScene& scene,
  const FrameSpace& space, TextPictures& pictures)
{
  const Framing framing(camera, view, scene, space, pictures);
  PixelBox box = framing.Largest(framing.BetweenCaptions());
  // A scene that turns does not jump from one to the other.
  if (std::abs(view.tilt) >= steepTilt)
  {
    const PixelBox other = framing.Largest(framing.BesideCaptions());
    box = framing.SizeIn(other) > framing.SizeIn(box) ? other : box;
  }
  framing.Point(box, view.zoom);
}

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
