// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/PositionVote.h"

#include <algorithm>

namespace nexrad
{

namespace
{

// Damaged rays may all state different positions; no file needs more groups than this.
constexpr std::size_t mostGroups = 100;

bool AreSame(const StoredPosition& a, const StoredPosition& b)
{
  return a.latitude == b.latitude && a.longitude == b.longitude && a.siteHeight == b.siteHeight &&
         a.feedhornHeight == b.feedhornHeight;
}

} // namespace

void PositionVote::Add(const StoredPosition& position, std::uint64_t offset, std::size_t piece)
{
  if (latest >= groups.size() || !AreSame(groups[latest].position, position))
  {
    const auto same = std::find_if(groups.begin(), groups.end(),
      [&position](const Group& group) { return AreSame(group.position, position); });
    latest = static_cast<std::size_t>(same - groups.begin());
    if (same == groups.end())
    {
      if (groups.size() == mostGroups)
      {
        return;
      }
      groups.push_back({position, 0, offset, piece});
    }
  }
  ++groups[latest].rays;
}

const PositionVote::Group* PositionVote::Largest() const
{
  const auto largest = std::max_element(
    groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.rays < b.rays; });
  return largest == groups.end() ? nullptr : &*largest;
}

std::optional<StoredPosition> PositionVote::Winner() const
{
  const Group* largest = this->Largest();
  return largest != nullptr ? std::optional(largest->position) : std::nullopt;
}

PositionVote::Group PositionVote::Others() const
{
  const Group* largest = this->Largest();
  Group others;
  for (const Group& group : groups)
  {
    if (&group != largest)
    {
      const std::size_t rays = others.rays + group.rays;
      others = others.rays == 0 ? group : others;
      others.rays = rays;
    }
  }
  return others;
}

} // namespace nexrad
