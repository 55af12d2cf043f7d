// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/InputSeries.h"

namespace CLI
{
class App;
}

namespace nexrad::application
{

/// Adds the options of the box that is merged again in finer voxels: --box and --follow-from.
void AddBoxOptions(CLI::App& command, InputRequest& request);

} // namespace nexrad::application
