// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Level2File.h"

#include <string>

namespace nexrad::application
{

/// A volume with every ray of a file (or a folder of chunks) that can be read; its damage is
/// written to standard error, a line each. What cannot be read at all comes back as a volume
/// without sweeps whose damage is the reason, so that each file has its place in the output.
RadarVolume ReadOrExplain(const std::string& file, const Level2Options& options = {});

} // namespace nexrad::application
