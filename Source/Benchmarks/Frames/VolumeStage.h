// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Report/Machine.h"
#include "Scene/Frame/CameraView.h"
#include "Scene/SceneOptions.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <array>

class vtkImageData;
class vtkRenderer;
class vtkRenderWindow;
class vtkVolume;
class vtkVolumeMapper;

namespace nexrad::scene
{

/// A window with a volume alone in it, without map and letters, drawn by the slices or by VTK's GPU
/// ray caster: for measuring. Colours, opacities and stretching of heights are those of the
/// program.
class VolumeStage
{
public:
  /// Throws Error when there is no display.
  explicit VolumeStage(const std::array<int, 2>& size);
  ~VolumeStage();
  VolumeStage(const VolumeStage&) = delete;
  VolumeStage& operator=(const VolumeStage&) = delete;

  /// The volume to be drawn by one of the two, as the project's filters write them. It is not
  /// changed.
  void SetVolume(MapperChoice choice, vtkImageData* volume);

  /// Draws a frame and waits until OpenGL has done it. Slices, or samples of the rays, are 1 /
  /// `slices` of the box's extent along the view's axis apart. Returns seconds.
  double Draw(MapperChoice choice, const CameraView& view, int slices);

  application::OpenGLNames OpenGL();

private:
  vtkVolumeMapper* Mapper(MapperChoice choice) { return mappers[static_cast<int>(choice)]; }
  double ThicknessAlongView() const;

  std::array<int, 2> size;
  std::array<double, 6> box{}; ///< faces of the volume: west, east, south, north, bottom, top
  std::array<vtkSmartPointer<vtkVolumeMapper>, 2> mappers; ///< in the order of MapperChoice
  vtkSmartPointer<vtkImageData> placed;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkRenderWindow> window;
};

} // namespace nexrad::scene
