// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/TiltGap.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

float ValueOf(const TiltSample& sample)
{
  return sample.state == VoxelState::Echo ? sample.value : 0.0F;
}

bool IsMeasured(const TiltSample& sample)
{
  return (sample.state == VoxelState::Echo || sample.state == VoxelState::NoEcho) &&
         !sample.assumed;
}

// What the tilts beyond the gap add to the middle of it, times four.
float CurveOf(const TiltGap& gap)
{
  const std::vector<TiltEdges>& edges = *gap.edges;
  const TiltSample* lower = gap.samples + gap.lower;
  const TiltSample* upper = lower + 1;
  float curve = 0.0F;
  if (gap.lower > 0 && IsMeasured(lower[-1]))
  {
    curve += edges[gap.lower].trendBelow * (ValueOf(*lower) - ValueOf(lower[-1]));
  }
  if (gap.lower + 2 < edges.size() && IsMeasured(upper[1]))
  {
    curve -= edges[gap.lower].trendAbove * (ValueOf(upper[1]) - ValueOf(*upper));
  }
  return curve;
}

// tan(γ/2) at which a tilt stands at the height of h/(a_e + h) (Formulas G7, for the distance).
float HalfTangentAtHeight(float tangent, float ratio)
{
  return (std::sqrt(tangent * tangent + ratio * (2.0F - ratio)) - tangent) / (2.0F - ratio);
}

// Echo far away on either side says little of what lies between.
float PartByDistance(float distance)
{
  constexpr float full = 50'000.0F; // m
  const float part = full / distance;
  return distance > full ? part * part : 1.0F;
}

// How much one level changes towards the interpolation at its height.
float ChangeAt(const TiltGap& gap, float share, const SiteLevels& levels, const TiltLookup& lookup,
  float halfTangent, int level, float value)
{
  const float ratio = levels.ratio[static_cast<std::size_t>(level)];
  const float nearer = HalfTangentAtHeight((*gap.edges)[gap.lower + 1].tangent, ratio);
  const float farther = HalfTangentAtHeight((*gap.edges)[gap.lower].tangent, ratio);
  if (!(farther > nearer))
  {
    return 0.0F;
  }
  const TiltSample lower = lookup.At(gap.lower, farther);
  const TiltSample upper = IsMeasured(lower) ? lookup.At(gap.lower + 1, nearer) : TiltSample{};
  if (!IsMeasured(lower) || !IsMeasured(upper))
  {
    return 0.0F;
  }
  const float way = std::clamp((halfTangent - nearer) / (farther - nearer), 0.0F, 1.0F);
  const float level0 = ValueOf(upper) + way * (ValueOf(lower) - ValueOf(upper));
  return share * PartByDistance(2.0F * levels.radius * (farther - nearer)) * (level0 - value);
}

} // namespace

TiltSample TiltLookup::At(std::size_t tilt, float halfTangent) const
{
  return SampleTilt(*tilts, tilt, {column.azimuth, halfTangent}, *context, motion);
}

void InterpolateUpwards(const TiltGap& gap, const float* shares, float* values)
{
  const TiltSample& lower = gap.samples[gap.lower];
  const TiltSample& upper = gap.samples[gap.lower + 1];
  const float from = ValueOf(lower);
  const float to = ValueOf(upper);
  const bool echoBelow = lower.state == VoxelState::Echo;
  const bool echoAbove = upper.state == VoxelState::Echo;
  const float curve = CurveOf(gap);
  const float end = (*gap.edges)[gap.lower].endShare;
  for (int level = gap.from; level < gap.to; ++level)
  {
    const float share = shares[level];
    const float straight = echoBelow == echoAbove ? from + share * (to - from)
                           : echoBelow            ? from * (1.0F - share / end)
                                                  : to * (1.0F - (1.0F - share) / end);
    values[level] = straight + curve * share * (1.0F - share);
  }
}

void BlendLayers(const TiltGap& gap, float share, const SiteLevels& levels,
  const TiltLookup& lookup, float halfTangent, float* values)
{
  // So many levels of a gap are worked out; between them the change is linear.
  constexpr int mostLevels = 8;
  const int stride = std::max(1, (gap.to - gap.from + mostLevels - 1) / mostLevels);
  const auto changeAt = [&](int level)
  { return ChangeAt(gap, share, levels, lookup, halfTangent, level, values[level]); };
  const int last = gap.to - 1;
  float before = changeAt(gap.from);
  for (int level = gap.from; level < last;)
  {
    const int next = std::min(level + stride, last);
    const float after = changeAt(next);
    const float step = (after - before) / static_cast<float>(next - level);
    for (int between = level; between < next; ++between)
    {
      values[between] += before + step * static_cast<float>(between - level);
    }
    level = next;
    before = after;
  }
  values[last] += before;
}

} // namespace nexrad
