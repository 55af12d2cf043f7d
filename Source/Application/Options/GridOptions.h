// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/MergeSettings.h"

#include <vector>

namespace CLI
{
class App;
}

namespace nexrad::application
{

/// Adds the options of merging to a command: those of MergeSettings that the program has. They
/// store into `options`, which must outlive the parsing.
void AddGridOptions(CLI::App& command, MergeOptions& options);

/// Those options of merging that a command was given, as they were written.
std::vector<OptionText> GivenGridOptions(const CLI::App& command);

} // namespace nexrad::application
