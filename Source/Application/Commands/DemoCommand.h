// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d demo DIR`: simulates an hour of three radars, merges it and draws it.
void AddDemoCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
