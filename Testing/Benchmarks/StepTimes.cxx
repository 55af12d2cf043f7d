// SPDX-License-Identifier: BSD-3-Clause
#include "StepTimes.h"

#include "Scene/RadarSession.h"
#include "nexrad/System/Error.h"

#include <vtkRenderWindow.h>

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

StepTimes MeasureStep(RadarSession& session, std::size_t step, vtkRenderWindow* window)
{
  window->MakeCurrent();
  window->WaitForCompletion();
  StepTimes times;
  StopWatch watch;
  session.Load(step);
  times.load = watch.Lap();
  session.Show(step);
  const double captions = watch.Lap();
  if (!session.Scene().Upload())
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
