// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Commands/Command.h"

namespace nexrad::application
{

/// `nexrad3d render INPUT… -o out.png`: volumes, or radar files, to pictures or a movie.
void AddRenderCommand(CLI::App& program, CommandAction& action);

} // namespace nexrad::application
