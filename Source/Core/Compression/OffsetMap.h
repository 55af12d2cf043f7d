// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <vector>

namespace nexrad
{

/// Where decompressed bytes stand in the stored file. A compressed stream has no byte for each of
/// its decompressed ones, so a few pairs of offsets are kept, and the nearest before is the answer:
/// it names the piece of the file that holds the byte. Without pairs both offsets are equal.
class OffsetMap
{
public:
  /// Pairs come in the order of their decoded offsets.
  void Add(std::uint64_t decoded, std::uint64_t stored) { pairs.push_back({decoded, stored}); }

  /// The pairs of a stream that begins at these offsets, after those that are here.
  void Append(const OffsetMap& next, std::uint64_t decodedStart, std::uint64_t storedStart)
  {
    for (const Pair& pair : next.pairs)
    {
      this->Add(decodedStart + pair.decoded, storedStart + pair.stored);
    }
  }

  /// Offset in the stored file of a byte of the decompressed data.
  std::uint64_t ToStored(std::uint64_t decoded) const
  {
    if (pairs.empty())
    {
      return decoded;
    }
    const auto after = std::upper_bound(pairs.begin(), pairs.end(), decoded,
      [](std::uint64_t wanted, const Pair& pair) { return wanted < pair.decoded; });
    return after == pairs.begin() ? pairs.front().stored : std::prev(after)->stored;
  }

  /// Puts another container round this one: `outer` maps this one's stored offsets further out.
  void ComposeWith(const OffsetMap& outer)
  {
    if (pairs.empty())
    {
      pairs = outer.pairs;
      return;
    }
    for (Pair& pair : pairs)
    {
      pair.stored = outer.ToStored(pair.stored);
    }
  }

private:
  struct Pair
  {
    std::uint64_t decoded;
    std::uint64_t stored;
  };
  std::vector<Pair> pairs;
};

/// What came out of a compressed stream, as far as it could be read.
struct Unpacked
{
  std::vector<std::uint8_t> bytes;
  OffsetMap offsets;    ///< from `bytes` to the compressed stream
  std::string problem;  ///< one line; empty when the stream was whole
  std::size_t used = 0; ///< bytes of the compressed stream, up to the problem if there was one
};

} // namespace nexrad
