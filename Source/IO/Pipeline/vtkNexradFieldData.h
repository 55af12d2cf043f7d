// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkNexradFieldData.h
 * @brief  puts single values and texts into field data, and reads them back
 */
#ifndef vtkNexradFieldData_h
#define vtkNexradFieldData_h

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <optional>
#include <string>
#include <vector>

/**
 * Adds an array of one tuple that holds the values.
 */
template <class Array>
void vtkNexradAddValues(
  vtkFieldData* field, const char* name, const std::vector<typename Array::ValueType>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.size()));
  array->SetNumberOfTuples(1);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    array->SetTypedComponent(0, static_cast<int>(i), values[i]);
  }
  field->AddArray(array);
}

inline void vtkNexradAddTexts(
  vtkFieldData* field, const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  field->AddArray(array);
}

/**
 * A component of the first tuple; empty when there is no such array or component.
 */
inline std::optional<double> vtkNexradGetValue(
  vtkFieldData* field, const char* name, int component = 0)
{
  vtkDataArray* array = field ? field->GetArray(name) : nullptr;
  if (!array || array->GetNumberOfTuples() < 1 || component >= array->GetNumberOfComponents())
  {
    return std::nullopt;
  }
  return array->GetComponent(0, component);
}

inline std::vector<std::string> vtkNexradGetTexts(vtkFieldData* field, const char* name)
{
  std::vector<std::string> texts;
  auto* array = field ? vtkStringArray::SafeDownCast(field->GetAbstractArray(name)) : nullptr;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    texts.push_back(array->GetValue(i));
  }
  return texts;
}

#endif
// VTK-HeaderTest-Exclude: vtkNexradFieldData.h
