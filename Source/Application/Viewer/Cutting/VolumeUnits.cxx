// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Cutting/VolumeUnits.h"

#include "Scene/Frame/VolumeInformation.h"
#include "nexrad/Geometry/Angles.h"

namespace nexrad::viewer
{

HorizontalUnit HorizontalUnitOf(vtkImageData* volume)
{
  const bool geographic = volume != nullptr && scene::IsGeographic(volume);
  return geographic ? HorizontalUnit{1.0, MetresPerDegree, "°", 3} : HorizontalUnit{};
}

} // namespace nexrad::viewer
