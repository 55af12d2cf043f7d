// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/CameraView.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>
#include <optional>
#include <vector>

class vtkCamera;
class vtkImageData;
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;

namespace nexrad::scene
{

/// A finer volume that is drawn in place of a part of another one. What the other one has behind
/// that part is drawn first, then the finer volume, then what the other one has before it.
class DetailVolume
{
public:
  explicit DetailVolume(vtkRenderer* renderer);
  /// Takes out of the renderer what it put in.
  ~DetailVolume();
  DetailVolume(const DetailVolume&) = delete;
  DetailVolume& operator=(const DetailVolume&) = delete;

  bool IsShown() const { return shown; }
  /// The mappers that draw beside that of the other volume: none unless it is shown.
  std::vector<vtkVolumeMapper*> Mappers() const;

  /// Draws `detail`, in scene coordinates, in place of the part of `whole` within its bounds, by
  /// these mappers, which must be of the kind of that of `whole`. Follow brings it up to date.
  void Show(vtkImageData* detail, vtkVolume* whole, vtkVolumeMapper* detailMapper,
    vtkVolumeMapper* frontMapper);
  /// Draws the whole of the other volume again.
  void Hide(vtkVolume* whole);

  /// Divides the other volume, as the camera sees it. `seen`: what the picture shows of it. Where
  /// that lies within the finer volume, nothing is drawn before it, which would take a texture.
  void Follow(vtkVolume* whole, const std::optional<SeenPart>& seen);

private:
  vtkSmartPointer<vtkRenderer> renderer;
  vtkNew<vtkVolume> inner;
  vtkNew<vtkVolume> front;
  bool shown = false;
};

/// The regions about a box (low and high of x, y and z), as flags of vtkVolumeMapper's cropping,
/// that may hide a part of the box from the camera, and those that may not.
struct RegionsAbout
{
  int before = 0;
  int behind = 0;
};
RegionsAbout DivideAbout(const std::array<double, 6>& box, vtkCamera* camera);

} // namespace nexrad::scene
