// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace nexrad
{

/// Which gates are connected: each gate refers to an earlier one of its region, or to itself.
class ConnectedGates
{
public:
  explicit ConnectedGates(std::size_t count)
    : parent(count)
  {
    std::iota(parent.begin(), parent.end(), std::int32_t(0));
  }

  /// The first gate of the region of a gate.
  std::int32_t Find(std::int32_t gate)
  {
    while (parent[std::size_t(gate)] != gate)
    {
      std::int32_t& up = parent[std::size_t(gate)];
      up = parent[std::size_t(up)];
      gate = up;
    }
    return gate;
  }

  /// Makes the regions of two gates one.
  void Join(std::size_t a, std::size_t b)
  {
    const std::int32_t first = this->Find(std::int32_t(a));
    const std::int32_t second = this->Find(std::int32_t(b));
    parent[std::size_t(std::max(first, second))] = std::min(first, second);
  }

private:
  std::vector<std::int32_t> parent;
};

} // namespace nexrad
