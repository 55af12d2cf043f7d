// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"

namespace nexrad
{

/// Whether all bytes of a file that is being written have arrived.
enum class ChunkExtent
{
  Whole,  ///< the lengths in it say so
  Cut,    ///< the lengths in it say that more follows
  Unknown ///< nothing in it says how long it is
};

/// What the lengths of the compressed records of a chunk say of its stored bytes.
ChunkExtent ExtentOfChunk(ByteView stored);

/// The same of a file of a whole volume. The length of its last record is negative; without one it
/// is Cut or Unknown.
ChunkExtent ExtentOfFile(ByteView stored);

} // namespace nexrad
