// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>

namespace nexrad
{

/// Bytes that somebody else owns, read as the big-endian numbers of Level II. Offsets are in bytes
/// from the start of the view. A read that does not lie within the view throws std::out_of_range,
/// so no offset from a file needs to be trusted.
class ByteView
{
public:
  ByteView() = default;
  ByteView(const std::uint8_t* data, std::size_t size)
    : first(data)
    , length(size)
  {
  }

  const std::uint8_t* Data() const { return first; }
  std::size_t Size() const { return length; }

  /// True when `count` bytes lie at `offset`.
  bool Has(std::size_t offset, std::size_t count) const
  {
    return offset <= length && count <= length - offset;
  }
  /// The `count` bytes at `offset`, fewer where the view ends; empty behind its end.
  ByteView Sub(std::size_t offset, std::size_t count = SIZE_MAX) const
  {
    const std::size_t start = offset < length ? offset : length;
    return {first + start, count < length - start ? count : length - start};
  }
  /// True when the text, without its closing zero, stands at `offset`.
  bool StartsWith(const char* text, std::size_t offset = 0) const
  {
    const std::size_t count = std::strlen(text);
    return this->Has(offset, count) && std::memcmp(first + offset, text, count) == 0;
  }

  std::uint8_t U8(std::size_t offset) const { return *this->At(offset, 1); }
  std::uint16_t U16(std::size_t offset) const
  {
    const std::uint8_t* bytes = this->At(offset, 2);
    return static_cast<std::uint16_t>(bytes[0] << 8 | bytes[1]);
  }
  std::int16_t I16(std::size_t offset) const
  {
    return static_cast<std::int16_t>(this->U16(offset));
  }
  std::uint32_t U32(std::size_t offset) const
  {
    return static_cast<std::uint32_t>(this->U16(offset)) << 16 | this->U16(offset + 2);
  }
  std::int32_t I32(std::size_t offset) const
  {
    return static_cast<std::int32_t>(this->U32(offset));
  }
  float F32(std::size_t offset) const
  {
    const std::uint32_t bits = this->U32(offset);
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }

private:
  const std::uint8_t* At(std::size_t offset, std::size_t count) const
  {
    if (!this->Has(offset, count))
    {
      throw std::out_of_range("read past the end");
    }
    return first + offset;
  }

  const std::uint8_t* first = nullptr;
  std::size_t length = 0;
};

} // namespace nexrad
