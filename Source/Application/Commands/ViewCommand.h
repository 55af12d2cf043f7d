// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d view`: a window on volumes or radar files.
void AddViewCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
