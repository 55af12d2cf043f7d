// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/TiltGap.h"

#include <cmath>

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

// How the value changes from one tilt to another; 0 when that is not known.
float StepTo(float to, float from)
{
  const float step = to - from;
  return std::isnan(step) ? 0.0F : step;
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

TiltInterpolation::TiltInterpolation(const TiltGapValues& values, const TiltEdges& edges)
  : from(values.lower)
  , perShare(values.upper - values.lower)
  , curve(edges.trendBelow * StepTo(values.lower, values.below) -
          edges.trendAbove * StepTo(values.above, values.upper))
{
  if (values.lowerEcho && !values.upperEcho)
  {
    perShare = -values.lower / edges.endShare;
  }
  else if (values.upperEcho && !values.lowerEcho)
  {
    perShare = values.upper / edges.endShare;
    from = values.upper - perShare;
  }
  else if (!values.lowerEcho && !values.upperEcho)
  {
    curve = 0.0F; // between two tilts without echo there is none
  }
}

} // namespace nexrad
