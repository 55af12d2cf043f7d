// SPDX-License-Identifier: BSD-3-Clause
#include "Level2/LdmRecords.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace nexrad
{

namespace
{

constexpr std::size_t lengthBytes = 4;
// "BZh", the block size as a digit, and the six bytes that begin a block.
constexpr std::size_t signatureBytes = 10;

std::size_t FindNext(ByteView bytes, std::size_t from)
{
  for (std::size_t offset = from; bytes.Has(offset, lengthBytes + signatureBytes); ++offset)
  {
    if (IsLdmRecord(bytes, offset))
    {
      return offset;
    }
  }
  return bytes.Size();
}

bool IsPadding(ByteView rest)
{
  return std::all_of(rest.Data(), rest.Data() + rest.Size(), [](auto byte) { return byte == 0; });
}

} // namespace

bool IsLdmRecord(ByteView bytes, std::size_t offset)
{
  const std::size_t stream = offset + lengthBytes;
  return bytes.Has(offset, lengthBytes + signatureBytes) && bytes.StartsWith("BZh", stream) &&
         bytes.U8(stream + 3) >= '1' && bytes.U8(stream + 3) <= '9' &&
         bytes.StartsWith("1AY&SY", stream + 4);
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
      const std::size_t next = FindNext(bytes, position + 1);
      damage.push_back(
        {position, std::to_string(next - position) + " bytes that are no compressed record"});
      position = next;
      continue;
    }
    const std::int64_t stated = std::abs(std::int64_t(bytes.I32(position)));
    const std::size_t available = bytes.Size() - position - lengthBytes;
    auto length = static_cast<std::size_t>(stated);
    const std::size_t end = position + lengthBytes + length;
    if (length > available || (end < bytes.Size() && !IsLdmRecord(bytes, end)))
    {
      // Either this length or what follows is wrong; a record that begins before its end tells.
      const std::size_t next = FindNext(bytes, position + lengthBytes);
      if (length > available || next < end)
      {
        length = next - position - lengthBytes;
        damage.push_back(
          {position, "the record should be " + std::to_string(stated) + " bytes long, but only " +
                       std::to_string(length) + " are there"});
      }
    }
    records.push_back({position, bytes.Sub(position + lengthBytes, length)});
    position += lengthBytes + length;
  }
  return records;
}

} // namespace nexrad
