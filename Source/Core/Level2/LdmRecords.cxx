// SPDX-License-Identifier: BSD-3-Clause
#include "Level2/LdmRecords.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>

namespace nexrad
{

namespace
{

constexpr std::size_t lengthBytes = 4;
// "BZh", the block size as a digit, and the six bytes that begin a block.
constexpr std::size_t signatureBytes = 10;
constexpr std::string_view blockMagic = "1AY&SY";

bool IsPadding(ByteView rest)
{
  return std::all_of(rest.Data(), rest.Data() + rest.Size(), [](auto byte) { return byte == 0; });
}

// True when a stream of that length is followed by a record, by nothing, or by padding.
bool IsRecordEnd(ByteView bytes, std::size_t stream, std::size_t length)
{
  return length > 0 && bytes.Has(stream, length) &&
         (IsLdmRecord(bytes, stream + length) || IsPadding(bytes.Sub(stream + length)));
}

} // namespace

bool IsLdmRecord(ByteView bytes, std::size_t offset)
{
  const std::size_t stream = offset + lengthBytes;
  return bytes.Has(offset, lengthBytes + signatureBytes) && bytes.StartsWith("BZh", stream) &&
         bytes.U8(stream + 3) >= '1' && bytes.U8(stream + 3) <= '9' &&
         bytes.StartsWith(blockMagic.data(), stream + 4);
}

std::size_t FindLdmRecord(ByteView bytes, std::size_t from)
{
  // A whole file may be searched in vain, so the search leaps.
  constexpr std::size_t magicPlace = lengthBytes + 4;
  static const std::boyer_moore_horspool_searcher searcher(blockMagic.begin(), blockMagic.end());
  const std::uint8_t* const end = bytes.Data() + bytes.Size();
  const ByteView rest = bytes.Sub(from).Sub(magicPlace);
  for (const std::uint8_t* place = rest.Data();; ++place)
  {
    place = std::search(place, end, searcher);
    if (place == end)
    {
      return bytes.Size();
    }
    const auto offset = static_cast<std::size_t>(place - bytes.Data()) - magicPlace;
    if (IsLdmRecord(bytes, offset))
    {
      return offset;
    }
  }
}

std::vector<LdmRecord> FindLdmRecords(
  ByteView bytes, std::size_t start, std::vector<Damage>& damage)
{
  std::vector<LdmRecord> records;
  std::size_t position = start;
  while (position < bytes.Size() && !IsPadding(bytes.Sub(position)))
  {
    if (!IsLdmRecord(bytes, position))
    {
      const std::size_t next = FindLdmRecord(bytes, position + 1);
      damage.push_back(
        {position, std::to_string(next - position) + " bytes that are no compressed record"});
      position = next;
      continue;
    }
    const std::int64_t stated = std::abs(std::int64_t(bytes.I32(position)));
    const std::size_t stream = position + lengthBytes;
    auto length = static_cast<std::size_t>(stated);
    if (!IsRecordEnd(bytes, stream, length))
    {
      // The stream knows its own end; all bytes up to the next record may belong to it.
      length = FindLdmRecord(bytes, stream) - stream;
      damage.push_back(
        {position, "the record says that it is " + std::to_string(stated) + " bytes long, but " +
                     std::to_string(length) + " bytes are there"});
    }
    records.push_back({position, bytes.Sub(stream, length)});
    position = stream + length;
  }
  return records;
}

} // namespace nexrad
