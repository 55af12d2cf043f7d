// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// nexrad3d wind FILE…: the wind profile of each volume, as a table or JSON.
void AddWindCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
