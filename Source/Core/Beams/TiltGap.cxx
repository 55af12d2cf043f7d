// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/TiltGap.h"

#include <cmath>

namespace nexrad
{

namespace
{

// How the value changes from one tilt to another; 0 when that is not known.
float StepTo(float to, float from)
{
  const float step = to - from;
  return std::isnan(step) ? 0.0F : step;
}

} // namespace

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
