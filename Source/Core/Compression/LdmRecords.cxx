// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/LdmRecords.h"

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

// The bytes without the zeros at their end.
std::size_t SizeWithoutPadding(ByteView bytes)
{
  std::size_t size = bytes.Size();
  while (size > 0 && bytes.Data()[size - 1] == 0)
  {
    --size;
  }
  return size;
}

// Walks over records once; each step costs no more than the bytes that it passes.
class RecordFinder
{
public:
  RecordFinder(ByteView allBytes, const DamageReceiver& receiver)
    : bytes(allBytes)
    , used(SizeWithoutPadding(allBytes))
    , report(receiver)
  {
  }

  std::vector<LdmRecord> FindFrom(std::size_t position)
  {
    std::vector<LdmRecord> records;
    while (position < used)
    {
      if (!IsLdmRecord(bytes, position))
      {
        const std::size_t next = FindLdmRecord(bytes, position + 1);
        report(position, std::to_string(next - position) + " bytes that are no compressed record");
        position = next;
        continue;
      }
      if (records.size() == MostLdmRecords)
      {
        report(position,
          "more than " + std::to_string(MostLdmRecords) + " compressed records; the rest is left");
        break;
      }
      const std::size_t stream = position + lengthBytes;
      const std::size_t length = this->LengthAt(position);
      records.push_back({position, bytes.Sub(stream, length)});
      position = stream + length;
    }
    return records;
  }

private:
  // Bytes of the stream of the record at `position`.
  std::size_t LengthAt(std::size_t position) const
  {
    const std::int64_t stated = std::abs(std::int64_t(bytes.I32(position)));
    const std::size_t stream = position + lengthBytes;
    if (this->IsRecordEnd(stream, static_cast<std::size_t>(stated)))
    {
      return static_cast<std::size_t>(stated);
    }
    // The stream knows its own end; all bytes up to the next record may belong to it.
    const std::size_t length = FindLdmRecord(bytes, stream) - stream;
    report(position, "the record says that it is " + std::to_string(stated) + " bytes long, but " +
                       std::to_string(length) + " bytes are there");
    return length;
  }

  // True when a stream of that length is followed by a record, by nothing, or by padding.
  bool IsRecordEnd(std::size_t stream, std::size_t length) const
  {
    return length > 0 && bytes.Has(stream, length) &&
           (IsLdmRecord(bytes, stream + length) || stream + length >= used);
  }

  ByteView bytes;
  std::size_t used; // bytes before the padding at the end
  const DamageReceiver& report;
};

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
  ByteView bytes, std::size_t start, const DamageReceiver& report)
{
  return RecordFinder(bytes, report).FindFrom(start);
}

} // namespace nexrad
