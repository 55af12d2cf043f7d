// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/LightOptions.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkActor;
class vtkImageData;
class vtkTexture;

namespace nexrad::scene
{

/// The shadow of the volume on the ground: how much light arrives in the lowest layer of the
/// mapper's light volume darkens the picture of the ground.
class GroundShadow
{
public:
  GroundShadow();
  ~GroundShadow();

  /// Brings the shadow up to date and puts it on the ground, which has its picture
  /// (MakeGroundPicture) as texture, with coordinates 0 to 1 over the voxels. `light`:
  /// vtkOpenGLTextureSliceVolumeMapper::GetLightVolume; nullptr: there is no shadow. `volume`: what
  /// the mapper draws. `keeps`: the shadow that is there already stays.
  void Show(vtkActor* ground, vtkImageData* light, const LightOptions& options,
    vtkImageData* volume, bool keeps = false);

private:
  void Fill(vtkImageData* light, const LightOptions& options, vtkImageData* volume);

  vtkSmartPointer<vtkTexture> lit; ///< the ground's own
  vtkNew<vtkTexture> texture;
  vtkNew<vtkImageData> image;
  vtkMTimeType made = 0; ///< when the light volume was made that the image shows
  double shadow = 0.0;   ///< strengths that the image shows
  double occlusion = 0.0;
};

} // namespace nexrad::scene
