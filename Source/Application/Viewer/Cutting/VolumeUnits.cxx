// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Cutting/VolumeUnits.h"

#include "Scene/Cutting/CutOptions.h"
#include "Scene/Frame/VolumeInformation.h"

#include <vtkImageData.h>

namespace nexrad::viewer
{

HorizontalUnit HorizontalUnitOf(vtkImageData* volume)
{
  const bool geographic = volume != nullptr && scene::IsGeographic(volume);
  return geographic ? HorizontalUnit{1.0, scene::MetresPerDegree, "°", 3} : HorizontalUnit{};
}

std::array<double, 6> FacesOf(vtkImageData* volume)
{
  std::array<double, 6> faces{};
  volume->GetBounds(faces.data());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double half = 0.5 * volume->GetSpacing()[axis];
    faces[2 * axis] -= half;
    faces[2 * axis + 1] += half;
  }
  return faces;
}

} // namespace nexrad::viewer
