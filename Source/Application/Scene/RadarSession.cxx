// SPDX-License-Identifier: BSD-3-Clause
#include "RadarSession.h"

#include "Volumes/ReadAhead.h"
#include "vtkOpenGLTextureSliceVolumeMapper.h"

#include <vtkImageData.h>

#include <utility>

namespace nexrad::scene
{

namespace
{

// Does for each volume what the slices need of it before they are drawn.
class Preparation
{
public:
  void operator()(vtkImageData* volume, vtkImageData* before)
  {
    prepared = vtkOpenGLTextureSliceVolumeMapper::PrepareScalars(
      volume, before != nullptr && before == last ? prepared : nullptr);
    last = volume;
  }

private:
  vtkImageData* last = nullptr; // compared, never followed
  vtkSmartPointer<vtkObject> prepared;
};

// What follows in playing, made ready while the step before is drawn.
std::unique_ptr<application::VolumeSeries> PlayAhead(
  std::unique_ptr<application::VolumeSeries> series, const std::vector<std::size_t>& steps,
  const SceneOptions& options)
{
  application::ReadAheadOptions readAhead;
  readAhead.order = steps;
  if (options.mapper == MapperChoice::TextureSlice && !options.plan)
  {
    readAhead.prepare = Preparation();
  }
  return application::ReadAhead(std::move(series), std::move(readAhead));
}

} // namespace

RadarSession::RadarSession(std::unique_ptr<application::VolumeSeries> source,
  std::vector<std::size_t> steps, const SceneOptions& options)
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
