// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// Adds the options of `nexrad3d bench`, which measures decoding, merging, drawing and the sizes of
/// volumes on this machine, and prints the tables of the thesis's chapter 4 with its figures
/// beside.
void AddBenchOptions(CLI::App& command, CommandAction& action);

} // namespace nexrad::application
