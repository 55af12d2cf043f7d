// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeSettings.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>

/// Options whose texts are values. The Add functions turn an Error of a Parse function into the
/// wrong usage of the named option.
namespace nexrad::application
{

/// An option whose text `take` takes. `unit` is the placeholder in the help text.
CLI::Option* AddTextOption(CLI::App& command, const std::string& name,
  const std::function<void(const std::string&)>& take, const std::string& unit,
  const std::string& description);

/// An option whose text `parse` turns into `value`. `unit` is the placeholder in the help text. The
/// help text shows `defaultText` when it is not empty.
template <typename Value, typename Parse>
CLI::Option* AddParsedOption(CLI::App& command, const std::string& name, Value& value,
  const Parse& parse, const std::string& unit, const std::string& description,
  const std::string& defaultText = "")
{
  const auto take = [&value, parse](const std::string& text) { value = parse(text); };
  CLI::Option* option = AddTextOption(command, name, take, unit, description);
  if (!defaultText.empty())
  {
    option->default_str(defaultText);
  }
  return option;
}

/// An option of a type of values; what `value` holds is the default that the help text shows.
template <typename Value>
CLI::Option* AddValueOption(CLI::App& command, const std::string& name, Value& value,
  const ValueType<Value>& type, const std::string& description)
{
  return AddParsedOption(
    command, name, value, type.parse, type.unit, description, type.text(value));
}

/// The option of a setting, which stores into `settings`. An empty text is wrong usage. A name with
/// "colour" in it may be written with "color" as well.
template <typename Settings>
CLI::Option* AddSetting(CLI::App& command, const Setting<Settings>& setting, Settings& settings)
{
  const auto take = [&setting, &settings](const std::string& text)
  {
    if (text.empty() && !setting.IsFlag())
    {
      throw Error("'' is no value; write " + setting.value.unit);
    }
    SetOption(setting, text, settings);
  };
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

/// Once all options are known: throws CLI::ValidationError for a setting that was given and that
/// the others refuse.
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

/// Adds the options of merging to a command: those of MergeSettings that the program has. They
/// store into `options`, which must outlive the parsing.
void AddGridOptions(CLI::App& command, MergeOptions& options);

} // namespace nexrad::application
