// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapBytes.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace nexrad::scene
{
namespace
{

MapPolyline ReadLine(MapBytes& bytes, std::uint8_t kinds, double degreesPerUnit)
{
  MapPolyline line;
  line.kind = bytes.Byte();
  if (line.kind >= kinds)
  {
    bytes.Fail("unknown kind of line " + std::to_string(line.kind));
  }
  const std::uint32_t count = bytes.Unsigned();
  // A point takes two bytes at least, which bounds the memory by the size of the file.
  if (count < 2 || count > bytes.Remaining() / 2)
  {
    bytes.Fail("a line of " + std::to_string(count) + " points");
  }
  line.points.reserve(count);
  std::int64_t x = 0;
  std::int64_t y = 0;
  for (std::uint32_t i = 0; i < count; ++i)
  {
    x += bytes.Signed();
    y += bytes.Signed();
    line.points.push_back(
      {static_cast<double>(x) * degreesPerUnit, static_cast<double>(y) * degreesPerUnit});
  }
  return line;
}

} // namespace

MapBytes::MapBytes(const unsigned char* first, std::size_t count, std::string name)
  : bytes(first)
  , size(count)
  , file(std::move(name))
{
}

void MapBytes::Fail(const std::string& what) const
{
  throw Error(file + ": offset " + std::to_string(offset) + ": " + what);
}

void MapBytes::SkipMagic(const std::string& magic)
{
  if (size < magic.size() || std::memcmp(bytes, magic.data(), magic.size()) != 0)
  {
    this->Fail("the file does not begin with " + magic.substr(0, magic.size() - 1));
  }
  offset = magic.size();
}

unsigned char MapBytes::Byte()
{
  if (offset == size)
  {
    this->Fail("the file ends too early");
  }
  return bytes[offset++];
}

std::uint32_t MapBytes::Unsigned()
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

std::int32_t MapBytes::Signed()
{
  const std::uint32_t stored = this->Unsigned();
  const auto half = static_cast<std::int32_t>(stored >> 1);
  return (stored & 1) != 0 ? -half - 1 : half;
}

std::vector<MapPolyline> ReadMapPolylines(
  MapBytes bytes, const std::string& magic, std::uint8_t kinds)
{
  bytes.SkipMagic(magic);
  const std::uint32_t unitsPerDegree = bytes.Unsigned();
  if (unitsPerDegree == 0)
  {
    bytes.Fail("no units in a degree");
  }
  const std::uint32_t count = bytes.Unsigned();
  std::vector<MapPolyline> lines;
  lines.reserve(std::min<std::size_t>(count, bytes.Remaining() / 6));
  for (std::uint32_t i = 0; i < count; ++i)
  {
    lines.push_back(ReadLine(bytes, kinds, 1.0 / unitsPerDegree));
  }
  if (bytes.Remaining() != 0)
  {
    bytes.Fail("bytes after the last line");
  }
  return lines;
}

} // namespace nexrad::scene
