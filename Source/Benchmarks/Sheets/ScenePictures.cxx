// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/ScenePictures.h"

#include "Scene/EchoFraming.h"

#include <vtkImageData.h>

namespace nexrad::scene
{
namespace
{

// As the thesis draws: a slice takes one sample of the volume.
SceneOptions SampledOptions()
{
  SceneOptions options;
  options.preIntegration = false;
  return options;
}

} // namespace

ScenePictures::ScenePictures(const CameraView& view, const std::array<int, 2>& size)
  : scene(SampledOptions())
  , window(scene.GetRenderer(), size)
{
  scene.SetPictureSize(size);
  scene.SetCamera(view);
}

void ScenePictures::HoldEchoOf(VolumeSeries& series, const std::vector<std::size_t>& steps)
{
  scene.HoldEcho(MeasureSeries(series, steps, SampledOptions()));
}

vtkSmartPointer<vtkImageData> ScenePictures::DrawWithoutVolume()
{
  scene.ShowVolume(false);
  auto picture = window.Draw();
  scene.ShowVolume(true);
  return picture;
}

} // namespace nexrad::scene
