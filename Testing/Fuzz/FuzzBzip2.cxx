// SPDX-License-Identifier: BSD-3-Clause
// Holds the project's bzip2 decoder against libbz2. FastBunzip hands over to libbz2 what it does
// not accept, so the target compares FastBunzip alone: it gives the bytes that libbz2 gives, or
// nothing where libbz2 gives an error, more than the cap, or has met a randomised block.
//
// The checksums of a changed stream are wrong, and both decoders would refuse it at the end of its
// first block. So each input is decoded as it is, and once more with checksums that fit.
#include "FuzzTarget.h"

#include "nexrad/Compression/Container.h"
#include "nexrad/Compression/FastBunzip.h"

#include <bzlib.h>

#include <algorithm>
#include <optional>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t cap = std::size_t(2) << 20;
constexpr std::size_t startOfFirstBlock = 4; // behind "BZh9"
constexpr std::uint64_t blockMark = 0x314159265359;
constexpr std::uint64_t endMark = 0x177245385090;
constexpr std::size_t markBits = 48;
constexpr std::size_t checksumBits = 32;

struct Reference
{
  int status = BZ_OK;
  Bytes bytes;
  std::size_t used = 0; // bytes of the input
};

// What libbz2 makes of a stream, to at most one byte more than the cap, `step` bytes at a time. Of
// a call in which it meets an error it gives nothing, so that smaller steps give more of a damaged
// stream.
Reference RunLibbz2(const Bytes& stored, std::size_t step = cap + 1)
{
  Reference result;
  static Bytes room(cap + 1);
  bz_stream stream{};
  Require(BZ2_bzDecompressInit(&stream, 0, 0) == BZ_OK, "libbz2 has memory");
  Bytes input = stored; // the interface takes it as non-const
  stream.next_in = reinterpret_cast<char*>(input.data());
  stream.avail_in = static_cast<unsigned>(input.size());
  stream.next_out = reinterpret_cast<char*>(room.data());
  std::size_t count = 0;
  bool goesOn = true;
  while (goesOn)
  {
    const std::size_t offered = std::min(step, room.size() - count);
    stream.avail_out = static_cast<unsigned>(offered);
    result.status = BZ2_bzDecompress(&stream);
    count += offered - stream.avail_out;
    const bool starved = stream.avail_in == 0 && stream.avail_out != 0;
    goesOn = result.status == BZ_OK && !starved && count < room.size();
  }
  result.bytes.assign(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(count));
  result.used = input.size() - stream.avail_in;
  BZ2_bzDecompressEnd(&stream);
  return result;
}

std::uint64_t BitsAt(const Bytes& bytes, std::size_t bit, std::size_t count)
{
  std::uint64_t bits = 0;
  for (std::size_t i = bit; i < bit + count; ++i)
  {
    bits = bits << 1 | (i / 8 < bytes.size() ? bytes[i / 8] >> (7 - i % 8) & 1U : 0U);
  }
  return bits;
}

void SetBits(Bytes& bytes, std::size_t bit, std::size_t count, std::uint64_t value)
{
  for (std::size_t i = 0; i < count && (bit + i) / 8 < bytes.size(); ++i)
  {
    const auto mask = static_cast<std::uint8_t>(1U << (7 - (bit + i) % 8));
    const bool on = (value >> (count - 1 - i) & 1U) != 0;
    std::uint8_t& byte = bytes[(bit + i) / 8];
    byte = static_cast<std::uint8_t>(on ? byte | mask : byte & ~mask);
  }
}

// The first place from `bit` on where a block, or the end of the stream, is marked.
std::optional<std::size_t> FindMark(const Bytes& bytes, std::size_t bit)
{
  constexpr std::uint64_t all = (std::uint64_t(1) << markBits) - 1;
  std::uint64_t seen = 0;
  for (std::size_t i = bit; i < 8 * bytes.size(); ++i)
  {
    seen = (seen << 1 | (bytes[i / 8] >> (7 - i % 8) & 1U)) & all;
    if (i + 1 >= bit + markBits && (seen == blockMark || seen == endMark))
    {
      return i + 1 - markBits;
    }
  }
  return std::nullopt;
}

std::uint32_t ChecksumOf(Bytes::const_iterator from, Bytes::const_iterator to)
{
  std::uint32_t value = 0xFFFFFFFFU;
  for (; from != to; ++from)
  {
    value ^= static_cast<std::uint32_t>(*from) << 24;
    for (int bit = 0; bit < 8; ++bit)
    {
      value = value << 1 ^ ((value >> 31) != 0 ? 0x04C11DB7U : 0U);
    }
  }
  return ~value;
}

// Gives the first blocks of a stream, and its end, the checksums of what libbz2 made of them: it
// hands out the bytes of a block before it looks at the checksum.
Bytes WithChecksums(Bytes stored)
{
  constexpr int mostBlocks = 4;
  std::uint32_t combined = 0;
  std::size_t before = 0;
  std::optional<std::size_t> mark = FindMark(stored, 8 * startOfFirstBlock);
  for (int block = 0; block < mostBlocks && mark; ++block)
  {
    const std::size_t checksum = *mark + markBits;
    if (BitsAt(stored, *mark, markBits) == endMark)
    {
      SetBits(stored, checksum, checksumBits, combined);
      break;
    }
    const Bytes bytes = RunLibbz2(stored).bytes;
    const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(std::min(before, bytes.size()));
    const std::uint32_t right = ChecksumOf(from, bytes.end());
    SetBits(stored, checksum, checksumBits, right);
    combined = (combined << 1 | combined >> 31) ^ right;
    before = bytes.size();
    mark = FindMark(stored, checksum + checksumBits);
  }
  return stored;
}

// The smallest: libbz2 takes 0.4 MB for them, not 3.6 MB.
constexpr int blockLevel = 1;

void RequireAccepted(const Bytes& content, FastBunzip& fast)
{
  const Bytes stored = Bzip2(content, blockLevel);
  const auto made = fast.Run(ByteView(stored.data(), stored.size()), cap);
  Require(made && made->used == stored.size(), "FastBunzip accepts what libbz2 compresses");
  Require(made->bytes == content, "FastBunzip gives the bytes that were compressed");
}

bool BeginsWith(const Bytes& bytes, const Bytes& start)
{
  return bytes.size() >= start.size() && std::equal(start.begin(), start.end(), bytes.begin());
}

// The bytes of the two decoders together are those of libbz2 in one step, or more of them, which
// libbz2 gives in single bytes.
void RequireSameBytes(const Bytes& both, Bytes reference, const Bytes& stored)
{
  reference.resize(std::min(cap, reference.size()));
  if (both != reference)
  {
    Require(BeginsWith(both, reference) && BeginsWith(RunLibbz2(stored, 1).bytes, both),
      "Bzip2Reader gives the bytes that libbz2 gives");
  }
}

void Compare(const Bytes& stored)
{
  static FastBunzip fast; // one for all: nothing of a stream before may show
  const ByteView view(stored.data(), stored.size());
  const Reference reference = RunLibbz2(stored);
  const bool whole = reference.status == BZ_STREAM_END && reference.bytes.size() <= cap;
  const auto made = fast.Run(view, cap);
  if (made)
  {
    Require(whole, "FastBunzip accepts nothing that libbz2 refuses");
    Require(made->bytes == reference.bytes, "FastBunzip gives the bytes that libbz2 gives");
    Require(made->used == reference.used, "FastBunzip ends where libbz2 ends");
  }
  else if (whole)
  {
    RequireAccepted(reference.bytes, fast);
  }
  static Bzip2Reader reader; // the two together
  const Unpacked both = reader.Run(view, cap);
  Require(both.problem.empty() == whole, "Bzip2Reader reports what libbz2 refuses");
  RequireSameBytes(both.bytes, reference.bytes, stored);
}

} // namespace

namespace nexrad::testing
{

std::vector<Bytes> FuzzSeeds()
{
  Bytes mixed;
  for (unsigned i = 0; i < 3'000; ++i)
  {
    mixed.push_back(static_cast<std::uint8_t>(i * i * 2'654'435'761U >> 24));
  }
  const Bytes volume = MakeSmallVolume(31);
  const Bytes start(volume.begin(), volume.begin() + 600);
  const Bytes runs = Join({Bytes(3, 1), Bytes(4, 2), Bytes(5, 3), Bytes(259, 4), Bytes(260, 5)});
  const Bytes twoBlocks = Join(std::vector<Bytes>(40, mixed)); // the first of 100 kB
  std::vector<Bytes> seeds = {Bzip2(start)};
  for (const Bytes& content : {Bytes(), Bytes{7}, runs, start, mixed, volume, twoBlocks})
  {
    seeds.push_back(Bzip2(content, blockLevel));
  }
  return seeds;
}

} // namespace nexrad::testing

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const Bytes stored(data, data + size);
  if (stored.size() < startOfFirstBlock)
  {
    return 0;
  }
  Compare(stored);
  Compare(WithChecksums(stored));
  return 0;
}
