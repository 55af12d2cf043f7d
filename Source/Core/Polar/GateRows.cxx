// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/GateRows.h"

#include "nexrad/Polar/GateCode.h"

#include <algorithm>
#include <cstring>
#include <limits>

namespace nexrad
{

namespace
{

constexpr std::uint16_t largestByte = std::numeric_limits<std::uint8_t>::max();

// A stretch takes four bytes: fewer gates of no echo are kept with those about them.
constexpr std::size_t shortestGap = 4;

// The first gate from `gate` on that holds anything but no echo, whose code is 0; `end` when none
// does.
std::size_t SkipNoEcho(const std::uint16_t* codes, std::size_t gate, std::size_t end)
{
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(codes);
  constexpr std::size_t each = sizeof *codes;
  return static_cast<std::size_t>(SkipZeros(bytes + each * gate, bytes + each * end) - bytes) /
         each;
}

// The first gate from `gate` on that holds no echo; `end` when all hold something.
std::size_t SkipEcho(const std::uint16_t* codes, std::size_t gate, std::size_t end)
{
  std::uint64_t four = 0;
  constexpr std::size_t count = sizeof four / sizeof *codes;
  constexpr std::uint64_t ones = 0x0001'0001'0001'0001U;
  constexpr std::uint64_t highest = 0x8000'8000'8000'8000U;
  for (; gate + count <= end; gate += count)
  {
    std::memcpy(&four, codes + gate, sizeof four);
    if (((four - ones) & ~four & highest) != 0) // one of them is 0
    {
      break;
    }
  }
  while (gate < end && codes[gate] != GateCode::NoEcho)
  {
    ++gate;
  }
  return gate;
}

// Where the stretch that begins at a gate ends.
std::size_t EndOfStretch(const std::uint16_t* codes, std::size_t gate, std::size_t end)
{
  while (gate < end)
  {
    gate = SkipEcho(codes, gate, end);
    const std::size_t last = std::min(gate + shortestGap, end);
    const std::size_t next = SkipNoEcho(codes, gate, last);
    if (next == last)
    {
      break;
    }
    gate = next;
  }
  return gate;
}

// Behind the last of some bytes that is not 0; `byte` without any.
const std::uint8_t* SkipZerosBack(const std::uint8_t* byte, const std::uint8_t* end)
{
  std::uint64_t eight = 0;
  for (; end - byte >= 8; end -= 8)
  {
    std::memcpy(&eight, end - 8, sizeof eight);
    if (eight != 0)
    {
      break;
    }
  }
  while (end != byte && *(end - 1) == 0)
  {
    --end;
  }
  return end;
}

} // namespace

GateRows::GateRows(std::uint16_t largest)
  : wide(largest > largestByte)
{
}

std::uint16_t GateRows::LargestCode() const
{
  return wide ? GateCode::Last : largestByte;
}

void GateRows::Append(const std::uint16_t* codes, std::size_t gates)
{
  rows.push_back(
    {static_cast<std::uint32_t>(stretches.size()), static_cast<std::uint32_t>(bytes.size())});
  std::size_t end = gates;
  while (end > 0 && codes[end - 1] == GateCode::NotSampled)
  {
    --end;
  }
  for (std::size_t gate = SkipNoEcho(codes, 0, end); gate < end;
       gate = SkipNoEcho(codes, gate, end))
  {
    const std::size_t begin = gate;
    gate = EndOfStretch(codes, begin, end);
    const Stretch stretch = {static_cast<std::uint16_t>(begin), static_cast<std::uint16_t>(gate)};
    const std::size_t first = bytes.size();
    stretches.push_back(stretch);
    bytes.resize(first + this->BytesOf(stretch));
    this->Write(codes, stretch, bytes.data() + first);
  }
  if (end < gates)
  {
    stretches.push_back({static_cast<std::uint16_t>(end), 0});
  }
}

void GateRows::AppendWords(const std::uint8_t* rowWords, std::size_t gates)
{
  words.push_back({rowWords, gates});
}

void GateRows::Replace(std::size_t row, const std::uint16_t* codes)
{
  std::uint8_t* to = bytes.data() + rows[row].firstByte;
  for (std::size_t i = rows[row].firstStretch; i < this->EndOfRow(row) && stretches[i].end > 0; ++i)
  {
    this->Write(codes, stretches[i], to);
    to += this->BytesOf(stretches[i]);
  }
}

void GateRows::Finish()
{
  words.shrink_to_fit();
  rows.shrink_to_fit();
  stretches.shrink_to_fit();
  bytes.shrink_to_fit();
}

void GateRows::Read(std::size_t row, std::size_t gates, std::uint16_t* codes) const
{
  if (!words.empty())
  {
    const std::uint8_t* word = words[row].first;
    const std::size_t count = std::min(gates, words[row].gates);
    std::transform(word, word + count, codes, CodeOfWord);
    std::fill(codes + count, codes + gates, GateCode::NotSampled);
    return;
  }
  const std::uint8_t* from = bytes.data() + rows[row].firstByte;
  std::size_t done = 0;
  for (std::size_t i = rows[row].firstStretch; i < this->EndOfRow(row) && done < gates; ++i)
  {
    const Stretch& stretch = stretches[i];
    const std::size_t begin = std::min<std::size_t>(stretch.begin, gates);
    std::fill(codes + done, codes + begin, GateCode::NoEcho);
    if (stretch.end == 0)
    {
      std::fill(codes + begin, codes + gates, GateCode::NotSampled);
      return;
    }
    done = std::min<std::size_t>(stretch.end, gates);
    const std::size_t count = done - begin;
    if (!wide)
    {
      std::copy_n(from, count, codes + begin);
    }
    for (std::size_t gate = 0; wide && gate < count; ++gate)
    {
      codes[begin + gate] = static_cast<std::uint16_t>(from[2 * gate] | from[2 * gate + 1] << 8U);
    }
    from += count * (wide ? 2 : 1);
  }
  std::fill(codes + done, codes + gates, GateCode::NoEcho);
}

GateRange GateRows::Held(std::size_t row, std::size_t gates) const
{
  if (!words.empty())
  {
    const Words& own = words[row];
    const std::uint8_t* last = own.first + std::min(gates, own.gates);
    const std::uint8_t* begin = SkipZeros(own.first, last);
    const std::uint8_t* end = SkipZerosBack(begin, last);
    const bool isWhole = own.gates >= gates; // else the last gates are NotSampled
    return begin == end && isWhole ? GateRange()
                                   : GateRange{static_cast<std::size_t>(begin - own.first),
                                       isWhole ? static_cast<std::size_t>(end - own.first) : gates};
  }
  const std::size_t first = rows[row].firstStretch;
  const std::size_t end = this->EndOfRow(row);
  if (first == end)
  {
    return {};
  }
  const std::size_t last = stretches[end - 1].end;
  const GateRange held{stretches[first].begin, last > 0 ? std::min(last, gates) : gates};
  return held.IsEmpty() ? GateRange() : held;
}

std::size_t GateRows::MemoryBytes() const
{
  return rows.capacity() * sizeof(Row) + stretches.capacity() * sizeof(Stretch) + bytes.capacity() +
         words.capacity() * sizeof(Words);
}

std::size_t GateRows::EndOfRow(std::size_t row) const
{
  return row + 1 < rows.size() ? rows[row + 1].firstStretch : stretches.size();
}

std::size_t GateRows::BytesOf(const Stretch& stretch) const
{
  return static_cast<std::size_t>(stretch.end - stretch.begin) * (wide ? 2 : 1);
}

// Writes the codes of a stretch, of those of a row.
void GateRows::Write(const std::uint16_t* codes, const Stretch& stretch, std::uint8_t* to) const
{
  const std::uint16_t* from = codes + stretch.begin;
  const std::size_t count = stretch.end - stretch.begin;
  if (!wide)
  {
    std::transform(
      from, from + count, to, [](std::uint16_t code) { return static_cast<std::uint8_t>(code); });
    return;
  }
  for (std::size_t gate = 0; gate < count; ++gate)
  {
    to[2 * gate] = static_cast<std::uint8_t>(from[gate]);
    to[2 * gate + 1] = static_cast<std::uint8_t>(from[gate] >> 8U);
  }
}

} // namespace nexrad
