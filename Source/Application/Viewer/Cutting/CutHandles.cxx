// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Cutting/CutHandles.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/SceneOptions.h"

#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkImplicitPlaneRepresentation.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkNexradVolumeScene.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>

#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <array>
#include <cmath>

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

} // namespace

CutHandles::CutHandles(const ShownScene& sceneView, QObject* parent)
  : QObject(parent)
  , view(sceneView)
{
  boxShape->SetPlaceFactor(1.0);
  boxShape->GetFaceProperty()->SetOpacity(0.0);
  boxShape->GetSelectedFaceProperty()->SetOpacity(0.0);
  box->SetRepresentation(boxShape);
  box->RotationEnabledOff();
  box->SetInteractor(view.widget->interactor());
  box->SetDefaultRenderer(view.scene->GetRenderer());
  box->AddObserver(vtkCommand::InteractionEvent, this, &CutHandles::TakeBox);
  box->AddObserver(vtkCommand::EndInteractionEvent, this, &CutHandles::Settled);
  planeShape->SetPlaceFactor(1.0);
  planeShape->OutlineTranslationOff();
  planeShape->ScaleEnabledOff();
  planeShape->GetPlaneProperty()->SetOpacity(0.15);
  planeShape->GetSelectedPlaneProperty()->SetOpacity(0.25);
  plane->SetRepresentation(planeShape);
  plane->SetInteractor(view.widget->interactor());
  plane->SetDefaultRenderer(view.scene->GetRenderer());
  plane->AddObserver(vtkCommand::InteractionEvent, this, &CutHandles::TakePlane);
  plane->AddObserver(vtkCommand::EndInteractionEvent, this, &CutHandles::Settled);
}

CutHandles::~CutHandles() = default;

bool CutHandles::Follow(bool shown)
{
  // Without a cut the scene is not updated here: its first update takes long, and drawing does it.
  const bool any = shown && view.scene->GetVolume() != nullptr && !view.scene->GetOptions().plan &&
                   (view.scene->GetCropping() || view.scene->GetClipping()) && view.scene->Update();
  const std::vector<double> newBox =
    any && view.scene->GetCropping() ? this->BoxPlace() : std::vector<double>{};
  const std::vector<double> newPlane =
    any && view.scene->GetClipping() ? this->PlanePlace() : std::vector<double>{};
  const bool changed = newBox != boxPlace || newPlane != planePlace;
  if (!newBox.empty() && newBox != boxPlace)
  {
    std::array<double, 6> place{};
    std::copy_n(newBox.begin(), 6, place.begin());
    boxShape->PlaceWidget(place.data());
  }
  if (!newPlane.empty() && newPlane != planePlace)
  {
    std::array<double, 6> place{};
    std::copy_n(newPlane.begin() + 6, 6, place.begin());
    planeShape->PlaceWidget(place.data());
    planeShape->SetOrigin(newPlane[0], newPlane[1], newPlane[2]);
    planeShape->SetNormal(newPlane[3], newPlane[4], newPlane[5]);
  }
  box->SetEnabled(newBox.empty() ? 0 : 1);
  plane->SetEnabled(newPlane.empty() ? 0 : 1);
  boxPlace = newBox;
  planePlace = newPlane;
  return changed;
}

std::vector<double> CutHandles::BoxPlace() const
{
  std::array<double, 6> faces{};
  view.scene->GetCropBounds(faces.data());
  const std::array<double, 6> place = ToScene(view.scene, faces);
  return {place.begin(), place.end()};
}

std::vector<double> CutHandles::PlanePlace() const
{
  Point point{};
  view.scene->GetClipOrigin(point.data());
  const Point origin = ToScene(view.scene, point);
  const Point scale = ScaleOf(view.scene);
  const double* normal = view.scene->GetClipNormal();
  const std::array<double, 6> around = ToScene(view.scene, scene::FacesOf(view.scene->GetVolume()));
  std::vector<double> place(origin.begin(), origin.end());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    place.push_back(normal[axis] / scale[axis]);
  }
  place.insert(place.end(), around.begin(), around.end());
  return place;
}

// What the mouse made of the box, at most the whole volume and at least a voxel.
void CutHandles::TakeBox()
{
  vtkNexradVolumeScene* scene = view.scene;
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
  emit Moved();
}

void CutHandles::TakePlane()
{
  vtkNexradVolumeScene* scene = view.scene;
  Point origin{};
  planeShape->GetOrigin(origin.data());
  scene->SetClipOrigin(ToVolume(scene, origin).data());
  const Point scale = ScaleOf(scene);
  const double* seen = planeShape->GetNormal();
  Point normal = {seen[0] * scale[0], seen[1] * scale[1], seen[2] * scale[2]};
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  std::transform(
    normal.begin(), normal.end(), normal.begin(), [length](double part) { return part / length; });
  scene->SetClipNormal(normal.data());
  planePlace.clear();
  emit Moved();
}

} // namespace nexrad::viewer
