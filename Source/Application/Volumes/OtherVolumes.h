// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"

#include <filesystem>
#include <set>
#include <string>

namespace nexrad::application
{

/// Throws Error when a folder has `.nxv` files, beside those that a run is going to write or
/// replace
/// (`own`, by name), whose grid is not that of the run: together they would look like one series.
/// Files that cannot be read are passed over; so is a folder that does not exist.
void RequireSameGrid(const std::filesystem::path& folder, const std::set<std::string>& own,
  const GridSpecification& grid);

} // namespace nexrad::application
