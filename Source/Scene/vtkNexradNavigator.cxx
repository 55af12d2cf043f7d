// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradNavigator.h"

#include "Scene/EchoSearch.h"
#include "Scene/Frame/CameraView.h"
#include "Scene/Frame/SceneFrame.h"
#include "vtkNexradEchoPicker.h"
#include "vtkNexradVolumeScene.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>

using nexrad::scene::DepthBefore;
using nexrad::scene::ScenePoint;
using nexrad::scene::ViewRay;

namespace
{

constexpr double leastZoom = 0.1;
constexpr double mostZoom = 100.0;

// The point so far before the camera that a ray passes.
ScenePoint AtDepth(vtkCamera* camera, const ViewRay& ray, double depth)
{
  double forward[3];
  camera->GetDirectionOfProjection(forward);
  const double first = DepthBefore(camera, ray.origin.data());
  return ray.At((depth - first) / vtkMath::Dot(ray.direction.data(), forward));
}

// The scene is up to date, and shows a volume.
ViewRay RayAt(vtkRenderer* renderer, double x, double y)
{
  const int* size = renderer->GetSize();
  return nexrad::scene::RayThrough(renderer->GetActiveCamera(), {size[0], size[1]}, {x, y});
}

} // namespace

vtkStandardNewMacro(vtkNexradNavigator);

vtkNexradNavigator::vtkNexradNavigator() = default;
vtkNexradNavigator::~vtkNexradNavigator() = default;

void vtkNexradNavigator::SetScene(vtkNexradVolumeScene* scene)
{
  if (scene != this->Scene)
  {
    this->Scene = scene;
    this->Picker->SetScene(scene);
    this->Moved = false;
    this->Modified();
  }
}

vtkNexradVolumeScene* vtkNexradNavigator::GetScene() const
{
  return this->Scene;
}

// The camera is that of the settings, there is something to look at, and the picture has a size.
bool vtkNexradNavigator::IsReady()
{
  if (!this->Scene || this->Scene->GetVolume() == nullptr || !this->Scene->Update())
  {
    return false;
  }
  const int* size = this->Scene->GetRenderer()->GetSize();
  return size[0] > 0 && size[1] > 0;
}

void vtkNexradNavigator::FindPoint(double x, double y, double point[3])
{
  vtkRenderer* renderer = this->Scene->GetRenderer();
  if (this->Picker->Pick(x, y, 0.0, renderer) != vtkNexradEchoPicker::NOTHING)
  {
    this->Picker->GetPickPosition(point);
    return;
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  const std::array<double, 6> box = this->Scene->GetSceneFrame()->Framed();
  const double middle[3] = {
    (box[0] + box[1]) / 2.0, (box[2] + box[3]) / 2.0, (box[4] + box[5]) / 2.0};
  const ScenePoint found = AtDepth(camera, RayAt(renderer, x, y), DepthBefore(camera, middle));
  std::copy(found.begin(), found.end(), point);
}

// Moves the camera sideways until a point of the scene is at that place of the picture.
void vtkNexradNavigator::KeepAt(const double point[3], double x, double y)
{
  this->Scene->Update();
  vtkRenderer* renderer = this->Scene->GetRenderer();
  vtkCamera* camera = renderer->GetActiveCamera();
  const ScenePoint there = AtDepth(camera, RayAt(renderer, x, y), DepthBefore(camera, point));
  ScenePoint middle{};
  camera->GetFocalPoint(middle.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] += point[axis] - there[axis];
  }
  const std::array<double, 3> place = this->Scene->GetSceneFrame()->ToVolume(middle);
  this->Scene->SetLookAt(place[0], place[1], place[2]);
  this->Moved = true;
}

void vtkNexradNavigator::SetZoom(double zoom)
{
  this->Scene->SetZoom(std::clamp(zoom, leastZoom, mostZoom));
}

void vtkNexradNavigator::Grab(double x, double y)
{
  if (this->IsReady())
  {
    this->FindPoint(x, y, this->Grabbed);
  }
}

void vtkNexradNavigator::Pan(double x, double y)
{
  if (this->IsReady())
  {
    this->KeepAt(this->Grabbed, x, y);
  }
}

void vtkNexradNavigator::ZoomAt(double x, double y, double factor)
{
  if (this->IsReady())
  {
    double point[3];
    this->FindPoint(x, y, point);
    this->SetZoom(this->Scene->GetZoom() * factor);
    this->KeepAt(point, x, y);
  }
}

void vtkNexradNavigator::Zoom(double factor)
{
  if (this->Scene)
  {
    this->SetZoom(this->Scene->GetZoom() * factor);
  }
}

int vtkNexradNavigator::CentreOn(double x, double y)
{
  if (!this->IsReady())
  {
    return vtkNexradEchoPicker::NOTHING;
  }
  const int found = this->Picker->Pick(x, y, 0.0, this->Scene->GetRenderer());
  if (found != vtkNexradEchoPicker::NOTHING)
  {
    const double* place = this->Picker->GetPlace();
    this->Scene->SetLookAt(place[0], place[1], place[2]);
    this->Moved = false;
  }
  return found;
}

// Changes the magnification until the picture shows so much at the distance of a point.
void vtkNexradNavigator::SetSizeAt(const double point[3], double size)
{
  vtkCamera* camera = this->Scene->GetRenderer()->GetActiveCamera();
  const double angle = 2.0 * std::atan(size / DepthBefore(camera, point));
  const double change = camera->GetParallelProjection() != 0
                          ? camera->GetParallelScale() / size
                          : camera->GetViewAngle() / vtkMath::DegreesFromRadians(angle);
  this->SetZoom(this->Scene->GetZoom() * change);
}

// The camera turns about the place that the scene looks at, or about what is seen there once the
// camera moved. False when it looks at no place.
bool vtkNexradNavigator::FindPivot(double point[3])
{
  double place[3];
  if (!this->IsReady() || !this->Scene->GetLookAt(place))
  {
    return false;
  }
  if (this->Moved)
  {
    const int* size = this->Scene->GetRenderer()->GetSize();
    this->CentreOn(0.5 * size[0], 0.5 * size[1]);
    this->Moved = false;
    this->Scene->Update();
    this->Scene->GetLookAt(place);
  }
  const ScenePoint found = this->Scene->GetSceneFrame()->ToScene({place[0], place[1], place[2]});
  std::copy(found.begin(), found.end(), point);
  return true;
}

void vtkNexradNavigator::Turn(double azimuth, double tilt)
{
  if (!this->Scene)
  {
    return;
  }
  double pivot[3];
  const bool near = this->FindPivot(pivot);
  const double size =
    near ? nexrad::scene::HalfHeightAt(this->Scene->GetRenderer()->GetActiveCamera(), pivot) : 0.0;
  this->Scene->SetAzimuth(std::fmod(this->Scene->GetAzimuth() + azimuth + 360.0, 360.0));
  this->Scene->SetTilt(this->Scene->GetTilt() + tilt);
  if (near && this->Scene->Update())
  {
    this->SetSizeAt(pivot, size);
  }
}

void vtkNexradNavigator::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Scene: " << this->Scene.Get() << "\n";
}
