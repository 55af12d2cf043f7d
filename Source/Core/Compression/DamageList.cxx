// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Compression/DamageList.h"

#include <algorithm>

namespace nexrad
{

void DamageList::Add(std::uint64_t offset, const std::string& what)
{
  if (!entries.empty() && what == lastWhat)
  {
    ++repeated;
    repeatedOffset = offset;
    return;
  }
  this->FinishEntry();
  lastWhat = what;
  if (entries.size() < mostEntries)
  {
    entries.push_back({offset, what});
    return;
  }
  leftOutOffset = leftOut == 0 ? offset : leftOutOffset;
  ++leftOut;
}

void DamageList::FinishEntry()
{
  if (repeated > 0 && leftOut == 0)
  {
    entries.back().what += " (and " + std::to_string(repeated) + " more, the last at offset " +
                           std::to_string(repeatedOffset) + ")";
  }
  leftOut += leftOut > 0 ? repeated : 0;
  repeated = 0;
}

std::vector<Damage> DamageList::Take(bool byOffset)
{
  this->FinishEntry();
  if (leftOut > 0)
  {
    entries.push_back(
      {leftOutOffset, std::to_string(leftOut) + " more places are damaged, from here on"});
  }
  if (byOffset)
  {
    std::stable_sort(entries.begin(), entries.end(),
      [](const Damage& first, const Damage& second) { return first.offset < second.offset; });
  }
  return std::move(entries);
}

} // namespace nexrad
