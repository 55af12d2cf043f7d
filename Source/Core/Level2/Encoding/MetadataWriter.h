// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/Encoding/MessageWriter.h"
#include "nexrad/Model/RadarVolume.h"

#include <vector>

namespace nexrad
{

/// The metadata that begins a file: 134 frames, of which the last hold the mark of a synthetic
/// volume, message 5 and message 2; the others are empty.
std::vector<MessageBytes> WriteMetadata(const RadarVolume& volume, Time start);

} // namespace nexrad
