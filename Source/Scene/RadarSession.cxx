// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/RadarSession.h"

#include "Scene/PlayAhead.h"

#include <vtkImageData.h>

#include <utility>

namespace nexrad::scene
{

RadarSession::RadarSession(
  std::unique_ptr<VolumeSeries> source, std::vector<std::size_t> steps, const SceneOptions& options)
  : series(PlayAhead(std::move(source), steps, options))
  , chosen(std::move(steps))
  , scene(options)
{
}

bool RadarSession::Load(std::size_t step, const Progress& progress)
{
  if (shown != step && (loaded.first != step || !loaded.second))
  {
    loaded = {step, series->Load(chosen[step], progress)};
    return loaded.second != nullptr;
  }
  return true;
}

bool RadarSession::Show(std::size_t step, const Progress& progress)
{
  if (shown == step)
  {
    return true;
  }
  if (!this->Load(step, progress))
  {
    return false;
  }
  scene.SetVolume(std::exchange(loaded.second, nullptr));
  shown = step;
  return true;
}

} // namespace nexrad::scene
