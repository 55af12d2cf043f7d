// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/RadarSession.h"

#include "Scene/EchoFraming.h"
#include "Scene/PlayAhead.h"

#include <vtkImageData.h>

#include <utility>

namespace nexrad::scene
{

RadarSession::RadarSession(std::unique_ptr<VolumeSeries> source, std::vector<std::size_t> steps,
  const SceneOptions& options, const std::optional<BoxRequest>& finerBox)
  : echo(MeasureSeries(*source, steps, options))
  , series(finerBox ? std::move(source) : PlayAhead(std::move(source), steps, options))
  , chosen(std::move(steps))
  , box(finerBox)
  , scene(options)
{
  scene.HoldEcho(echo);
}

bool RadarSession::Load(std::size_t step, const Progress& progress)
{
  if (shown == step || (loaded.step == step && loaded.volume))
  {
    return true;
  }
  constexpr double part = 0.5; // of the work, where there is a box
  loaded = {step, series->Load(chosen[step], box ? ShareOf(progress, 0.0, part) : progress), {}};
  if (loaded.volume && box)
  {
    loaded.box = series->LoadBox(chosen[step], *box, ShareOf(progress, part, 1.0));
    loaded.volume = loaded.box ? loaded.volume : nullptr;
  }
  return loaded.volume != nullptr;
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
  scene.SetVolume(std::exchange(loaded.volume, nullptr));
  if (box)
  {
    scene.SetDetail(loaded.box);
    scene.MarkBox(SidesOf(loaded.box));
    loaded.box = nullptr;
  }
  shown = step;
  return true;
}

} // namespace nexrad::scene
