// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Model/RadarVolume.h"

#include <optional>

namespace nexrad
{

/// Reads the body of message 2, what the radar says of itself (ICD 2620002, table IV). Empty when
/// the body is too short.
std::optional<RadarStatus> DecodeMessage2(ByteView body);

} // namespace nexrad
