// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapPresets.h"

#include "vtkNexradTransferFunction.h"

#include "vtkNew.h"
#include "vtkProcessModule.h"
#include "vtkSMTransferFunctionPresets.h"
#include "vtk_jsoncpp.h"

#include <sstream>
#include <string>

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
    if (!presets->HasPreset(name.c_str()))
    {
      vtkNew<vtkNexradTransferFunction> function;
      function->ApplyPreset(preset.c_str());
      Json::Value list;
      std::istringstream(function->FormatJSON()) >> list;
      presets->AddPreset(name.c_str(), list[0]);
    }
  }
}
