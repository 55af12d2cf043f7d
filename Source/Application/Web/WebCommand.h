// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d web VOLUMES -o storm.html`: volumes, or radar files, to a page that a browser turns
/// and plays.
void AddWebCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
