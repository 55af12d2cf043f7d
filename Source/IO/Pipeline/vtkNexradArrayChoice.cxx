// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradArrayChoice.h"

#include "nexrad/Model/Moment.h"
#include "nexrad/System/Error.h"

#include "vtkDataArraySelection.h"

#include <algorithm>

std::vector<nexrad::MomentName> vtkNexradMomentsToRead(const std::string& names)
{
  std::vector<nexrad::MomentName> moments = nexrad::ParseMomentNames(names);
  if (moments.empty() && !names.empty())
  {
    throw nexrad::Error("moments " + names + " are unknown: set names as in REF,VEL");
  }
  return moments;
}

std::vector<std::string> vtkNexradNamesToLeaveOut(vtkDataArraySelection* selection)
{
  std::vector<std::string> names;
  for (int i = 0; i < selection->GetNumberOfArrays(); ++i)
  {
    if (selection->GetArraySetting(i) == 0)
    {
      names.emplace_back(selection->GetArrayName(i));
    }
  }
  return names;
}

void vtkNexradListArrays(const std::vector<std::string>& names, vtkDataArraySelection* selection)
{
  for (int i = selection->GetNumberOfArrays(); i-- > 0;)
  {
    const std::string known = selection->GetArrayName(i);
    if (std::find(names.begin(), names.end(), known) == names.end())
    {
      selection->RemoveArrayByIndex(i);
    }
  }
  for (const std::string& name : names)
  {
    selection->AddArray(name.c_str());
  }
}
