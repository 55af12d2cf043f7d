// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/Container.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

namespace nexrad
{

/// Fills the target with the next stored bytes, at most `size`, and returns their number: 0 at the
/// end.
using PieceReader = std::function<std::size_t(std::uint8_t* target, std::size_t size)>;

/// Takes the next decompressed bytes.
using PieceReceiver = std::function<void(const std::uint8_t* data, std::size_t size)>;

/// Decompresses a stream, or streams of one format end to end, in pieces of 64 KiB: for files that
/// are too large for memory. Only a stream of compress is read as a whole first. Stops after
/// `maximumBytes`. Returns what is wrong with the stream in one line; "" when it is whole.
std::string UnpackInPieces(StreamFormat format, const PieceReader& read,
  const PieceReceiver& receive, std::uint64_t maximumBytes);

} // namespace nexrad
