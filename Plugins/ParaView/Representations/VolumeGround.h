// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Map/GroundPicture.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>

class vtkActor;
class vtkImageData;
class vtkOpenGLTextureSliceVolumeMapper;
class vtkRenderer;
class vtkVolume;

/// The ground of the scene under a volume of ParaView, with the volume's shadow: shaded relief and
/// water where the volume has a projection, else one colour.
class VolumeGround
{
public:
  VolumeGround();
  ~VolumeGround();

  /// Puts the ground into a renderer, which draws the volume.
  void AddTo(vtkRenderer* renderer);
  void Remove();

  /// Brings the ground up to date before a frame is drawn. It is not there where the volume is not
  /// visible.
  void Update(vtkOpenGLTextureSliceVolumeMapper* mapper, vtkVolume* volume, bool wanted);

private:
  /// The volume and its scale, of which the ground was made.
  struct Place
  {
    std::array<double, 6> bounds{};
    std::string projection;
    double exaggeration = 0.0;

    bool operator==(const Place& other) const
    {
      return bounds == other.bounds && projection == other.projection &&
             exaggeration == other.exaggeration;
    }
  };

  void Follow(vtkImageData* image, vtkVolume* volume);
  void Show(vtkSmartPointer<vtkActor> made);

  vtkWeakPointer<vtkRenderer> renderer;
  vtkSmartPointer<vtkActor> actor;
  Place place;
  nexrad::scene::GroundShadow shadow;
};
