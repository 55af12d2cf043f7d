// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceResolution.h"

#include <algorithm>

bool vtkTextureSliceResolution::IsInteractive(double allowedTime)
{
  // The same border as in VTK's ray caster.
  return allowedTime < 1.0;
}

double vtkTextureSliceResolution::Choose(double allowedTime, double minimum, double maximum)
{
  constexpr double distances[] = {1.0, 2.0, 5.0, 10.0};
  double chosen = distances[0];
  for (const double distance : distances)
  {
    chosen = distance;
    if (!IsInteractive(allowedTime) || this->FullTime <= allowedTime * distance * distance)
    {
      break;
    }
  }
  this->LastDistance = std::max(minimum, std::min(chosen, maximum));
  return this->LastDistance;
}

void vtkTextureSliceResolution::Report(double seconds)
{
  const double full = seconds * this->LastDistance * this->LastDistance;
  // Averaged, so that one slow frame does not make the picture flicker.
  this->FullTime = this->FullTime > 0.0 ? 0.5 * (this->FullTime + full) : full;
}
