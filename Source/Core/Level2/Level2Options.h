// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/DecodingBudget.h"
#include "nexrad/Model/Site.h"

#include <cstddef>
#include <optional>
#include <string>

namespace nexrad
{

/// What the reader may assume, and how much memory a file may take.
struct Level2Options
{
  std::string siteName;             ///< replaces the name in the file when not empty
  std::optional<Position> position; ///< replaces the position in the file
  std::size_t maximumRecordBytes = std::size_t(64) << 20; ///< cap of one decompressed LDM record
  std::size_t maximumFileBytes = std::size_t(1) << 30;    ///< cap of one file, and of its decoding
  std::size_t freeBytes = DecodingBudget::FreeBytes; ///< that decoding may cost whatever is stored
  unsigned threads = 0; ///< that decompress the records of one file; 0: as many as there are cores
};

} // namespace nexrad
