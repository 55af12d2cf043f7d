// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// Writes the Level II files of one radar of the synthetic day whose volumes begin within `length`
/// from `begin`. Returns their paths.
std::vector<std::filesystem::path> WriteSyntheticScans(
  const std::filesystem::path& folder, const std::string& site, Time begin, Duration length);

} // namespace nexrad::testing
