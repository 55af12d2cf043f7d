// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Archives/TarHeader.h"

#include <algorithm>
#include <cstdlib>

namespace nexrad
{

namespace
{

constexpr std::uint64_t largestSize = std::uint64_t(1) << 62;

// A text that fills its field, or ends with a zero byte.
std::string TextAt(ByteView block, std::size_t offset, std::size_t size)
{
  const ByteView field = block.Sub(offset, size);
  return {field.Data(), std::find(field.Data(), field.Data() + field.Size(), 0)};
}

// Digits to a base, after and before spaces and zero bytes; empty for anything else.
std::optional<std::uint64_t> ParseDigits(const std::string& text, unsigned base)
{
  const std::size_t begin = std::min(text.find_first_not_of(' '), text.size());
  const std::size_t end = std::min(text.find(' ', begin), text.size());
  std::uint64_t value = 0;
  for (std::size_t place = begin; place < end; ++place)
  {
    const unsigned digit = static_cast<unsigned char>(text[place]) - unsigned('0');
    if (digit >= base || value > largestSize / base)
    {
      return std::nullopt;
    }
    value = value * base + digit;
  }
  return value <= largestSize ? std::optional(value) : std::nullopt;
}

// Octal digits; or, with the first bit set, a number to the base of 256 (GNU, star).
std::optional<std::uint64_t> ParseNumber(ByteView block, std::size_t offset, std::size_t size)
{
  constexpr unsigned binaryMark = 0x80;
  if ((block.U8(offset) & binaryMark) == 0)
  {
    return ParseDigits(TextAt(block, offset, size), 8);
  }
  std::uint64_t value = block.U8(offset) & ~binaryMark; // 0x7F for negative numbers: too large
  for (std::size_t place = offset + 1; place < offset + size; ++place)
  {
    if (value > largestSize >> 8)
    {
      return std::nullopt;
    }
    value = value << 8 | block.U8(place);
  }
  return value <= largestSize ? std::optional(value) : std::nullopt;
}

// The sum of the bytes, with spaces in place of the sum itself. Some old systems took bytes as
// signed.
bool HasItsCheckSum(ByteView block)
{
  constexpr std::size_t place = 148;
  constexpr std::size_t size = 8;
  const auto stated = ParseNumber(block, place, size);
  std::int64_t sum = 0;
  std::int64_t ofSigned = 0;
  for (std::size_t offset = 0; offset < tarBlockBytes; ++offset)
  {
    const bool isSum = offset >= place && offset < place + size;
    const std::uint8_t byte = isSum ? std::uint8_t(' ') : block.U8(offset);
    sum += byte;
    ofSigned += static_cast<std::int8_t>(byte);
  }
  const auto is = [&stated](std::int64_t value)
  { return value > 0 && stated == static_cast<std::uint64_t>(value); };
  return is(sum) || is(ofSigned);
}

} // namespace

std::optional<TarHeader> ParseTarHeader(ByteView block)
{
  if (block.Size() < tarBlockBytes || !HasItsCheckSum(block))
  {
    return std::nullopt;
  }
  const auto size = ParseNumber(block, 124, 12);
  if (!size)
  {
    return std::nullopt;
  }
  TarHeader header;
  header.name = TextAt(block, 0, 100);
  header.size = *size;
  header.type = static_cast<char>(block.U8(156));
  // GNU's own format, "ustar" and two spaces, has other things in place of the first part.
  const std::string prefix =
    block.StartsWith("ustar", 257) && block.U8(262) == 0 ? TextAt(block, 345, 155) : "";
  header.name = prefix.empty() ? header.name : prefix + '/' + header.name;
  return header;
}

TarExtension ParseTarExtension(const std::string& records)
{
  constexpr std::size_t mostDigits = 7;
  TarExtension extension;
  std::size_t begin = 0;
  while (begin < records.size())
  {
    const std::size_t space = records.find(' ', begin);
    const auto length = space - begin <= mostDigits && space > begin
                          ? ParseDigits(records.substr(begin, space - begin), 10)
                          : std::nullopt;
    if (!length || *length > records.size() - begin || *length < space - begin + 2)
    {
      break;
    }
    const std::string record = records.substr(space + 1, begin + *length - space - 2);
    const std::size_t equals = std::min(record.find('='), record.size());
    const std::string key = record.substr(0, equals);
    const std::string value = equals < record.size() ? record.substr(equals + 1) : "";
    if (key == "path")
    {
      extension.name = value;
    }
    else if (key == "size")
    {
      extension.size = ParseDigits(value, 10);
    }
    extension.sparse = extension.sparse || key.rfind("GNU.sparse.", 0) == 0;
    begin += *length;
  }
  return extension;
}

} // namespace nexrad
