// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Model/CoveragePattern.h"

#include <optional>

namespace nexrad
{

/// Reads the body of message 5, the volume coverage pattern (ICD 2620002, table XI). Empty when the
/// message holds none: before 2006 it was sent filled with zeros.
std::optional<CoveragePattern> DecodeMessage5(ByteView body);

} // namespace nexrad
