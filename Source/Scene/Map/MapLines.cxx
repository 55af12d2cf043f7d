// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapLines.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cstring>
#include <string>

namespace nexrad::embedded
{
extern const unsigned char mapLines[];
extern const std::size_t mapLinesSize;
} // namespace nexrad::embedded

namespace nexrad::scene
{
namespace
{

constexpr char magic[] = "NXMAP1\n";
constexpr std::size_t magicLength = sizeof(magic) - 1;

class ByteReader
{
public:
  ByteReader(const unsigned char* first, std::size_t count)
    : bytes(first)
    , size(count)
  {
  }

  [[noreturn]] void Fail(const std::string& what) const
  {
    throw Error("map lines: offset " + std::to_string(offset) + ": " + what);
  }

  unsigned char Byte()
  {
    if (offset == size)
    {
      this->Fail("the file ends within a line");
    }
    return bytes[offset++];
  }

  // Seven bits a byte, the lowest first; the top bit says that more follow.
  std::uint32_t Unsigned()
  {
    std::uint32_t value = 0;
    for (int shift = 0; shift < 28; shift += 7)
    {
      const unsigned char byte = this->Byte();
      value |= static_cast<std::uint32_t>(byte & 0x7f) << shift;
      if ((byte & 0x80) == 0)
      {
        return value;
      }
    }
    this->Fail("a number has more than 28 bits");
  }

  // 0, -1, 1, -2, 2, … are stored as 0, 1, 2, 3, 4, …
  std::int32_t Signed()
  {
    const std::uint32_t stored = this->Unsigned();
    const auto half = static_cast<std::int32_t>(stored >> 1);
    return (stored & 1) != 0 ? -half - 1 : half;
  }

  void SkipMagic()
  {
    if (size < magicLength || std::memcmp(bytes, magic, magicLength) != 0)
    {
      this->Fail("not a file of map lines (no NXMAP1)");
    }
    offset = magicLength;
  }

  std::size_t Remaining() const { return size - offset; }

private:
  const unsigned char* bytes;
  std::size_t size;
  std::size_t offset = 0;
};

MapLine ReadLine(ByteReader& reader, double degreesPerUnit)
{
  const unsigned char kind = reader.Byte();
  if (kind > static_cast<unsigned char>(MapLineKind::County))
  {
    reader.Fail("unknown kind of line " + std::to_string(kind));
  }
  MapLine line;
  line.kind = static_cast<MapLineKind>(kind);
  const std::uint32_t count = reader.Unsigned();
  // A point takes two bytes at least, which bounds the memory by the size of the file.
  if (count < 2 || count > reader.Remaining() / 2)
  {
    reader.Fail("a line of " + std::to_string(count) + " points");
  }
  line.points.reserve(count);
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    x += reader.Signed();
    y += reader.Signed();
    line.points.push_back(
      {static_cast<double>(x) * degreesPerUnit, static_cast<double>(y) * degreesPerUnit});
  }
  return line;
}

} // namespace

std::vector<MapLine> ParseMapLines(const unsigned char* bytes, std::size_t size)
{
  ByteReader reader(bytes, size);
  reader.SkipMagic();
  const std::uint32_t unitsPerDegree = reader.Unsigned();
  if (unitsPerDegree == 0)
  {
    reader.Fail("no units in a degree");
  }
  const std::uint32_t count = reader.Unsigned();
  std::vector<MapLine> lines;
  lines.reserve(std::min<std::size_t>(count, reader.Remaining() / 6));
  for (std::uint32_t i = 0; i < count; ++i)
  {
    lines.push_back(ReadLine(reader, 1.0 / unitsPerDegree));
  }
  if (reader.Remaining() != 0)
  {
    reader.Fail("bytes after the last line");
  }
  return lines;
}

const std::vector<MapLine>& EmbeddedMapLines()
{
  static const std::vector<MapLine> lines =
    ParseMapLines(embedded::mapLines, embedded::mapLinesSize);
  return lines;
}

} // namespace nexrad::scene
