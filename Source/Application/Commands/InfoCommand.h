// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// Adds `info FILE…`: says what is in Level II files and folders of chunks, as a table or as JSON.
/// Damage goes to standard error, one line each: "file: offset N: what".
void AddInfoCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
