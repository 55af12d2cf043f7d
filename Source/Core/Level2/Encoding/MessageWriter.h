// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace nexrad
{

/// Appends big-endian numbers to bytes.
class BigEndianWriter
{
public:
  void Put8(unsigned value) { bytes.push_back(static_cast<std::uint8_t>(value)); }
  void Put16(unsigned value)
  {
    this->Put8(value >> 8 & 0xffU);
    this->Put8(value & 0xffU);
  }
  /// Two's complement of a negative number.
  void PutSigned16(int value) { this->Put16(static_cast<unsigned>(value) & 0xffffU); }
  void Put32(std::uint32_t value)
  {
    this->Put16(value >> 16);
    this->Put16(value & 0xffffU);
  }
  void PutFloat(float value)
  {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    this->Put32(bits);
  }
  /// The text's bytes, followed by blanks up to `size`.
  void PutText(std::string_view text, std::size_t size)
  {
    for (std::size_t index = 0; index < size; ++index)
    {
      this->Put8(index < text.size() ? static_cast<unsigned char>(text[index]) : ' ');
    }
  }
  void PutZeros(std::size_t count) { bytes.insert(bytes.end(), count, 0); }
  void PutBytes(const std::uint8_t* first, std::size_t count)
  {
    bytes.insert(bytes.end(), first, first + count);
  }
  /// Zeros up to a size.
  void PadTo(std::size_t size)
  {
    if (bytes.size() < size)
    {
      bytes.resize(size, 0);
    }
  }

  std::size_t Size() const { return bytes.size(); }
  const std::vector<std::uint8_t>& Bytes() const { return bytes; }
  std::vector<std::uint8_t> Take() { return std::move(bytes); }

private:
  std::vector<std::uint8_t> bytes;
};

/// One message with its CTM header, as it stands in a Level II file.
using MessageBytes = std::vector<std::uint8_t>;

/// A Level II date (days, 1 on 1970-01-01) and milliseconds after midnight: the inverse of
/// FromLevel2Date. Throws Error before 1970 or after the dates of 16 bits.
struct Level2Date
{
  std::uint32_t days = 1;
  std::uint32_t milliseconds = 0;
};
Level2Date ToLevel2Date(Time time);

/// The metadata that begins a file: 134 frames, of which the last hold the mark of a synthetic
/// volume, message 5 and message 2; the others are empty.
MessageBytes WriteMetadata(const RadarVolume& volume, Time start);

/// One ray as message 1 (`sequence` counts the messages, `index` the rays of the sweep, from 0).
/// Throws Error for what message 1 cannot hold.
MessageBytes WriteMessage1(
  const RadarVolume& volume, const Ray& ray, unsigned index, unsigned sequence);

/// One ray as message 31. Throws Error for what it cannot hold, and without a position.
MessageBytes WriteMessage31(
  const RadarVolume& volume, const Sweep& sweep, unsigned index, unsigned sequence);

} // namespace nexrad
