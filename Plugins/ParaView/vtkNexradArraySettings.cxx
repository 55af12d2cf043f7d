// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradArraySettings.h"

#include "Scene/SceneOptions.h"
#include "Scene/Shapes/Theme.h"
#include "nexrad/Model/Moment.h"
#include "vtkNexradTransferFunction.h"

#include "vtkProcessModule.h"
#include "vtkSMSettings.h"
#include "vtk_jsoncpp.h"

namespace
{

constexpr double Priority =
  0.1; // below the user's settings and those of the site, which have 1 and more

// The legend's title of an array: "Reflectivity (dBZ)".
std::string LegendTitleOf(nexrad::MomentName moment)
{
  std::string title = nexrad::TitleOf(moment);
  const std::string unit = nexrad::UnitOf(moment);
  return unit.empty() || unit == "1" ? title : title + " (" + unit + ")";
}

Json::Value LookupTableOf(nexrad::MomentName moment)
{
  constexpr int never = -1; // vtkSMTransferFunctionManager::NEVER
  Json::Value table;
  table["Title"] = LegendTitleOf(moment);
  table["PVLookupTable"]["AutomaticRescaleRangeMode"] = never;
  table["PVLookupTable"]["NanOpacity"] = 0.0;
  if (moment == nexrad::MomentName::REF)
  {
    // Reflectivity below the legend has none of its colours, but that of the ground.
    table["PVLookupTable"]["UseBelowRangeColor"] = 1;
    for (const double part : ThemeOf(nexrad::scene::SceneOptions().theme).ground)
    {
      table["PVLookupTable"]["BelowRangeColor"].append(part);
    }
  }
  return table;
}

} // namespace

std::string vtkNexradArraySettings()
{
  Json::Value settings;
  for (const nexrad::MomentName moment : nexrad::KnownMoments)
  {
    const char* const array = nexrad::ToString(moment);
    if (const char* preset = vtkNexradTransferFunction::FindPreset(array))
    {
      settings["standard_presets"][array] = std::string("NEXRAD ") + preset;
    }
    settings["array_lookup_tables"][array] = LookupTableOf(moment);
  }
  return settings.toStyledString();
}

void vtkNexradAddArraySettings()
{
  const vtkProcessModule::ProcessTypes process = vtkProcessModule::GetProcessType();
  if (process == vtkProcessModule::PROCESS_CLIENT || process == vtkProcessModule::PROCESS_BATCH)
  {
    vtkSMSettings::GetInstance()->AddCollectionFromString(vtkNexradArraySettings(), Priority);
  }
}
