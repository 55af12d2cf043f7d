// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/TiltSample.h"

#include <limits>

namespace nexrad
{

namespace
{

// Not-a-number where nothing was measured.
float ValueOf(const TiltSample& sample)
{
  switch (sample.state)
  {
  case VoxelState::Echo:
    return sample.value;
  case VoxelState::NoEcho:
    return sample.assumed ? std::numeric_limits<float>::quiet_NaN() : 0.0F;
  default:
    return std::numeric_limits<float>::quiet_NaN();
  }
}

} // namespace

TiltGapValues ValuesAbout(const TiltSample* samples, std::size_t tilts, std::size_t lower)
{
  TiltGapValues values;
  const TiltSample& first = samples[lower];
  const TiltSample& second = samples[lower + 1];
  values.lowerEcho = first.state == VoxelState::Echo;
  values.upperEcho = second.state == VoxelState::Echo;
  values.lower = values.lowerEcho ? first.value : 0.0F;
  values.upper = values.upperEcho ? second.value : 0.0F;
  if (lower > 0)
  {
    values.below = ValueOf(samples[lower - 1]);
  }
  if (lower + 2 < tilts)
  {
    values.above = ValueOf(samples[lower + 2]);
  }
  return values;
}

} // namespace nexrad
