// SPDX-License-Identifier: BSD-3-Clause
#include "RadarSession.h"

#include "Volumes/ReadAhead.h"

#include <vtkImageData.h>

#include <utility>

namespace nexrad::scene
{

RadarSession::RadarSession(std::unique_ptr<application::VolumeSeries> source,
  std::vector<std::size_t> steps, const SceneOptions& options)
  : series(application::ReadAhead(std::move(source)))
  , chosen(std::move(steps))
  , scene(options)
{
}

bool RadarSession::Show(std::size_t step, const Progress& progress)
{
  if (shown == step)
  {
    return true;
  }
  const vtkSmartPointer<vtkImageData> volume = series->Load(chosen[step], progress);
  if (!volume)
  {
    return false;
  }
  scene.SetVolume(volume);
  shown = step;
  return true;
}

} // namespace nexrad::scene
