// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/OffsetMap.h"

#include <algorithm>

namespace nexrad
{

void OffsetMap::Append(const OffsetMap& next, std::uint64_t decodedStart, std::uint64_t storedStart)
{
  for (const Pair& pair : next.pairs)
  {
    this->Add(decodedStart + pair.decoded, storedStart + pair.stored);
  }
}

std::uint64_t OffsetMap::ToStored(std::uint64_t decoded) const
{
  if (pairs.empty())
  {
    return decoded;
  }
  const auto after = std::upper_bound(pairs.begin(), pairs.end(), decoded,
    [](std::uint64_t wanted, const Pair& pair) { return wanted < pair.decoded; });
  return after == pairs.begin() ? pairs.front().stored : std::prev(after)->stored;
}

void OffsetMap::ComposeWith(const OffsetMap& outer)
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

} // namespace nexrad
