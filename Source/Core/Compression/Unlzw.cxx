// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/Unlzw.h"

#include <algorithm>

namespace nexrad
{

namespace
{

constexpr std::size_t headerSize = 3;
constexpr unsigned firstWidth = 9;
constexpr unsigned lastWidth = 16;
constexpr unsigned clearCode = 256;
constexpr std::size_t checkpointDistance = 65536;

// Reads codes. A writer fills its output eight codes at a time: whenever the width changes or the
// table is cleared, the rest of the current group of eight is padding.
class CodeReader
{
public:
  explicit CodeReader(ByteView codes)
    : view(codes)
  {
  }

  bool Next(unsigned& code)
  {
    const std::size_t end = bit + width;
    if ((end + 7) / 8 > view.Size())
    {
      return false;
    }
    unsigned value = 0;
    for (std::size_t byte = bit / 8, shift = 0; byte * 8 < end; ++byte, shift += 8)
    {
      value |= static_cast<unsigned>(view.U8(byte)) << shift;
    }
    code = value >> bit % 8 & ((1U << width) - 1);
    bit = end;
    return true;
  }
  void SetWidth(unsigned bits)
  {
    const std::size_t group = std::size_t(width) * 8;
    bit = groupStart + (bit - groupStart + group - 1) / group * group;
    groupStart = bit;
    width = bits;
  }
  unsigned Width() const { return width; }
  std::size_t ByteOffset() const { return bit / 8; }

private:
  ByteView view;
  unsigned width = firstWidth;
  std::size_t bit = 0;
  std::size_t groupStart = 0;
};

// Every entry is the string of an earlier code and one byte more.
class StringTable
{
public:
  StringTable(unsigned firstFreeCode, unsigned maximumWidth)
    : prefix(std::size_t(1) << maximumWidth)
    , suffix(std::size_t(1) << maximumWidth)
    , firstFree(firstFreeCode)
    , free(firstFreeCode)
  {
  }

  unsigned Free() const { return free; }
  void Clear() { free = firstFree; }
  void Add(unsigned code, std::uint8_t byte)
  {
    if (free < prefix.size())
    {
      prefix[free] = static_cast<std::uint16_t>(code);
      suffix[free] = byte;
      ++free;
    }
  }
  // Appends the string of a code that is in the table; returns its first byte.
  std::uint8_t Append(unsigned code, std::vector<std::uint8_t>& out)
  {
    const std::size_t start = out.size();
    for (; code >= clearCode; code = prefix[code])
    {
      out.push_back(suffix[code]);
    }
    out.push_back(static_cast<std::uint8_t>(code));
    std::reverse(out.begin() + static_cast<std::ptrdiff_t>(start), out.end());
    return out[start];
  }

private:
  std::vector<std::uint16_t> prefix;
  std::vector<std::uint8_t> suffix;
  unsigned firstFree;
  unsigned free;
};

class Decoder
{
public:
  Decoder(ByteView stored, std::size_t maximumBytes)
    : reader(stored.Sub(headerSize))
    , table((stored.U8(2) & 0x80) != 0 ? clearCode + 1 : clearCode, stored.U8(2) & 0x1F)
    , clears((stored.U8(2) & 0x80) != 0)
    , maximumWidth(stored.U8(2) & 0x1F)
    , maximum(maximumBytes)
  {
  }

  Unpacked Run()
  {
    result.offsets.Add(0, 0);
    for (unsigned code = 0; result.problem.empty() && reader.Next(code);)
    {
      this->Checkpoint();
      if (code == clearCode && clears)
      {
        reader.SetWidth(firstWidth);
        table.Clear();
        hasPrevious = false;
      }
      else
      {
        this->Emit(code);
      }
    }
    result.used = headerSize + reader.ByteOffset();
    return std::move(result);
  }

private:
  void Emit(unsigned code)
  {
    // The code about to be defined may be used at once: the previous string and its first byte.
    const bool defined =
      code < clearCode || (code < table.Free() && !(clears && code == clearCode));
    if (!defined && !(hasPrevious && code == table.Free()))
    {
      result.problem =
        "code " + std::to_string(code) + " of the compress stream is not in its table";
      return;
    }
    const std::uint8_t first = table.Append(defined ? code : previous, result.bytes);
    if (!defined)
    {
      result.bytes.push_back(first);
    }
    if (hasPrevious)
    {
      table.Add(previous, first);
    }
    previous = code;
    hasPrevious = true;
    if (result.bytes.size() > maximum)
    {
      result.bytes.resize(maximum);
      result.problem = "more than " + std::to_string(maximum) + " bytes when decompressed";
      return;
    }
    if (table.Free() == 1U << reader.Width() && reader.Width() < maximumWidth)
    {
      reader.SetWidth(reader.Width() + 1);
    }
  }
  void Checkpoint()
  {
    if (result.bytes.size() >= nextCheckpoint)
    {
      result.offsets.Add(result.bytes.size(), headerSize + reader.ByteOffset());
      nextCheckpoint = result.bytes.size() + checkpointDistance;
    }
  }

  CodeReader reader;
  StringTable table;
  bool clears;
  unsigned maximumWidth;
  std::size_t maximum;
  std::size_t nextCheckpoint = checkpointDistance;
  unsigned previous = 0;
  bool hasPrevious = false;
  Unpacked result;
};

} // namespace

Unpacked Unlzw(ByteView stored, std::size_t maximumBytes)
{
  if (stored.Size() < headerSize || (stored.U8(2) & 0x1F) < firstWidth ||
      (stored.U8(2) & 0x1F) > lastWidth)
  {
    Unpacked nothing;
    nothing.problem = "the header of the compress stream is damaged";
    return nothing;
  }
  return Decoder(stored, maximumBytes).Run();
}

} // namespace nexrad
