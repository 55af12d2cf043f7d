// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Cutting/CutPanel.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Viewer/Cutting/CutHandles.h"
#include "Viewer/Cutting/VolumeUnits.h"
#include "Viewer/Parts/FormGroup.h"
#include "Viewer/Parts/NamedWidget.h"
#include "Viewer/Parts/Soon.h"
#include "nexrad/Geometry/Angles.h"

#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace nexrad::viewer
{
namespace
{

constexpr double kilometre = 1000.0;
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

CutPanel::CutPanel(const ShownScene& sceneView, QWidget* parent)
  : QWidget(parent)
  , view(sceneView)
  , handles(new CutHandles(sceneView, this))
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
  connect(handles, &CutHandles::Settled, this, &CutPanel::FollowSoon);
  connect(handles, &CutHandles::Moved, this,
    [this]
    {
      this->FollowBox();
      this->FollowPlane();
      view.drawSoon();
    });
  this->Follow();
}

QCheckBox* CutPanel::MakeSwitch(const QString& name, const QString& tip)
{
  return Named(new QCheckBox(name, this), name, tip);
}

QDoubleSpinBox* CutPanel::MakeNumber(const QString& tip)
{
  auto* box = new QDoubleSpinBox(this);
  box->setObjectName(tip);
  box->setAccessibleName(tip);
  box->setToolTip(tip);
  box->setRange(-2000.0, 2000.0);
  box->setDecimals(1);
  box->setKeyboardTracking(false);
  return box;
}

void CutPanel::AddBox(QFormLayout* form)
{
  crop = this->MakeSwitch("Crop", "Show the part of the volume within the box alone");
  const std::array<const char*, 6> names = {"West", "East", "South", "North", "Bottom", "Top"};
  auto* whole = new QPushButton("Whole volume", this);
  whole->setObjectName("Whole volume");
  whole->setToolTip("Make the box as large as the volume");
  form->addRow(SideBySide(crop, whole));
  for (std::size_t i = 0; i < faces.size(); ++i)
  {
    const QString where = i < 4 ? "km east or north of the centre, or degrees on geographic axes"
                                : "km above mean sea level";
    faces[i] = this->MakeNumber(QString("%1 face of the crop box, %2").arg(names[i]).arg(where));
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
      if (vtkImageData* volume = view.scene->GetVolume())
      {
        view.scene->SetCropBounds(scene::FacesOf(volume).data());
        this->ShowChange();
      }
    });
}

void CutPanel::AddPlane(QFormLayout* form)
{
  clip = this->MakeSwitch("Clip", "Show the part of the volume on one side of the plane alone");
  form->addRow(clip);
  origin = {this->MakeNumber("A point of the clip plane: km east of the centre"),
    this->MakeNumber("A point of the clip plane: km north of the centre"),
    this->MakeNumber("A point of the clip plane: km above mean sea level")};
  form->addRow("East, north", SideBySide(origin[0], origin[1]));
  form->addRow("Height", origin[2]);
  azimuth = this->MakeNumber("Direction to the part that is shown, degrees clockwise from north");
  form->addRow("Shown towards", azimuth);
  azimuth->setRange(0.0, 359.9);
  azimuth->setWrapping(true);
  elevation = this->MakeNumber(
    "Elevation of that direction in degrees, for heights that are not stretched; 0: the plane is "
    "vertical");
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
  vtkNexradVolumeScene* scene = view.scene;
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
  if (vtkImageData* volume = view.scene->GetVolume())
  {
    const std::array<double, 6> whole = scene::FacesOf(volume);
    std::array<double, 3> point{};
    view.scene->GetClipOrigin(point.data());
    bool inside = true;
    for (std::size_t i = 0; i < point.size(); ++i)
    {
      inside = inside && point[i] >= whole[2 * i] && point[i] <= whole[2 * i + 1];
    }
    for (std::size_t i = 0; i < point.size() && !inside; ++i)
    {
      point[i] = 0.5 * (whole[2 * i] + whole[2 * i + 1]);
    }
    view.scene->SetClipOrigin(point.data());
  }
  view.scene->SetClipping(on);
  this->ShowChange();
}

void CutPanel::TakeBox()
{
  const double unit = HorizontalUnitOf(view.scene->GetVolume()).size;
  std::array<double, 6> box{};
  for (std::size_t i = 0; i < box.size(); ++i)
  {
    box[i] = (i < 4 ? unit : kilometre) * faces[i]->value();
  }
  view.scene->SetCropBounds(box.data());
  this->ShowChange();
}

void CutPanel::TakePlane()
{
  vtkNexradVolumeScene* scene = view.scene;
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
  view.drawSoon();
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
    view.drawSoon();
  }
}

void CutPanel::FollowBox()
{
  vtkNexradVolumeScene* scene = view.scene;
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
  vtkNexradVolumeScene* scene = view.scene;
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
