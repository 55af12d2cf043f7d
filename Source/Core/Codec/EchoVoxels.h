// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <cstddef>
#include <cstring>

namespace nexrad
{

/// Calls `visit(i)` for each of the `count` voxels that is an echo, in ascending order. Few voxels
/// hold an echo; the library looks for the next one many at a time.
template <class Visit>
void ForEachEcho(const VoxelState* states, std::size_t count, const Visit& visit)
{
  const auto nextEcho = [states, count](std::size_t from)
  {
    const void* found =
      std::memchr(states + from, static_cast<int>(VoxelState::Echo), count - from);
    return found ? static_cast<std::size_t>(static_cast<const VoxelState*>(found) - states) : count;
  };
  for (std::size_t i = nextEcho(0); i < count; i = nextEcho(i))
  {
    for (; i < count && states[i] == VoxelState::Echo; ++i)
    {
      visit(i);
    }
  }
}

} // namespace nexrad
