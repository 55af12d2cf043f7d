// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Frame/VolumeInformation.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

namespace nexrad::scene
{
namespace
{

std::vector<std::string> Texts(vtkFieldData* fields, const char* name)
{
  std::vector<std::string> texts;
  auto* array = vtkStringArray::SafeDownCast(fields->GetAbstractArray(name));
  for (vtkIdType i = 0; array != nullptr && i < array->GetNumberOfValues(); ++i)
  {
    texts.push_back(array->GetValue(i));
  }
  return texts;
}

std::string Text(vtkFieldData* fields, const char* name)
{
  const auto texts = Texts(fields, name);
  return texts.empty() ? std::string() : texts.front();
}

std::optional<double> Number(vtkFieldData* fields, const char* name)
{
  vtkDataArray* array = fields->GetArray(name);
  return array != nullptr && array->GetNumberOfTuples() > 0 ? std::optional(array->GetTuple1(0))
                                                            : std::nullopt;
}

} // namespace

VolumeInformation ReadVolumeInformation(vtkImageData* volume)
{
  vtkFieldData* fields = volume->GetFieldData();
  VolumeInformation information;
  if (const auto seconds = Number(fields, "TimeValue"))
  {
    information.time = FromSeconds(*seconds);
  }
  information.sites = Texts(fields, "Sites");
  information.method = Text(fields, "Method");
  information.projection = Text(fields, "Projection");
  information.synthetic = Number(fields, "Synthetic").value_or(0.0) != 0.0;
  information.sharpened = Number(fields, "Sharpened").value_or(0.0) != 0.0;
  information.biologicalShare = Number(fields, "BiologicalShare").value_or(0.0);
  information.notes = Texts(fields, "Notes");
  return information;
}

bool IsGeographic(vtkImageData* volume)
{
  return ReadVolumeInformation(volume).IsGeographic();
}

PlaceUnit PlaceUnitOf(vtkImageData* volume)
{
  return IsGeographic(volume) ? PlaceUnit::Degrees : PlaceUnit::Metres;
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
