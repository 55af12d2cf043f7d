// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/VolumeCut.h"

namespace CLI
{
class App;
}

namespace nexrad::application
{

/// --crop and --clip: which part of the volume is drawn.
void AddCuttingOptions(CLI::App& command, scene::CutOptions& cut);

} // namespace nexrad::application
