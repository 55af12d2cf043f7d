// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeOptions.h"

namespace CLI
{
class App;
}

namespace nexrad::application
{

/// Adds the options of merging to a command, all in one group of its help. They store into
/// `options`, which must outlive the parsing.
void AddGridOptions(CLI::App& command, MergeOptions& options);

} // namespace nexrad::application
