// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/VolumeInformation.h"

#include "vtkNexradFieldData.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

namespace nexrad::scene
{

VolumeInformation ReadVolumeInformation(vtkImageData* volume)
{
  vtkFieldData* fields = volume->GetFieldData();
  const auto number = [fields](const char* name) { return vtkNexradGetValue(fields, name); };
  const auto text = [fields](const char* name)
  {
    const std::vector<std::string> texts = vtkNexradGetTexts(fields, name);
    return texts.empty() ? std::string() : texts.front();
  };
  VolumeInformation information;
  if (const auto seconds = number("TimeValue"))
  {
    information.time = FromSeconds(*seconds);
  }
  information.sites = vtkNexradGetTexts(fields, "Sites");
  information.method = text("Method");
  information.projection = text("Projection");
  information.synthetic = number("Synthetic").value_or(0.0) != 0.0;
  information.sharpened = number("Sharpened").value_or(0.0) != 0.0;
  information.biologicalShare = number("BiologicalShare").value_or(0.0);
  information.notes = vtkNexradGetTexts(fields, "Notes");
  return information;
}

PlaceUnit PlaceUnitOf(vtkImageData* volume)
{
  return ReadVolumeInformation(volume).IsGeographic() ? PlaceUnit::Degrees : PlaceUnit::Metres;
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

std::array<double, 4> SidesOf(vtkImageData* volume)
{
  const auto [west, east, south, north, bottom, top] = FacesOf(volume);
  return {west, east, south, north};
}

std::string ArrayOf(vtkImageData* volume)
{
  vtkDataArray* scalars = volume != nullptr ? volume->GetPointData()->GetScalars() : nullptr;
  const char* name = scalars != nullptr ? scalars->GetName() : nullptr;
  return name != nullptr ? name : "";
}

} // namespace nexrad::scene
