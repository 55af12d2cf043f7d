// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/CodedVolume.h"

#include <algorithm>

namespace nexrad
{

void ExpandCodes(const VoxelCodes& meaning, const std::uint8_t* codes, std::size_t count,
  float* values, VoxelState* states, const RangeLoop& loop)
{
  constexpr std::size_t stretch = std::size_t(1) << 18;
  RunLoop(loop, static_cast<int>((count + stretch - 1) / stretch),
    [&](int first, int last)
    {
      const std::size_t end = std::min(count, static_cast<std::size_t>(last) * stretch);
      for (std::size_t i = static_cast<std::size_t>(first) * stretch; i < end; ++i)
      {
        values[i] = meaning.values[codes[i]];
        states[i] = meaning.states[codes[i]];
      }
    });
}

} // namespace nexrad
