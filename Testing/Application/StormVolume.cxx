// SPDX-License-Identifier: BSD-3-Clause
#include "StormVolume.h"

#include "Model/Time.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

namespace nexrad::testing
{
namespace
{

// A tower with an anvil that leans to the north east; x, y in km, height in km.
double Storm(double x, double y, double height)
{
  const double core = std::hypot(x + 70.0, y + 70.0) / 30.0;
  const double anvil = std::hypot(x + 70.0 - 6.0 * height, y + 70.0 - 6.0 * height) / 90.0;
  const double fall = std::max(0.0, height - 4.0) * 2.0;
  const double tower = 62.0 - 22.0 * core * core - fall;
  const double veil = 34.0 - 20.0 * anvil * anvil - 1.5 * std::abs(height - 8.0);
  return height > 15.0 ? -33.0 : std::max({tower, veil, -33.0});
}

void AddNumber(vtkFieldData* fields, const char* name, double value)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->InsertNextValue(value);
  fields->AddArray(array);
}

void AddTexts(vtkFieldData* fields, const char* name, std::initializer_list<const char*> texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const char* text : texts)
  {
    array->InsertNextValue(text);
  }
  fields->AddArray(array);
}

} // namespace

vtkSmartPointer<vtkImageData> MakeStormVolume(bool synthetic)
{
  constexpr int size[] = {48, 48, 16};
  constexpr double spacing[] = {10'000.0, 10'000.0, 1'250.0};
  auto volume = vtkSmartPointer<vtkImageData>::New();
  volume->SetDimensions(size);
  volume->SetSpacing(spacing);
  volume->SetOrigin(-235'000.0, -235'000.0, 625.0);
  vtkNew<vtkFloatArray> values;
  values->SetName("REF");
  for (vtkIdType i = 0; i < volume->GetNumberOfPoints(); ++i)
  {
    const double* point = volume->GetPoint(i);
    values->InsertNextValue(
      static_cast<float>(Storm(point[0] / 1000.0, point[1] / 1000.0, point[2] / 1000.0)));
  }
  volume->GetPointData()->SetScalars(values);
  vtkFieldData* fields = volume->GetFieldData();
  AddTexts(fields, "Projection", {"+proj=aeqd +lat_0=39 +lon_0=-90 +datum=WGS84 +units=m"});
  AddTexts(fields, "Sites", {"KLSX", "KILX"});
  AddTexts(fields, "Method", {"thesis"});
  AddNumber(fields, "TimeValue", ToSeconds(*ParseIso8601("2006-03-12T18:30")));
  AddNumber(fields, "Synthetic", synthetic ? 1.0 : 0.0);
  return volume;
}

} // namespace nexrad::testing
