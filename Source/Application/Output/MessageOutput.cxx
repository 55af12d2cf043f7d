// SPDX-License-Identifier: BSD-3-Clause
#include "Output/MessageOutput.h"

#include "nexrad/System/MessageText.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <iostream>

namespace nexrad::application
{

void PrintMessage(const std::string& message)
{
  std::cerr << MessageLine(message) + '\n' << std::flush;
}

void PrintMessages(const std::vector<std::string>& messages)
{
  for (const std::string& message : messages)
  {
    PrintMessage(message);
  }
}

void PrintJson(const nlohmann::ordered_json& json)
{
  // A file's name need not be UTF-8; JSON must be.
  std::cout << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void PrintOutcome(const Outcome& outcome, bool quiet)
{
  for (std::size_t i = 0; !quiet && i < outcome.made.size(); ++i)
  {
    std::cout << outcome.made[i] << '\n';
  }
  PrintMessages(outcome.notes);
  PrintMessages(outcome.problems);
}

} // namespace nexrad::application
