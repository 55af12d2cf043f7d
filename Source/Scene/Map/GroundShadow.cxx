// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/GroundShadow.h"

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkTexture.h>
#include <vtkTransform.h>

#include <cmath>

namespace nexrad::scene
{

GroundShadow::GroundShadow()
{
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->EdgeClampOn();
  texture->SetTransform(transform);
}

GroundShadow::~GroundShadow() = default;

void GroundShadow::Show(
  vtkActor* ground, vtkImageData* light, const LightOptions& options, vtkImageData* volume)
{
  if (light == nullptr)
  {
    ground->SetTexture(nullptr);
    return;
  }
  if (light->GetMTime() != made || options.shadow != shadow || options.occlusion != occlusion)
  {
    this->Fill(light, options);
    made = light->GetMTime();
    shadow = options.shadow;
    occlusion = options.occlusion;
    // The last texel may stand for fewer voxels than the others.
    const auto scale = [&](int axis)
    {
      return volume->GetDimensions()[axis] * volume->GetSpacing()[axis] /
             (light->GetDimensions()[axis] * light->GetSpacing()[axis]);
    };
    transform->Identity();
    transform->Scale(scale(0), scale(1), 1.0);
  }
  ground->SetTexture(texture);
}

void GroundShadow::Fill(vtkImageData* light, const LightOptions& options)
{
  constexpr double full = 65535.0;
  const int* size = light->GetDimensions();
  image->SetDimensions(size[0], size[1], 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  vtkDataArray* arriving = light->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    // The light of the volume comes farther into cores than to the ground.
    const double share = arriving->GetComponent(i, 0) / full;
    const double ofLight = 1.0 - options.shadow * (1.0 - share * share);
    const double ofSky = 1.0 - options.occlusion * (1.0 - arriving->GetComponent(i, 1) / full);
    for (int channel = 0; channel < 3; ++channel)
    {
      *texel++ = static_cast<unsigned char>(std::lround(255.0 * ofLight * ofSky));
    }
  }
  image->Modified();
}

} // namespace nexrad::scene
