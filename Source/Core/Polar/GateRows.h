// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

namespace nexrad
{

/// Gates from `begin` up to, but not including, `end`.
struct GateRange
{
  std::size_t begin = 0;
  std::size_t end = 0;

  bool IsEmpty() const { return begin >= end; }
  std::size_t Size() const { return this->IsEmpty() ? 0 : end - begin; }
  bool Holds(std::size_t gate) const { return gate >= begin && gate < end; }
};

/// The gates of both ranges.
inline GateRange Common(const GateRange& a, const GateRange& b)
{
  return {std::max(a.begin, b.begin), std::min(a.end, b.end)};
}

/// From the first to the last gate of either range.
inline GateRange Hull(const GateRange& a, const GateRange& b)
{
  return a.IsEmpty()   ? b
         : b.IsEmpty() ? a
                       : GateRange{std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// The first of some bytes that is not 0; `end` without any.
inline const std::uint8_t* SkipZeros(const std::uint8_t* byte, const std::uint8_t* end)
{
  std::uint64_t eight = 0;
  for (; end - byte >= 8; byte += 8)
  {
    std::memcpy(&eight, byte, sizeof eight);
    if (eight != 0)
    {
      break;
    }
  }
  return std::find_if(byte, end, [](std::uint8_t each) { return each != 0; });
}

/// The codes (GateCode) of the gates of a sweep, a row a ray. Most gates of a sweep hold no echo:
/// only the stretches between them are kept, in bytes where the codes of the sweep fit, which takes
/// about a seventh of the memory of a code for each gate. A row is written and read as a whole.
/// Rows that are read once or twice can stay where they are, in the words of a file (AppendWords).
class GateRows
{
public:
  /// Gates that a row can have.
  static constexpr int MostGates = 65'535;

  GateRows() = default;
  /// Rows of codes up to `largest`.
  explicit GateRows(std::uint16_t largest);

  /// Adds the next row: as many gates as the other rows have, at most MostGates, with codes up
  /// to LargestCode().
  void Append(const std::uint16_t* codes, std::size_t gates);
  /// Adds the next row without a copy: `words[gate]` is its code, and 2 less from 2 on; the gates
  /// behind the last word were not sampled. At most MostGates. The words must outlive this object,
  /// whose other rows must come the same way.
  void AppendWords(const std::uint8_t* words, std::size_t gates);
  /// Puts other codes in place of those of a row that was appended as codes, of which the same hold
  /// no echo or are behind the last that was sampled. row < Count().
  void Replace(std::size_t row, const std::uint16_t* codes);
  /// Call it after the last row: hands memory that was kept for further rows back.
  void Finish();

  std::size_t Count() const { return words.empty() ? rows.size() : words.size(); }
  /// Reads the first `gates` gates of a row: all that were appended, or fewer. row < Count().
  void Read(std::size_t row, std::size_t gates, std::uint16_t* codes) const;
  /// Of the first `gates` gates of a row those from the first that holds anything but no echo, and
  /// behind which none does.
  GateRange Held(std::size_t row, std::size_t gates) const;

  /// The largest code that has room.
  std::uint16_t LargestCode() const;
  std::size_t MemoryBytes() const;

private:
  struct Row
  {
    std::uint32_t firstStretch;
    std::uint32_t firstByte;
  };
  // Gates from `begin` up to `end`; `end` 0 says that none from `begin` on was sampled, and that no
  // codes are kept of them.
  struct Stretch
  {
    std::uint16_t begin;
    std::uint16_t end;
  };

  struct Words
  {
    const std::uint8_t* first;
    std::size_t gates;
  };

  std::size_t EndOfRow(std::size_t row) const;
  std::size_t BytesOf(const Stretch& stretch) const;
  void Write(const std::uint16_t* codes, const Stretch& stretch, std::uint8_t* to) const;

  bool wide = false; // codes of two bytes, the lower one first
  std::vector<Row> rows;
  std::vector<Stretch> stretches;
  std::vector<std::uint8_t> bytes;
  std::vector<Words> words; // of rows that are not kept here
};

} // namespace nexrad
