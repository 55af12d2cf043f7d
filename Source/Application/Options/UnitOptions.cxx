// SPDX-License-Identifier: BSD-3-Clause
#include "Options/UnitOptions.h"

#include "nexrad/System/MachineMemory.h"

namespace nexrad::application
{

CLI::Option* AddTextOption(CLI::App& command, const std::string& name,
  const std::function<void(const std::string&)>& take, const std::string& unit,
  const std::string& description)
{
  // Of several long names the first one.
  const std::string shown = name.compare(0, 2, "--") == 0 ? name.substr(0, name.find(',')) : name;
  const auto store = [take, shown](const std::string& text)
  {
    try
    {
      take(text);
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError(shown, error.what());
    }
  };
  // CLI11 would split "0,20km" only on request; one text is one value.
  return command.add_option_function<std::string>(name, store, description)
    ->type_name(unit)
    ->expected(1);
}

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

} // namespace nexrad::application
