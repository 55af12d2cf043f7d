// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/GateRegions.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace nexrad
{

namespace
{

// The first of some gates that counts; `end` without any.
const std::uint8_t* FindMember(const std::uint8_t* gate, const std::uint8_t* end)
{
  std::uint64_t eight = 0;
  for (; end - gate >= 8; gate += 8)
  {
    std::memcpy(&eight, gate, sizeof eight);
    if (eight != 0)
    {
      break;
    }
  }
  return std::find_if(gate, end, [](std::uint8_t member) { return member != 0; });
}

} // namespace

GateRegions::GateRegions(const EchoGrid& grid, const std::vector<std::uint8_t>& members)
{
  const std::size_t gates = grid.Gates();
  std::vector<std::size_t> firstRuns;
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    firstRuns.push_back(runs.size());
    const std::uint8_t* row = members.data() + grid.RayAt(place) * gates;
    const GateRange held = grid.Held(place);
    const std::uint8_t* last = row + held.end;
    for (const std::uint8_t* begin = FindMember(row + held.begin, last); begin != last;)
    {
      const std::uint8_t* end = std::find(begin, last, std::uint8_t(0));
      runs.push_back({static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(begin - row),
        static_cast<std::uint32_t>(end - row), 0});
      begin = FindMember(end, last);
    }
  }
  firstRuns.push_back(runs.size());
  parents.resize(runs.size());
  std::iota(parents.begin(), parents.end(), std::uint32_t(0));
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    const std::size_t beside = grid.Beside(place, 1);
    if (beside < grid.Rays() && beside != place)
    {
      this->Join(place, beside, firstRuns);
    }
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const std::uint32_t root = this->RootOf(static_cast<std::uint32_t>(i));
    // A root comes before all other runs of its region.
    runs[i].region = root == i ? static_cast<std::uint32_t>(count++) : runs[root].region;
  }
}

std::uint32_t GateRegions::RootOf(std::uint32_t run)
{
  while (parents[run] != run)
  {
    parents[run] = parents[parents[run]];
    run = parents[run];
  }
  return run;
}

// Joins the runs of two rows that touch.
void GateRegions::Join(
  std::size_t first, std::size_t second, const std::vector<std::size_t>& firstRuns)
{
  std::size_t one = firstRuns[first];
  std::size_t other = firstRuns[second];
  while (one < firstRuns[first + 1] && other < firstRuns[second + 1])
  {
    if (runs[one].begin <= runs[other].end && runs[other].begin <= runs[one].end)
    {
      const std::uint32_t a = this->RootOf(static_cast<std::uint32_t>(one));
      const std::uint32_t b = this->RootOf(static_cast<std::uint32_t>(other));
      parents[std::max(a, b)] = std::min(a, b);
    }
    (runs[one].end < runs[other].end ? one : other) += 1;
  }
}

} // namespace nexrad
