// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace nexrad::application
{

/// Prints JSON on standard output.
void PrintJson(const nlohmann::ordered_json& json);

/// Prints a line for each problem on standard error. Returns the exit status that follows: done, or
/// done with damage.
int PrintProblems(const std::vector<std::string>& problems);

} // namespace nexrad::application
