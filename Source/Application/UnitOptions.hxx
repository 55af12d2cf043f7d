// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Model/Error.h"

#include <CLI/CLI.hpp>

namespace nexrad::application
{

template <typename Value, typename Target>
CLI::Option* AddParsedOption(CLI::App& command, const std::string& name, Target& value,
  Value (*parse)(const std::string&), const std::string& unit, const std::string& description,
  const std::string& defaultText)
{
  const auto store = [&value, parse, name](const std::string& text)
  {
    try
    {
      value = parse(text);
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError(name, error.what());
    }
  };
  CLI::Option* option = command.add_option_function<std::string>(name, store, description);
  option->type_name(unit);
  // CLI11 would split "0,20km" and friends only on request; one text is one value.
  option->expected(1);
  if (!defaultText.empty())
  {
    option->default_str(defaultText);
  }
  return option;
}

} // namespace nexrad::application
