// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/FinerBox.h"

#include <optional>
#include <string>

namespace CLI
{
class App;
}

namespace nexrad::application
{

/// Adds the options of the box that is merged again in finer voxels: --box and --follow-from.
void AddBoxOptions(CLI::App& command, std::optional<BoxRequest>& box);

} // namespace nexrad::application
