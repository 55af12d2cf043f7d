// SPDX-License-Identifier: BSD-3-Clause
#include "BenchOutput.h"

#include "Commands/Command.h"

#include "Output/MessageOutput.h"
#include <nlohmann/json.hpp>

#include <iostream>

namespace nexrad::application
{

void PrintJson(const nlohmann::ordered_json& json)
{
  std::cout << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

int PrintProblems(const std::vector<std::string>& problems)
{
  for (const std::string& problem : problems)
  {
    PrintMessage(problem);
  }
  return problems.empty() ? Done : DoneWithDamage;
}

} // namespace nexrad::application
