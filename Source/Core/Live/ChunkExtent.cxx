// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/ChunkExtent.h"

#include "nexrad/Compression/LdmRecords.h"
#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <cstdint>
#include <cstdlib>

namespace nexrad
{

namespace
{

struct Records
{
  ChunkExtent extent = ChunkExtent::Unknown;
  bool lastIsMarked = false; ///< the length of the last record is negative
};

// Walks over the records by their lengths.
Records WalkRecords(ByteView stored)
{
  constexpr std::size_t lengthBytes = 4;
  constexpr std::size_t signature = 14; // a length, and what begins a bzip2 stream
  std::size_t position = IsVolumeHeader(stored, 0) ? VolumeHeader::bytes : 0;
  if (stored.Size() < position + signature)
  {
    return {position == 0 ? ChunkExtent::Cut : ChunkExtent::Unknown, false};
  }
  Records records;
  while (position < stored.Size())
  {
    if (stored.Size() - position < signature)
    {
      return {ChunkExtent::Cut, false};
    }
    if (!IsLdmRecord(stored, position))
    {
      return {ChunkExtent::Unknown, false};
    }
    const std::int64_t length = stored.I32(position);
    const auto bytes = static_cast<std::size_t>(std::abs(length));
    if (!stored.Has(position + lengthBytes, bytes))
    {
      return {ChunkExtent::Cut, false};
    }
    records.lastIsMarked = length < 0;
    position += lengthBytes + bytes;
  }
  records.extent = ChunkExtent::Whole;
  return records;
}

} // namespace

ChunkExtent ExtentOfChunk(ByteView stored)
{
  return WalkRecords(stored).extent;
}

ChunkExtent ExtentOfFile(ByteView stored)
{
  const Records records = WalkRecords(stored);
  return records.extent == ChunkExtent::Whole && !records.lastIsMarked ? ChunkExtent::Unknown
                                                                       : records.extent;
}

} // namespace nexrad
