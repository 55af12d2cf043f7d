// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/FastBunzip.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

// What a stream breaks off with; it does not leave this file.
struct Unusual
{
};

[[noreturn]] void Refuse()
{
  throw Unusual();
}

constexpr unsigned longestCode = 20;
constexpr unsigned lookedUpBits = 10; // codes so long are found in one step
constexpr unsigned mostSymbols = 258;
constexpr unsigned mostTables = 6;
constexpr unsigned symbolsPerSelector = 50;
constexpr std::size_t blockUnit = 100'000; // bytes of a block, times the level
constexpr std::size_t shortestCountedRun = 4;

// Compilers make one load of it.
std::uint64_t U64(const std::uint8_t* bytes)
{
  return std::uint64_t(bytes[0]) << 56 | std::uint64_t(bytes[1]) << 48 |
         std::uint64_t(bytes[2]) << 40 | std::uint64_t(bytes[3]) << 32 |
         std::uint64_t(bytes[4]) << 24 | std::uint64_t(bytes[5]) << 16 |
         std::uint64_t(bytes[6]) << 8 | std::uint64_t(bytes[7]);
}

// Bits of a stream, the highest of each byte first. Beyond the end come zeros; Position tells.
class BitReader
{
public:
  explicit BitReader(ByteView bytes)
    : data(bytes.Data())
    , size(bytes.Size())
  {
  }

  // The next bits, at most 32, without passing over them.
  std::uint32_t Peek(unsigned count)
  {
    if (available < count)
    {
      this->Fill();
    }
    return static_cast<std::uint32_t>(bits >> 1 >> (63 - count));
  }
  // After Peek of as many or more.
  void Skip(unsigned count)
  {
    bits <<= count;
    available -= count;
  }
  std::uint32_t Take(unsigned count)
  {
    const std::uint32_t value = this->Peek(count);
    this->Skip(count);
    return value;
  }
  // Bytes of the input that were begun; more than there are when the stream is cut.
  std::size_t Position() const { return next - available / 8; }
  bool Overrun() const { return this->Position() > size; }

private:
  void Fill()
  {
    if (next + sizeof bits <= size)
    {
      bits |= U64(data + next) >> available;
      next += (63 - available) / 8;
      available |= 56;
      return;
    }
    while (available <= 56)
    {
      const std::uint64_t byte = next < size ? data[next] : 0;
      bits |= byte << (56 - available);
      available += 8;
      ++next;
    }
  }

  const std::uint8_t* data;
  std::size_t size;
  std::size_t next = 0;
  std::uint64_t bits = 0; // the next one highest
  unsigned available = 0;
};

// One Huffman code.
class CodeTable
{
public:
  void Make(const std::array<std::uint8_t, mostSymbols>& lengths, unsigned symbols)
  {
    std::array<unsigned, longestCode + 2> counts{};
    for (unsigned symbol = 0; symbol < symbols; ++symbol)
    {
      ++counts[lengths[symbol]];
    }
    std::uint32_t code = 0;
    unsigned place = 0;
    std::array<unsigned, longestCode + 2> firstPlaces{};
    for (unsigned length = 1; length <= longestCode; ++length)
    {
      firstCodes[length] = code;
      firstPlaces[length] = place;
      offsets[length] = place - code;
      code += counts[length];
      place += counts[length];
      if (code > std::uint32_t(1) << length)
      {
        Refuse(); // more codes than there can be
      }
      // Codes of this length, moved up to the longest, lie below.
      ends[length] = code << (longestCode - length);
      code <<= 1;
    }
    std::array<unsigned, longestCode + 2> nextPlaces = firstPlaces;
    for (unsigned symbol = 0; symbol < symbols; ++symbol)
    {
      sorted[nextPlaces[lengths[symbol]]++] = static_cast<std::uint16_t>(symbol);
    }
    this->FillLookup(counts, firstPlaces);
  }

  unsigned Decode(BitReader& bits) const
  {
    const std::uint32_t word = bits.Peek(longestCode);
    const std::uint16_t entry = lookup[word >> (longestCode - lookedUpBits)];
    if (entry != 0)
    {
      bits.Skip(entry & 15U);
      return entry >> 4;
    }
    unsigned length = lookedUpBits + 1;
    while (length <= longestCode && word >= ends[length])
    {
      ++length;
    }
    if (length > longestCode)
    {
      Refuse();
    }
    bits.Skip(length);
    return sorted[offsets[length] + (word >> (longestCode - length))];
  }

private:
  void FillLookup(const std::array<unsigned, longestCode + 2>& counts,
    const std::array<unsigned, longestCode + 2>& firstPlaces)
  {
    lookup.fill(0);
    for (unsigned length = 1; length <= lookedUpBits; ++length)
    {
      for (unsigned index = 0; index < counts[length]; ++index)
      {
        const unsigned shift = lookedUpBits - length;
        const unsigned symbol = sorted[firstPlaces[length] + index];
        std::fill_n(lookup.begin() + ((firstCodes[length] + index) << shift), 1U << shift,
          static_cast<std::uint16_t>(symbol << 4 | length));
      }
    }
  }

  std::array<std::uint16_t, 1U << lookedUpBits> lookup; // symbol << 4, length; 0: a longer code
  std::array<std::uint32_t, longestCode + 1> firstCodes;
  std::array<std::uint32_t, longestCode + 1> ends;
  std::array<std::uint32_t, longestCode + 1> offsets; // from a code to its place in `sorted`
  std::array<std::uint16_t, mostSymbols> sorted;      // symbols by their codes
};

// Checksums of sixteen bytes at a time; table n is that of a byte n bytes before the end.
class Checksum
{
public:
  Checksum()
  {
    for (std::uint32_t byte = 0; byte < 256; ++byte)
    {
      std::uint32_t value = byte << 24;
      for (int bit = 0; bit < 8; ++bit)
      {
        value = value << 1 ^ ((value >> 31) != 0 ? 0x04C11DB7U : 0U);
      }
      tables[0][byte] = value;
    }
    for (std::size_t n = 1; n < tables.size(); ++n)
    {
      for (std::size_t byte = 0; byte < 256; ++byte)
      {
        const std::uint32_t before = tables[n - 1][byte];
        tables[n][byte] = before << 8 ^ tables[0][before >> 24];
      }
    }
  }

  std::uint32_t Of(const std::uint8_t* bytes, std::size_t size) const
  {
    std::uint32_t value = 0xFFFFFFFFU;
    for (; size >= step; bytes += step, size -= step)
    {
      std::uint32_t next = 0;
      for (std::size_t i = 0; i < step; ++i)
      {
        const std::uint32_t before = i < 4 ? value >> (24 - 8 * i) & 255 : 0;
        next ^= tables[step - 1 - i][before ^ bytes[i]];
      }
      value = next;
    }
    for (; size > 0; ++bytes, --size)
    {
      value = value << 8 ^ tables[0][value >> 24 ^ *bytes];
    }
    return ~value;
  }

private:
  static constexpr std::size_t step = 16; // bytes
  std::array<std::array<std::uint32_t, 256>, step> tables;
};

// The codes of a block, and which of them is used where.
struct BlockCodes
{
  std::array<std::uint8_t, 256> bytes{}; // that occur, in order
  unsigned byteCount = 0;
  std::array<CodeTable, mostTables> tables;
  std::vector<std::uint8_t> selectors;
};

void ReadUsedBytes(BitReader& bits, BlockCodes& codes)
{
  const std::uint32_t groups = bits.Take(16);
  codes.byteCount = 0;
  for (unsigned group = 0; group < 16; ++group)
  {
    const std::uint32_t used = (groups >> (15 - group) & 1) != 0 ? bits.Take(16) : 0;
    for (unsigned byte = 0; byte < 16; ++byte)
    {
      if ((used >> (15 - byte) & 1) != 0)
      {
        codes.bytes[codes.byteCount++] = static_cast<std::uint8_t>(16 * group + byte);
      }
    }
  }
}

void ReadSelectors(BitReader& bits, unsigned tables, BlockCodes& codes)
{
  std::array<std::uint8_t, mostTables> recent = {0, 1, 2, 3, 4, 5};
  codes.selectors.resize(bits.Take(15));
  for (std::uint8_t& selector : codes.selectors)
  {
    unsigned place = 0;
    while (bits.Take(1) != 0)
    {
      if (++place == tables)
      {
        Refuse();
      }
    }
    selector = recent[place];
    std::copy_backward(recent.begin(), recent.begin() + place, recent.begin() + place + 1);
    recent[0] = selector;
  }
}

void ReadCodes(BitReader& bits, BlockCodes& codes)
{
  ReadUsedBytes(bits, codes);
  const unsigned tables = bits.Take(3);
  if (codes.byteCount == 0 || tables < 2 || tables > mostTables)
  {
    Refuse();
  }
  ReadSelectors(bits, tables, codes);
  for (unsigned table = 0; table < tables; ++table)
  {
    std::array<std::uint8_t, mostSymbols> lengths{};
    unsigned length = bits.Take(5);
    for (unsigned symbol = 0; symbol < codes.byteCount + 2; ++symbol)
    {
      while (length >= 1 && length <= longestCode && bits.Take(1) != 0)
      {
        length += bits.Take(1) != 0 ? -1U : 1U;
      }
      if (length < 1 || length > longestCode)
      {
        Refuse();
      }
      lengths[symbol] = static_cast<std::uint8_t>(length);
    }
    codes.tables[table].Make(lengths, codes.byteCount + 2);
  }
}

// A run in the column, in the digits of the format: 1 and 2 for 0 and 1, the lowest first.
class RunCounter
{
public:
  void Add(unsigned symbol)
  {
    length += std::size_t(symbol + 1) << digits;
    if (++digits > 21)
    {
      Refuse();
    }
  }
  std::size_t Take()
  {
    digits = 0;
    return std::exchange(length, 0);
  }
  bool Empty() const { return digits == 0; }

private:
  std::size_t length = 0;
  unsigned digits = 0;
};

// The bytes of a block, the last used one first. Most symbols mean one of the first sixteen. These
// are two numbers, in which bytes move without a branch: nobody can guess where the next one
// stands.
class RecentBytes
{
public:
  explicit RecentBytes(const std::array<std::uint8_t, 256>& bytes)
    : all(bytes)
  {
    for (unsigned place = perNumber; place-- > 0;)
    {
      first = first << 8 | bytes[place];
      second = second << 8 | bytes[place + perNumber];
    }
  }

  std::uint8_t First() const { return static_cast<std::uint8_t>(first); }

  // The byte at a place, which becomes the first one.
  std::uint8_t Use(unsigned place)
  {
    if (place >= 2 * perNumber)
    {
      return this->UseLater(place);
    }
    const unsigned shift = 8 * (place % perNumber);
    const std::uint64_t inSecond = place < perNumber ? 0 : everyBit;
    const std::uint64_t byte = ((first ^ ((first ^ second) & inSecond)) >> shift) & 255;
    const std::uint64_t moved = (std::uint64_t(256) << shift) - 1; // that byte and those before
    Replace(second, second << 8 | first >> lastShift, moved & inSecond);
    Replace(first, first << 8 | byte, moved | inSecond);
    return static_cast<std::uint8_t>(byte);
  }

private:
  static void Replace(std::uint64_t& bits, std::uint64_t by, std::uint64_t mask)
  {
    bits ^= (bits ^ by) & mask;
  }
  std::uint8_t UseLater(unsigned place)
  {
    const std::uint8_t byte = all[place];
    std::uint8_t* const third = all.data() + 2 * std::size_t(perNumber);
    std::memmove(third + 1, third, place - 2 * perNumber);
    *third = static_cast<std::uint8_t>(second >> lastShift);
    second = second << 8 | first >> lastShift;
    first = first << 8 | byte;
    return byte;
  }

  static constexpr unsigned perNumber = 8;
  static constexpr unsigned lastShift = 8 * (perNumber - 1);
  static constexpr std::uint64_t everyBit = ~std::uint64_t(0);
  std::uint64_t first = 0;           // the first eight, the lowest first
  std::uint64_t second = 0;          // the next eight
  std::array<std::uint8_t, 256> all; // those behind at their places
};

// The last column of a block and how often each byte occurs in it. Returns its size.
std::size_t ReadColumn(BitReader& stream, const BlockCodes& codes, std::size_t largest,
  std::uint8_t* column, std::array<std::uint32_t, 256>& counts)
{
  BitReader bits = stream; // a local one can stay in registers while the column is written
  const unsigned endOfBlock = codes.byteCount + 1;
  RecentBytes recent(codes.bytes);
  counts.fill(0);
  std::size_t size = 0;
  RunCounter run;
  const auto endRun = [&]
  {
    const std::size_t length = run.Take();
    if (length > largest - size)
    {
      Refuse();
    }
    std::memset(column + size, recent.First(), length);
    counts[recent.First()] += static_cast<std::uint32_t>(length);
    size += length;
  };
  for (const std::uint8_t selector : codes.selectors)
  {
    const CodeTable& table = codes.tables[selector];
    for (unsigned i = 0; i < symbolsPerSelector; ++i)
    {
      const unsigned symbol = table.Decode(bits);
      if (symbol <= 1)
      {
        run.Add(symbol);
        continue;
      }
      if (!run.Empty())
      {
        endRun();
      }
      if (symbol == endOfBlock)
      {
        stream = bits;
        return size;
      }
      if (size == largest)
      {
        Refuse();
      }
      const std::uint8_t byte = recent.Use(symbol - 1);
      column[size++] = byte;
      ++counts[byte];
    }
    if (bits.Overrun())
    {
      Refuse();
    }
  }
  Refuse();
}

// Inverts the sorting: each place of the first column points to where its byte stands in the last.
// Equal bytes stand in both columns in the same order.
void MakeLinks(const std::uint8_t* column, std::size_t size,
  const std::array<std::uint32_t, 256>& counts, std::uint32_t* links)
{
  std::array<std::uint32_t, 256> places{};
  for (std::size_t byte = 1; byte < 256; ++byte)
  {
    places[byte] = places[byte - 1] + counts[byte - 1];
  }
  for (std::uint32_t i = 0; i < size; ++i)
  {
    const std::uint8_t byte = column[i];
    links[places[byte]++] = i << 8 | byte;
  }
}

// The text of a block. Four equal bytes stand before a count of more of them.
struct BlockText
{
  std::unique_ptr<std::uint8_t[]> bytes;
  std::unique_ptr<std::uint32_t[]> counts; // places of counts in `bytes`
  std::size_t size = 0;
  std::size_t countsSize = 0;
  std::size_t expandedSize = 0;

  // Each link waits for the one before: finding the counts meanwhile takes no time, as long as no
  // branch has to be guessed.
  void Walk(const std::uint32_t* links, std::uint32_t origin, std::size_t linksSize)
  {
    size = linksSize;
    countsSize = 0;
    expandedSize = 0;
    std::uint32_t at = origin;
    std::uint8_t before = 0;
    std::uint32_t equal = 0; // bytes up to the one before
    for (std::uint32_t i = 0; i < size; ++i)
    {
      const std::uint32_t link = links[at];
      const auto byte = static_cast<std::uint8_t>(link);
      bytes[i] = byte;
      counts[countsSize] = i;
      const bool isCount = equal == shortestCountedRun;
      countsSize += isCount ? 1 : 0;
      expandedSize += isCount ? byte : 1;
      equal = isCount ? 0 : (byte == before ? equal : 0) + 1;
      before = byte;
      at = link >> 8;
    }
    if (equal == shortestCountedRun)
    {
      Refuse(); // no count
    }
  }

  void AppendTo(std::vector<std::uint8_t>& output) const
  {
    const std::uint8_t* from = bytes.get();
    for (std::size_t i = 0; i < countsSize; ++i)
    {
      const std::uint8_t* const count = bytes.get() + counts[i];
      output.insert(output.end(), from, count);
      output.insert(output.end(), *count, count[-1]);
      from = count + 1;
    }
    output.insert(output.end(), from, static_cast<const std::uint8_t*>(bytes.get() + size));
  }
};

constexpr std::uint64_t blockMark = 0x314159265359;
constexpr std::uint64_t endMark = 0x177245385090;

} // namespace

struct FastBunzip::Memory
{
  BlockCodes codes;
  std::size_t largestBlock = 0; // of the stream in hand
  std::size_t room = 0;         // for a block
  // Most blocks fill little of it: memory that is not written takes no time.
  std::unique_ptr<std::uint8_t[]> column; // last column of the sorted rotations of a block
  std::unique_ptr<std::uint32_t[]> links; // of the first column: place of the next byte << 8, byte
  BlockText text;
  std::vector<std::uint8_t> output;
  OffsetMap offsets;

  void Begin(std::size_t blockBytes)
  {
    largestBlock = blockBytes;
    if (room < blockBytes)
    {
      room = blockBytes;
      column.reset(new std::uint8_t[room]);
      links.reset(new std::uint32_t[room]);
      text.bytes.reset(new std::uint8_t[room]);
      text.counts.reset(new std::uint32_t[room / (shortestCountedRun + 1) + 1]);
    }
    output.clear();
    offsets = OffsetMap();
    offsets.Add(0, 0);
  }

  // `expected` is the checksum of the block.
  void ReadBlock(BitReader& bits, std::uint32_t expected, std::size_t maximumBytes)
  {
    static const Checksum checksum;
    const bool randomised = bits.Take(1) != 0;
    const std::uint32_t origin = bits.Take(24);
    if (randomised)
    {
      Refuse();
    }
    ReadCodes(bits, codes);
    std::array<std::uint32_t, 256> counts;
    const std::size_t size = ReadColumn(bits, codes, largestBlock, column.get(), counts);
    if (origin >= size || bits.Overrun())
    {
      Refuse();
    }
    MakeLinks(column.get(), size, counts, links.get());
    text.Walk(links.get(), origin, size);
    const std::size_t before = output.size();
    this->MakeRoom(text.expandedSize, maximumBytes);
    text.AppendTo(output);
    if (checksum.Of(output.data() + before, output.size() - before) != expected)
    {
      Refuse();
    }
    offsets.Add(output.size(), bits.Position());
  }

  // In a stream of one block, as most records are, no more than is needed.
  void MakeRoom(std::size_t bytes, std::size_t maximumBytes)
  {
    if (bytes > maximumBytes - output.size())
    {
      Refuse();
    }
    const std::size_t needed = output.size() + bytes;
    if (needed > output.capacity())
    {
      output.reserve(std::max(needed, 2 * output.capacity()));
    }
  }
};

FastBunzip::FastBunzip()
  : memory(std::make_unique<Memory>())
{
}

FastBunzip::~FastBunzip() = default;

std::optional<Unpacked> FastBunzip::Run(ByteView stored, std::size_t maximumBytes)
{
  try
  {
    BitReader bits(stored);
    const std::uint32_t letters = bits.Take(24);
    const std::uint32_t level = bits.Take(8) - '0';
    if (letters != 0x425A68 || level < 1 || level > 9) // "BZh"
    {
      return std::nullopt;
    }
    memory->Begin(level * blockUnit);
    std::uint32_t combined = 0;
    for (;;)
    {
      const std::uint64_t mark = std::uint64_t(bits.Take(24)) << 24 | bits.Take(24);
      const std::uint32_t checksum = bits.Take(32);
      if (mark == endMark)
      {
        if (checksum != combined || bits.Overrun())
        {
          return std::nullopt;
        }
        memory->output.shrink_to_fit();
        return Unpacked{std::move(memory->output), memory->offsets, "", bits.Position()};
      }
      if (mark != blockMark)
      {
        return std::nullopt;
      }
      memory->ReadBlock(bits, checksum, maximumBytes);
      combined = (combined << 1 | combined >> 31) ^ checksum;
    }
  }
  catch (const Unusual&)
  {
    std::vector<std::uint8_t>().swap(memory->output); // who takes over needs as much once more
    return std::nullopt;
  }
}

} // namespace nexrad
