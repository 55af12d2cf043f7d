// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvBricks.h"
#include "nexrad/Codec/NxvHeader.h"

#include <filesystem>

namespace nexrad
{

/// Writes a volume file under a temporary name and renames it. Throws Error when it cannot be
/// written, or its header would be too long.
void WriteNxvFile(
  const std::filesystem::path& path, const NxvHeader& header, const NxvPayload& payload);

} // namespace nexrad
