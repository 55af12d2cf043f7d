// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/CutPanel.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/SceneOptions.h"
#include "Viewer/SceneView.h"
#include "Viewer/Widgets.h"
#include "nexrad/Geometry/Angles.h"

#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkImplicitPlaneRepresentation.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkNew.h>
#include <vtkNexradVolumeScene.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace nexrad::viewer
{
namespace
{

using Point = std::array<double, 3>;

Point ToScene(vtkNexradVolumeScene* scene, const Point& point)
{
  Point found{};
  scene->VolumeToScene(point.data(), found.data());
  return found;
}

Point ToVolume(vtkNexradVolumeScene* scene, const Point& point)
{
  Point found{};
  scene->SceneToVolume(point.data(), found.data());
  return found;
}

// Scene units of one unit of the volume along each axis.
Point ScaleOf(vtkNexradVolumeScene* scene)
{
  const Point zero = ToScene(scene, {0.0, 0.0, 0.0});
  const Point one = ToScene(scene, {1.0, 1.0, 1.0});
  return {one[0] - zero[0], one[1] - zero[1], one[2] - zero[2]};
}

std::array<double, 6> ToScene(vtkNexradVolumeScene* scene, const std::array<double, 6>& box)
{
  const Point low = ToScene(scene, Point{box[0], box[2], box[4]});
  const Point high = ToScene(scene, Point{box[1], box[3], box[5]});
  return {low[0], high[0], low[1], high[1], low[2], high[2]};
}

constexpr double thinnest = 0.1; // of the box, in the unit of its numbers
constexpr double farOff = 9e6;   // m: only a face that was never set is so far away

QWidget* SideBySide(QWidget* first, QWidget* second)
{
  auto* both = new QWidget;
  auto* row = new QHBoxLayout(both);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(first, 1);
  row->addWidget(second, 1);
  return both;
}

// A face that was never set becomes that of the frame.
std::array<double, 6> BoxOf(vtkNexradVolumeScene* scene)
{
  std::array<double, 6> box{};
  scene->GetCropBounds(box.data());
  std::array<double, 6> first = scene::FacesOf(scene->GetVolume());
  scene->GetFrameBounds(first.data());
  std::transform(box.begin(), box.end(), first.begin(), box.begin(),
    [](double face, double framed) { return std::abs(face) > farOff ? framed : face; });
  return box;
}

void Show(QDoubleSpinBox* box, double value)
{
  const QSignalBlocker quiet(box);
  box->setValue(value);
}

} // namespace

/// The crop box and the clip plane in the scene, with handles for the mouse: the balls move faces
/// of the box, the plane is moved along its arrow and turned by it.
class CutHandles
{
public:
  /// `view` must outlive it. `moved`: the mouse changed the box or the plane of the scene;
  /// `settled`: it let go of them.
  CutHandles(
    SceneView& sceneView, std::function<void()> whenMoved, std::function<void()> whenSettled)
    : view(sceneView)
    , moved(std::move(whenMoved))
    , settled(std::move(whenSettled))
  {
    boxShape->SetPlaceFactor(1.0);
    boxShape->GetFaceProperty()->SetOpacity(0.0);
    boxShape->GetSelectedFaceProperty()->SetOpacity(0.0);
    box->SetRepresentation(boxShape);
    box->RotationEnabledOff();
    box->SetInteractor(view.interactor());
    box->SetDefaultRenderer(view.Scene()->GetRenderer());
    box->AddObserver(vtkCommand::InteractionEvent, this, &CutHandles::TakeBox);
    box->AddObserver(vtkCommand::EndInteractionEvent, this, &CutHandles::Settle);
    planeShape->SetPlaceFactor(1.0);
    planeShape->OutlineTranslationOff();
    planeShape->ScaleEnabledOff();
    planeShape->GetPlaneProperty()->SetOpacity(0.15);
    planeShape->GetSelectedPlaneProperty()->SetOpacity(0.25);
    plane->SetRepresentation(planeShape);
    plane->SetInteractor(view.interactor());
    plane->SetDefaultRenderer(view.Scene()->GetRenderer());
    plane->AddObserver(vtkCommand::InteractionEvent, this, &CutHandles::TakePlane);
    plane->AddObserver(vtkCommand::EndInteractionEvent, this, &CutHandles::Settle);
  }

  CutHandles(const CutHandles&) = delete;
  CutHandles& operator=(const CutHandles&) = delete;

  /// Shows the handles of what the scene cuts, or none, where the scene has its box and its plane.
  /// True when they changed, so that the scene must be drawn.
  bool Follow(bool shown)
  {
    // Without a cut the scene is not updated here: its first update takes long, and drawing does
    // it.
    const bool any =
      shown && view.Scene()->GetVolume() != nullptr && !view.Scene()->GetOptions().plan &&
      (view.Scene()->GetCropping() || view.Scene()->GetClipping()) && view.Scene()->Update();
    std::vector<double> newBox =
      any && view.Scene()->GetCropping() ? this->BoxPlace() : std::vector<double>{};
    std::vector<double> newPlane =
      any && view.Scene()->GetClipping() ? this->PlanePlace() : std::vector<double>{};
    const bool changed = newBox != boxPlace || newPlane != planePlace;
    if (!newBox.empty() && newBox != boxPlace)
    {
      boxShape->PlaceWidget(newBox.data());
    }
    if (!newPlane.empty() && newPlane != planePlace)
    {
      planeShape->PlaceWidget(newPlane.data() + 6);
      planeShape->SetOrigin(newPlane[0], newPlane[1], newPlane[2]);
      planeShape->SetNormal(newPlane[3], newPlane[4], newPlane[5]);
    }
    box->SetEnabled(newBox.empty() ? 0 : 1);
    plane->SetEnabled(newPlane.empty() ? 0 : 1);
    boxPlace = newBox;
    planePlace = newPlane;
    return changed;
  }

private:
  /// Where the handles are to be in the scene: the box, or the plane's origin and normal with the
  /// box about it; empty: not shown.
  std::vector<double> BoxPlace() const
  {
    std::array<double, 6> faces{};
    view.Scene()->GetCropBounds(faces.data());
    const std::array<double, 6> place = ToScene(view.Scene(), faces);
    return {place.begin(), place.end()};
  }

  std::vector<double> PlanePlace() const
  {
    Point point{};
    view.Scene()->GetClipOrigin(point.data());
    const Point origin = ToScene(view.Scene(), point);
    const Point scale = ScaleOf(view.Scene());
    const double* normal = view.Scene()->GetClipNormal();
    const std::array<double, 6> around =
      ToScene(view.Scene(), scene::FacesOf(view.Scene()->GetVolume()));
    std::vector<double> place(origin.begin(), origin.end());
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      place.push_back(normal[axis] / scale[axis]);
    }
    place.insert(place.end(), around.begin(), around.end());
    return place;
  }

  // What the mouse made of the box, at most the whole volume and at least a voxel.
  void TakeBox()
  {
    vtkNexradVolumeScene* scene = view.Scene();
    const double* seen = boxShape->GetBounds();
    const Point low = ToVolume(scene, {seen[0], seen[2], seen[4]});
    const Point high = ToVolume(scene, {seen[1], seen[3], seen[5]});
    const std::array<double, 6> faces = scene::FacesOf(scene->GetVolume());
    std::array<double, 6> taken{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double voxel = scene->GetVolume()->GetSpacing()[axis];
      const double first = faces[2 * axis];
      const double last = faces[2 * axis + 1];
      taken[2 * axis] = std::clamp(low[axis], first, last - voxel);
      taken[2 * axis + 1] = std::clamp(high[axis], taken[2 * axis] + voxel, last);
    }
    scene->SetCropBounds(taken.data());
    boxPlace.clear();
    moved();
  }

  void TakePlane()
  {
    vtkNexradVolumeScene* scene = view.Scene();
    Point origin{};
    planeShape->GetOrigin(origin.data());
    scene->SetClipOrigin(ToVolume(scene, origin).data());
    const Point scale = ScaleOf(scene);
    const double* seen = planeShape->GetNormal();
    Point normal = {seen[0] * scale[0], seen[1] * scale[1], seen[2] * scale[2]};
    const double length = std::hypot(normal[0], normal[1], normal[2]);
    std::transform(normal.begin(), normal.end(), normal.begin(),
      [length](double part) { return part / length; });
    scene->SetClipNormal(normal.data());
    planePlace.clear();
    moved();
  }

  void Settle() { settled(); }

  SceneView& view;
  std::function<void()> moved;
  std::function<void()> settled;
  vtkNew<vtkBoxWidget2> box;
  vtkNew<vtkBoxRepresentation> boxShape;
  vtkNew<vtkImplicitPlaneWidget2> plane;
  vtkNew<vtkImplicitPlaneRepresentation> planeShape;
  std::vector<double> boxPlace;   ///< that is shown
  std::vector<double> planePlace; ///< that is shown
};

CutPanel::CutPanel(SceneView& sceneView, QWidget* parent)
  : QWidget(parent)
  , view(sceneView)
  , handles(std::make_unique<CutHandles>(
      sceneView,
      [this]
      {
        this->FollowBox();
        this->FollowPlane();
        view.DrawSoon();
      },
      [this] { this->FollowSoon(); }))
  , follow(new Soon(this, [this] { this->Follow(); }))
{
  this->setObjectName("cut panel");
  auto* column = new QVBoxLayout(this);
  this->AddBox(AddGroup(column, "Crop box"));
  this->AddPlane(AddGroup(column, "Clip plane"));
  shown = Named(new QCheckBox("Handles", this), "Handles",
    "Handles in the scene: drag a ball of the box, or the plane or its arrow");
  shown->setChecked(true);
  column->addWidget(shown);
  column->addStretch(1);
  connect(shown, &QCheckBox::clicked, this, &CutPanel::ShowChange);
  this->Follow();
}

CutPanel::~CutPanel() = default;

void CutPanel::AddBox(QFormLayout* form)
{
  crop =
    Named(new QCheckBox("Crop", this), "Crop", "Show the part of the volume within the box alone");
  const std::array<const char*, 6> names = {"West", "East", "South", "North", "Bottom", "Top"};
  auto* whole = new QPushButton("Whole volume", this);
  whole->setObjectName("Whole volume");
  whole->setToolTip("Make the box as large as the volume");
  form->addRow(SideBySide(crop, whole));
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const QString where = i < 4 ? "km east or north of the centre, or degrees on geographic axes"
                                : "km above mean sea level";
    faces[i] =
      MakeCoordinate(QString("%1 face of the crop box, %2").arg(names[i]).arg(where), this);
    connect(faces[i], qOverload<double>(&QDoubleSpinBox::valueChanged), this, &CutPanel::TakeBox);
  }
  // In pairs, so that the page is no higher than a small screen.
  form->addRow("West, east", SideBySide(faces[0], faces[1]));
  form->addRow("South, north", SideBySide(faces[2], faces[3]));
  form->addRow("Bottom, top", SideBySide(faces[4], faces[5]));
  connect(crop, &QCheckBox::clicked, this, &CutPanel::SwitchCrop);
  connect(whole, &QPushButton::clicked, this,
    [this]
    {
      if (vtkImageData* volume = view.Scene()->GetVolume())
      {
        view.Scene()->SetCropBounds(scene::FacesOf(volume).data());
        this->ShowChange();
      }
    });
}

void CutPanel::AddPlane(QFormLayout* form)
{
  clip = Named(new QCheckBox("Clip", this), "Clip",
    "Show the part of the volume on one side of the plane alone");
  form->addRow(clip);
  origin = {MakeCoordinate("A point of the clip plane: km east of the centre", this),
    MakeCoordinate("A point of the clip plane: km north of the centre", this),
    MakeCoordinate("A point of the clip plane: km above mean sea level", this)};
  form->addRow("East, north", SideBySide(origin[0], origin[1]));
  form->addRow("Height", origin[2]);
  azimuth =
    MakeCoordinate("Direction to the part that is shown, degrees clockwise from north", this);
  form->addRow("Shown towards", azimuth);
  azimuth->setRange(0.0, 359.9);
  azimuth->setWrapping(true);
  elevation = MakeCoordinate(
    "Elevation of that direction in degrees, for heights that are not stretched; 0: the plane is "
    "vertical",
    this);
  form->addRow("and upwards", elevation);
  elevation->setRange(-90.0, 90.0);
  for (QDoubleSpinBox* box : {origin[0], origin[1], origin[2], azimuth, elevation})
  {
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &CutPanel::TakePlane);
  }
  azimuth->setSuffix("°");
  elevation->setSuffix("°");
  connect(clip, &QCheckBox::clicked, this, &CutPanel::SwitchClip);
}

// A box beside the volume becomes as large as it.
void CutPanel::SwitchCrop(bool on)
{
  vtkNexradVolumeScene* scene = view.Scene();
  if (vtkImageData* volume = scene->GetVolume())
  {
    std::array<double, 6> box = BoxOf(scene);
    const std::array<double, 6> whole = scene::FacesOf(volume);
    for (std::size_t i = 0; i < box.size(); i += 2)
    {
      const bool apart = box[i] >= whole[i + 1] || box[i + 1] <= whole[i];
      box[i] = apart ? whole[i] : std::max(box[i], whole[i]);
      box[i + 1] = apart ? whole[i + 1] : std::min(box[i + 1], whole[i + 1]);
    }
    scene->SetCropBounds(box.data());
  }
  scene->SetCropping(on);
  this->ShowChange();
}

// A plane that does not cross the volume is moved into its middle.
void CutPanel::SwitchClip(bool on)
{
  if (vtkImageData* volume = view.Scene()->GetVolume())
  {
    const std::array<double, 6> whole = scene::FacesOf(volume);
    std::array<double, 3> point{};
    view.Scene()->GetClipOrigin(point.data());
    bool inside = true;
    for (std::size_t i = 0; i < point.size(); ++i)
    {
      inside = inside && point[i] >= whole[2 * i] && point[i] <= whole[2 * i + 1];
    }
    for (std::size_t i = 0; i < point.size() && !inside; ++i)
    {
      point[i] = 0.5 * (whole[2 * i] + whole[2 * i + 1]);
    }
    view.Scene()->SetClipOrigin(point.data());
  }
  view.Scene()->SetClipping(on);
  this->ShowChange();
}

void CutPanel::TakeBox()
{
  const double unit = HorizontalUnitOf(view.Scene()->GetVolume()).size;
  std::array<double, 6> box{};
  for (std::size_t i = 0; i < box.size(); ++i)
  {
    box[i] = (i < 4 ? unit : kilometre) * faces[i]->value();
  }
  view.Scene()->SetCropBounds(box.data());
  this->ShowChange();
}

void CutPanel::TakePlane()
{
  vtkNexradVolumeScene* scene = view.Scene();
  const HorizontalUnit unit = HorizontalUnitOf(scene->GetVolume());
  scene->SetClipOrigin(
    unit.size * origin[0]->value(), unit.size * origin[1]->value(), kilometre * origin[2]->value());
  const double towards = RadiansPerDegree * azimuth->value();
  const double upwards = RadiansPerDegree * elevation->value();
  scene->SetClipNormal(std::sin(towards) * std::cos(upwards), std::cos(towards) * std::cos(upwards),
    std::sin(upwards) / unit.metres);
  this->ShowChange();
}

void CutPanel::ShowChange()
{
  view.DrawSoon();
  this->FollowSoon();
}

void CutPanel::FollowSoon()
{
  follow->Ask();
}

void CutPanel::Follow()
{
  this->FollowBox();
  this->FollowPlane();
  if (handles->Follow(shown->isChecked()))
  {
    view.DrawSoon();
  }
}

void CutPanel::FollowBox()
{
  vtkNexradVolumeScene* scene = view.Scene();
  vtkImageData* volume = scene->GetVolume();
  const HorizontalUnit unit = HorizontalUnitOf(volume);
  std::array<double, 6> box{};
  scene->GetCropBounds(box.data());
  if (volume != nullptr && !scene->GetCropping())
  {
    box = BoxOf(scene);
  }
  crop->setChecked(scene->GetCropping());
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const double size = i < 4 ? unit.size : kilometre;
    const double other = box[i ^ 1U] / size;
    const QSignalBlocker quiet(faces[i]);
    faces[i]->setDecimals(i < 4 ? unit.decimals : 1);
    faces[i]->setRange(i % 2 == 0 ? -20'000.0 : other + thinnest,
      i % 2 == 0 ? other - thinnest : 20'000.0); // so that the box has an inside
    faces[i]->setSuffix(i < 4 ? unit.suffix : " km");
    faces[i]->setValue(box[i] / size);
    faces[i]->setEnabled(scene->GetCropping() && volume != nullptr);
  }
}

void CutPanel::FollowPlane()
{
  vtkNexradVolumeScene* scene = view.Scene();
  const HorizontalUnit unit = HorizontalUnitOf(scene->GetVolume());
  clip->setChecked(scene->GetClipping());
  const double* point = scene->GetClipOrigin();
  for (std::size_t i = 0; i < origin.size(); ++i)
  {
    const QSignalBlocker quiet(origin[i]);
    origin[i]->setDecimals(i < 2 ? unit.decimals : 1);
    origin[i]->setSuffix(i < 2 ? unit.suffix : " km");
    Show(origin[i], point[i] / (i < 2 ? unit.size : kilometre));
  }
  const double* normal = scene->GetClipNormal();
  const double flat = std::hypot(normal[0], normal[1]);
  if (flat > 0.0) // a vertical direction has no azimuth: the number stays
  {
    const double towards = std::atan2(normal[0], normal[1]) / RadiansPerDegree;
    Show(azimuth, std::fmod(towards + 360.0, 360.0));
  }
  Show(elevation, std::atan2(normal[2] * unit.metres, flat) / RadiansPerDegree);
  for (QDoubleSpinBox* box : {origin[0], origin[1], origin[2], azimuth, elevation})
  {
    box->setEnabled(scene->GetClipping() && scene->GetVolume() != nullptr);
  }
}

} // namespace nexrad::viewer
