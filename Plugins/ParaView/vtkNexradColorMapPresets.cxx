// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapPresets.h"

#include "vtkNexradTransferFunction.h"

#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtk_jsoncpp.h"

#include <sstream>
#include <string>

namespace
{

// ParaView keeps presets in the user's settings, so one of an earlier version of the plugin may be
// there. What else the user's settings say of it, as its groups, stays.
void UpdatePreset(
  vtkSMTransferFunctionPresets* presets, const std::string& name, const Json::Value& map)
{
  Json::Value kept = presets->GetFirstPresetWithName(name.c_str());
  for (const std::string& member : map.getMemberNames())
  {
    kept[member] = map[member];
  }
  kept["Name"] = name;
  presets->SetPreset(name.c_str(), kept);
}

} // namespace

void vtkNexradAddColorMapPresets()
{
  const vtkProcessModule::ProcessTypes process = vtkProcessModule::GetProcessType();
  if (process != vtkProcessModule::PROCESS_CLIENT && process != vtkProcessModule::PROCESS_BATCH)
  {
    return;
  }
  vtkSMTransferFunctionPresets* presets = vtkSMTransferFunctionPresets::GetInstance();
  for (int i = 0; i < vtkNexradTransferFunction::GetNumberOfPresets(); ++i)
  {
    const std::string preset = vtkNexradTransferFunction::GetPresetName(i);
    const std::string name = "NEXRAD " + preset;
    vtkNew<vtkNexradTransferFunction> function;
    function->ApplyPreset(preset.c_str());
    Json::Value list;
    std::istringstream(function->FormatJSON()) >> list;
    if (presets->HasPreset(name.c_str()))
    {
      UpdatePreset(presets, name, list[0]);
    }
    else
    {
      presets->AddPreset(name.c_str(), list[0]);
    }
  }
}
