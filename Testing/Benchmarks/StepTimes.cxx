// SPDX-License-Identifier: BSD-3-Clause
#include "StepTimes.h"

#include "Filters/Series/BackgroundSeries.h"
#include "nexrad/System/Error.h"

#include <vtkNexradVolumeScene.h>
#include <vtkOpenGLTextureSliceVolumeMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>

#include <chrono>

namespace nexrad::scene
{
namespace
{

class StopWatch
{
public:
  /// Seconds since the last call, or since it was made.
  double Lap()
  {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - begin).count();
    begin = now;
    return seconds;
  }

private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin = Clock::now();
};

} // namespace

StepTimes MeasureStep(
  BackgroundSeries& series, std::size_t step, vtkNexradVolumeScene* scene, vtkRenderWindow* window)
{
  window->MakeCurrent();
  window->WaitForCompletion();
  StepTimes times;
  StopWatch watch;
  const auto image = series.Wait(step);
  times.load = watch.Lap();
  scene->SetVolume(image);
  scene->Draw();
  const double captions = watch.Lap();
  vtkRenderer* renderer = scene->GetRenderer();
  auto* volume = vtkVolume::SafeDownCast(renderer->GetVolumes()->GetItemAsObject(0));
  auto* mapper = vtkOpenGLTextureSliceVolumeMapper::SafeDownCast(volume->GetMapper());
  if (!mapper->PreLoadData(renderer, volume))
  {
    throw Error("the volume cannot be brought into texture memory");
  }
  window->WaitForCompletion();
  times.upload = watch.Lap();
  window->Render();
  window->WaitForCompletion();
  times.draw = captions + watch.Lap();
  return times;
}

double MeasureFrame(vtkRenderWindow* window)
{
  window->MakeCurrent();
  window->WaitForCompletion();
  StopWatch watch;
  window->Render();
  window->WaitForCompletion();
  return watch.Lap();
}

} // namespace nexrad::scene
