// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Settings/Setting.h"

#include <functional>
#include <string>

namespace CLI
{
class App;
class Option;
} // namespace CLI

/// Options whose texts have units. The Add functions turn an Error of a Parse function into the
/// wrong usage of the named option.
namespace nexrad::application
{

/// An option whose text `take` takes. `unit` is the placeholder in the help text.
CLI::Option* AddTextOption(CLI::App& command, const std::string& name,
  const std::function<void(const std::string&)>& take, const std::string& unit,
  const std::string& description);

/// An option whose text `parse` turns into `value`. `unit` is the placeholder in the help text. The
/// help text shows `defaultText` when it is not empty.
template <typename Value, typename Target>
CLI::Option* AddParsedOption(CLI::App& command, const std::string& name, Target& value,
  Value (*parse)(const std::string&), const std::string& unit, const std::string& description,
  const std::string& defaultText = "");

/// An option that takes a number from `least` to `most`, both inclusive; what `value` holds is the
/// default that the help text shows. `unit` is the placeholder there.
template <typename Number>
CLI::Option* AddNumberOption(CLI::App& command, const std::string& name, Number& value,
  Number least, Number most, const std::string& unit, const std::string& description);

/// The option of a setting, which stores into `settings`. A name with "colour" in it may be written
/// with "color" as well.
template <typename Settings>
CLI::Option* AddSetting(CLI::App& command, const Setting<Settings>& setting, Settings& settings);

/// Once all options are known: throws CLI::ValidationError for a setting that was given and that
/// the others refuse.
template <typename Settings>
void CheckGiven(
  const CLI::App& command, const SettingTable<Settings>& table, const Settings& settings);

} // namespace nexrad::application

#include "Options/UnitOptions.hxx"
