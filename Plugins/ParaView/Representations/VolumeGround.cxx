// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeGround.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/SceneOptions.h"
#include "Scene/Shapes/Theme.h"
#include "Scene/VolumeAppearance.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <cstddef>
#include <utility>

using nexrad::scene::SceneFrame;

namespace
{

// What one unit of the scene is in the coordinates of a volume to scale.
std::array<double, 3> UnitOf(const SceneFrame& toScale)
{
  const auto from = toScale.ToVolume({0.0, 0.0, 0.0});
  const auto to = toScale.ToVolume({1.0, 1.0, 1.0});
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

} // namespace

VolumeGround::VolumeGround() = default;

VolumeGround::~VolumeGround()
{
  this->Remove();
}

void VolumeGround::AddTo(vtkRenderer* drawing)
{
  this->Remove();
  renderer = drawing;
}

void VolumeGround::Remove()
{
  this->Show(nullptr);
  renderer = nullptr;
}

void VolumeGround::Show(vtkSmartPointer<vtkActor> made)
{
  if (actor && renderer)
  {
    renderer->RemoveActor(actor);
  }
  actor = std::move(made);
  if (actor && renderer)
  {
    renderer->AddActor(actor);
  }
}

void VolumeGround::Follow(vtkImageData* image, vtkVolume* volume)
{
  const SceneFrame toScale(image, 1.0);
  const std::array<double, 3> unit = UnitOf(toScale);
  const double* scale = volume->GetScale();
  const double exaggeration = scale[2] * unit[2] / (scale[1] * unit[1]);
  const Place wanted = {
    toScale.Bounds(), nexrad::scene::ReadVolumeInformation(image).projection, exaggeration};
  if (!actor || !(wanted == place))
  {
    place = wanted;
    auto made = MakeGroundActor(
      SceneFrame(image, exaggeration), ThemeOf(nexrad::scene::SceneOptions().theme));
    made->PickableOff();
    this->Show(made);
  }
  // From the scene to the coordinates of the volume, and from there to those of the view.
  const auto middle = toScale.ToVolume({0.0, 0.0, 0.0});
  std::array<double, 3> position{};
  volume->GetPosition(position.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    position[axis] += scale[axis] * middle[axis];
  }
  actor->SetPosition(position.data());
  actor->SetScale(scale[0] * unit[0], scale[1] * unit[1], scale[1] * unit[1]);
}

void VolumeGround::Update(vtkOpenGLTextureSliceVolumeMapper* mapper, vtkVolume* volume, bool wanted)
{
  auto* image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  if (!wanted || renderer == nullptr || image == nullptr || image->GetNumberOfPoints() == 0 ||
      volume->GetVisibility() == 0)
  {
    this->Show(nullptr);
    return;
  }
  this->Follow(image, volume);
  nexrad::scene::LightOptions light;
  light.shadow = mapper->GetShadowStrength();
  light.occlusion = mapper->GetOcclusionStrength();
  vtkImageData* arriving =
    light.HasShadows() ? nexrad::scene::UpdateLight(mapper, renderer, volume) : nullptr;
  shadow.Show(actor, arriving, light, image);
}
