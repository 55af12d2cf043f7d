// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d watch FOLDER… -o DIR`: folders into which volumes or chunks arrive to the newest
/// merged volume, its picture and a series that grows.
void AddWatchCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
