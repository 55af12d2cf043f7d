// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d simulate DIR`: the synthetic storm day as Level II files.
void AddSimulateCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
