// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
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
  void Append(const OffsetMap& next, std::uint64_t decodedStart, std::uint64_t storedStart);

  /// Offset in the stored file of a byte of the decompressed data.
  std::uint64_t ToStored(std::uint64_t decoded) const;

  /// Puts another container round this one: `outer` maps this one's stored offsets further out.
  void ComposeWith(const OffsetMap& outer);

private:
  struct Pair
  {
    std::uint64_t decoded;
    std::uint64_t stored;
  };
  std::vector<Pair> pairs;
};

} // namespace nexrad
