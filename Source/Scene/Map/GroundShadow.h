// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/LightOptions.h"

#include <vtkNew.h>
#include <vtkType.h>

class vtkActor;
class vtkImageData;
class vtkTexture;
class vtkTransform;

namespace nexrad::scene
{

/// The shadow of the volume on the ground: how much light arrives in the lowest layer of the
/// mapper's light volume, as a texture of the ground.
class GroundShadow
{
public:
  GroundShadow();
  ~GroundShadow();

  /// Brings the texture up to date and puts it on the ground, whose texture coordinates are 0 to 1
  /// over the voxels. `light`: vtkOpenGLTextureSliceVolumeMapper::GetLightVolume; nullptr: there is
  /// no shadow. `volume`: what the mapper draws.
  void Show(
    vtkActor* ground, vtkImageData* light, const LightOptions& options, vtkImageData* volume);

private:
  void Fill(vtkImageData* light, const LightOptions& options);

  vtkNew<vtkTexture> texture;
  vtkNew<vtkTransform> transform;
  vtkNew<vtkImageData> image;
  vtkMTimeType made = 0; ///< when the light volume was made that the image shows
  double shadow = 0.0;   ///< strengths that the image shows
  double occlusion = 0.0;
};

} // namespace nexrad::scene
