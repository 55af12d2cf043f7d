// SPDX-License-Identifier: BSD-3-Clause
#include "Options/GridOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/System/MachineMemory.h"

#include <CLI/CLI.hpp>

namespace nexrad::application
{
namespace
{

void AddOption(CLI::App& command, const Setting<MergeOptions>& setting, MergeOptions& options)
{
  const auto take = [&setting, &options](const std::string& text)
  { SetOption(setting, text, options); };
  CLI::Option* option = setting.IsFlag() ? command.add_flag_callback(
                                             setting.Option(), [take] { take(""); }, setting.says)
                                         : AddTextOption(command, setting.Option(), take,
                                             setting.value.unit, setting.says);
  if (!setting.IsFlag() && !setting.Default().empty())
  {
    option->default_str(setting.Default());
  }
  if (!setting.excludes.empty())
  {
    option->excludes(command.get_option("--" + setting.excludes));
  }
  option->group(setting.use == SettingUse::Machine ? "Memory and threads" : "Merging radar files");
}

// Once all are known. Options that contradict each other are wrong usage.
void CheckGiven(const CLI::App& command, const MergeOptions& options)
{
  for (const Setting<MergeOptions>& setting : MergeSettings())
  {
    const std::string refusal = setting.refusal(options);
    if (!refusal.empty() && command.get_option_no_throw(setting.Option()) != nullptr &&
        command.count(setting.Option()) > 0)
    {
      throw CLI::ValidationError(setting.Option(), refusal);
    }
  }
}

} // namespace

void AddGridOptions(CLI::App& command, MergeOptions& options)
{
  options.memoryLimit = {MachineMemory().value_or(0), ""};
  for (const Setting<MergeOptions>& setting : MergeSettings())
  {
    if (setting.use != SettingUse::Library)
    {
      AddOption(command, setting, options);
    }
  }
  command.parse_complete_callback([&command, &options] { CheckGiven(command, options); });
}

QualityLevel ParseQuality(const std::string& text)
{
  MergeOptions options;
  FindSetting(MergeSettings(), "quality")->set(options, text);
  return options.quality.level;
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
