// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Drawing/PictureWindow.h"
#include "Scene/Frame/CameraView.h"
#include "Scene/RadarScene.h"

#include <array>
#include <cstddef>
#include <vector>

namespace nexrad::scene
{

class VolumeSeries;

/// Pictures of merged volumes with their map and captions, and of the same without the volume.
class ScenePictures
{
public:
  /// Throws Error when there is no display.
  ScenePictures(const CameraView& view, const std::array<int, 2>& size);

  RadarScene& Scene() { return scene; }

  /// One frame for these volumes of a series, about the echo of them all.
  void HoldEchoOf(VolumeSeries& series, const std::vector<std::size_t>& steps);

  vtkSmartPointer<vtkImageData> Draw() { return window.Draw(); }
  vtkSmartPointer<vtkImageData> DrawWithoutVolume();

private:
  RadarScene scene;
  PictureWindow window;
};

} // namespace nexrad::scene
