// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d grid INPUT… -o DIR`: radar files of any number of sites to one merged volume for each
/// time step.
void AddGridCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
