// SPDX-License-Identifier: BSD-3-Clause
#include "Options/GridOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/System/MachineMemory.h"

#include <CLI/CLI.hpp>

namespace nexrad::application
{

void AddGridOptions(CLI::App& command, MergeOptions& options)
{
  options.memoryLimit = {MachineMemory().value_or(0), ""};
  for (const Setting<MergeOptions>& setting : MergeSettings())
  {
    AddSetting(command, setting, options)
      ->group(setting.use == SettingUse::Machine ? "Memory and threads" : "Merging radar files");
  }
  command.parse_complete_callback(
    [&command, &options] { CheckGiven(command, MergeSettings(), options); });
}

std::vector<OptionText> GivenGridOptions(const CLI::App& command)
{
  std::vector<OptionText> given;
  for (const Setting<MergeOptions>& setting : MergeSettings())
  {
    if (setting.use == SettingUse::Result && command.count(setting.Option()) > 0)
    {
      const CLI::Option* option = command.get_option(setting.Option());
      given.push_back({setting.Option(), setting.IsFlag() ? "" : option->as<std::string>()});
    }
  }
  return given;
}

} // namespace nexrad::application
