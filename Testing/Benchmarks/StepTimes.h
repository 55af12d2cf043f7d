// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

class vtkNexradVolumeScene;
class vtkRenderWindow;

namespace nexrad
{
class BackgroundSeries;
} // namespace nexrad

namespace nexrad::scene
{

/// What a step of a series costs whoever draws it, in seconds by the clock on the wall: the times
/// of the thesis's table 4.2.
struct StepTimes
{
  double load = 0.0;   ///< t1: until the volume is in memory; of one read ahead, the wait for it
  double upload = 0.0; ///< t2: until it is in texture memory
  double draw = 0.0;   ///< t3: until the frame is drawn, with the captions that change
};

/// Shows a step of a series in a window that holds the scene, and measures. Each part runs to its
/// end before the next begins. Throws Error when the step cannot be loaded or drawn.
StepTimes MeasureStep(
  BackgroundSeries& series, std::size_t step, vtkNexradVolumeScene* scene, vtkRenderWindow* window);

/// Draws what the window shows once more. Seconds until the frame is drawn.
double MeasureFrame(vtkRenderWindow* window);

} // namespace nexrad::scene
