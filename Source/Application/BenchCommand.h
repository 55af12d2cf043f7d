// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d bench`: measures decoding, merging and the sizes of volumes on this machine, and
/// prints the tables of the thesis's chapter 4 with its figures beside.
void AddBenchCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
