// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Error.h"

#include <CLI/CLI.hpp>

#include <sstream>

namespace nexrad::application
{

template <typename Value, typename Target>
CLI::Option* AddParsedOption(CLI::App& command, const std::string& name, Target& value,
  Value (*parse)(const std::string&), const std::string& unit, const std::string& description,
  const std::string& defaultText)
{
  const auto take = [&value, parse](const std::string& text) { value = parse(text); };
  CLI::Option* option = AddTextOption(command, name, take, unit, description);
  if (!defaultText.empty())
  {
    option->default_str(defaultText);
  }
  return option;
}

template <typename Number>
CLI::Option* AddNumberOption(CLI::App& command, const std::string& name, Number& value,
  Number least, Number most, const std::string& unit, const std::string& description)
{
  // Not CLI::Range, which lets NaN pass.
  const auto check = [least, most](const std::string& text)
  {
    Number number{};
    const bool right = CLI::detail::lexical_cast(text, number) && number >= least && number <= most;
    std::ostringstream message;
    message << "'" << text << "' is no number from " << least << " to " << most;
    return right ? std::string() : message.str();
  };
  return command.add_option(name, value, description)
    ->capture_default_str()
    ->type_name(unit)
    ->check(CLI::Validator(check, ""));
}

template <typename Settings>
CLI::Option* AddSetting(CLI::App& command, const Setting<Settings>& setting, Settings& settings)
{
  const auto take = [&setting, &settings](const std::string& text)
  { SetOption(setting, text, settings); };
  std::string names = setting.Option();
  const std::size_t colour = names.find("colour");
  if (colour != std::string::npos)
  {
    names += "," + names.substr(0, colour) + "color" + names.substr(colour + 6);
  }
  CLI::Option* option = setting.IsFlag()
                          ? command.add_flag_callback(
                              names, [take] { take(""); }, setting.says)
                          : AddTextOption(command, names, take, setting.value.unit, setting.says);
  if (!setting.IsFlag() && !setting.Default().empty())
  {
    option->default_str(setting.Default());
  }
  if (!setting.excludes.empty())
  {
    option->excludes(command.get_option("--" + setting.excludes));
  }
  return option;
}

template <typename Settings>
void CheckGiven(
  const CLI::App& command, const SettingTable<Settings>& table, const Settings& settings)
{
  for (const Setting<Settings>& setting : table)
  {
    const std::string refusal = setting.refusal(settings);
    if (!refusal.empty() && command.get_option_no_throw(setting.Option()) != nullptr &&
        command.count(setting.Option()) > 0)
    {
      throw CLI::ValidationError(setting.Option(), refusal);
    }
  }
}

} // namespace nexrad::application
