// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/QuietTilts.h"

#include "nexrad/Gridding/SweepPlace.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

// What rounding may change of the place at which gates begin and end, as a part of it.
constexpr float tangentMargin = 1e-5F;

// tan(γ/2) at a slant range of a sweep.
float TangentAt(const BeamSweep& sweep, float range, const SamplingContext& context)
{
  const float ground =
    std::atan2(range * sweep.cosine, context.effectiveRadius + range * sweep.sine);
  return std::tan(0.5F * ground);
}

// The same at which the first gate begins.
float FirstTangent(const BeamSweep& sweep, const SamplingContext& context)
{
  const float range = std::max(0.0F, sweep.firstGate - 0.5F / sweep.gatesPerMetre);
  return TangentAt(sweep, range, context);
}

// The same at which the last gate ends.
float LastTangent(const BeamSweep& sweep, const SamplingContext& context)
{
  return TangentAt(sweep, sweep.Reach(), context);
}

// Whether all rays are near enough in time.
bool CountsInFull(const TiltObservation& observation, const SamplingContext& context)
{
  return FadeOf(-observation.Begin(), context.gap) >= 1.0F &&
         FadeOf(observation.End(), context.gap) >= 1.0F;
}

} // namespace

QuietTilt FindQuiet(const BeamTilt& tilt, const SamplingContext& context)
{
  QuietTilt quiet;
  float lowest = tilt.elevation;
  for (const std::vector<TiltObservation>* side : {&tilt.before, &tilt.after})
  {
    for (const TiltObservation& observation : *side)
    {
      lowest = std::min(lowest, observation.lower->elevation);
    }
  }
  quiet.elevation = ElevationCode(lowest);
  if (context.ages)
  {
    return quiet;
  }
  const bool hasBefore = !tilt.before.empty();
  const bool hasAfter = !tilt.after.empty();
  const TiltObservation& before = (hasBefore ? tilt.before : tilt.after).front();
  const TiltObservation& after = (hasAfter ? tilt.after : tilt.before).front();
  if (!before.IsWhole(!hasBefore) || !after.IsWhole(hasAfter) || !CountsInFull(before, context) ||
      !CountsInFull(after, context))
  {
    return quiet;
  }
  quiet.before = before.lower;
  quiet.after = after.lower;
  quiet.alone = !hasBefore || !hasAfter;
  const auto first = [&context](const BeamSweep& sweep) { return FirstTangent(sweep, context); };
  const auto last = [&context](const BeamSweep& sweep) { return LastTangent(sweep, context); };
  quiet.nearest = (1.0F + tangentMargin) * std::max(first(*quiet.before), first(*quiet.after));
  quiet.farthest = (1.0F - tangentMargin) * std::min(last(*quiet.before), last(*quiet.after));
  return quiet;
}

std::optional<TiltSample> SampleQuiet(
  const QuietTilt& quiet, const ColumnDirection& column, const SamplingContext& context)
{
  const float t = column.halfTangent;
  const bool inside = t > quiet.nearest && t < quiet.farthest;
  const bool nothingBeyond = t > quiet.farthest * (1.0F + 4.0F * tangentMargin) &&
                             quiet.before != nullptr && !quiet.alone &&
                             BeyondReach(*quiet.before, column, context) == VoxelState::NoEcho &&
                             BeyondReach(*quiet.after, column, context) == VoxelState::NoEcho;
  if (quiet.before == nullptr || !(inside || nothingBeyond))
  {
    return std::nullopt;
  }
  const float before = ElevationOf(*quiet.before, FindRays(*quiet.before, column.azimuth));
  const float after = ElevationOf(*quiet.after, FindRays(*quiet.after, column.azimuth));
  TiltSample sample;
  sample.state = VoxelState::NoEcho;
  sample.assumed = !inside;
  sample.lowest = std::min(before, after);
  sample.highest = std::max(before, after);
  sample.fade = 1.0F;
  return sample;
}

namespace
{

// Whether no gate of a sweep lies so far out, nor so high that nothing can be there.
bool IsBeyond(const BeamSweep& sweep, const ColumnDirection& column, const SamplingContext& context)
{
  return column.halfTangent > LastTangent(sweep, context) &&
         BeyondReach(sweep, column, context) == VoxelState::NotScanned;
}

// An observation between two sweeps tells nothing where one of them does not.
bool IsBeyond(
  const TiltObservation& observation, const ColumnDirection& column, const SamplingContext& context)
{
  return IsBeyond(*observation.lower, column, context) ||
         (observation.upper != nullptr && IsBeyond(*observation.upper, column, context));
}

// Whether an observation saw all directions at a distance, or nothing can be there. Its rays lie
// before or after the time of the merge.
bool Covers(
  const TiltObservation& observation, const ColumnDirection& column, const SamplingContext& context)
{
  const BeamSweep& sweep = *observation.lower;
  return observation.upper == nullptr && sweep.IsClosed() &&
         column.halfTangent > FirstTangent(sweep, context) &&
         (column.halfTangent < LastTangent(sweep, context) ||
           BeyondReach(sweep, column, context) == VoxelState::NoEcho);
}

// Calls `test` for the observations of a tilt before the time, and for those after it.
template <class Test>
bool AllOf(const BeamTilt& tilt, const Test& test)
{
  return std::all_of(tilt.before.begin(), tilt.before.end(), test) &&
         std::all_of(tilt.after.begin(), tilt.after.end(), test);
}

QuietZones::Tilt TiltAt(const BeamTilt& tilt, const QuietTilt& quiet, const ColumnDirection& column,
  const SamplingContext& context)
{
  const bool inFull = AllOf(
    tilt, [&](const TiltObservation& observation) { return CountsInFull(observation, context); });
  const bool covered = !AllOf(tilt,
    [&](const TiltObservation& observation) { return !Covers(observation, column, context); });
  if (SampleQuiet(quiet, column, context) || (inFull && covered))
  {
    return QuietZones::Tilt::NoEcho;
  }
  return AllOf(tilt, [&](const TiltObservation& observation)
           { return IsBeyond(observation, column, context); })
           ? QuietZones::Tilt::NotScanned
           : QuietZones::Tilt::Unknown;
}

// tan(γ/2) at which a sweep passes the height up to which weather reaches: t of
// (tan e + t) 2t/(1 + t²) = ceiling.
float TangentAtCeiling(const BeamSweep& sweep, const SamplingContext& context)
{
  const float slope = sweep.sine / sweep.cosine;
  const float a = 2.0F - context.ceiling;
  return (std::sqrt(slope * slope + a * context.ceiling) - slope) / a;
}

// Where something of a sweep begins or ends.
void AddLimits(const BeamSweep& sweep, const SamplingContext& context, std::vector<float>& limits)
{
  limits.push_back(FirstTangent(sweep, context));
  limits.push_back(LastTangent(sweep, context));
  limits.push_back(TangentAtCeiling(sweep, context));
}

std::vector<float> LimitsOf(const std::vector<BeamTilt>& tilts, const std::vector<QuietTilt>& quiet,
  const SamplingContext& context)
{
  std::vector<float> limits;
  for (const BeamTilt& tilt : tilts)
  {
    for (const std::vector<TiltObservation>* side : {&tilt.before, &tilt.after})
    {
      for (const TiltObservation& observation : *side)
      {
        AddLimits(*observation.lower, context, limits);
        if (observation.upper != nullptr)
        {
          AddLimits(*observation.upper, context, limits);
        }
      }
    }
  }
  for (const QuietTilt& tilt : quiet)
  {
    limits.push_back(tilt.nearest);
    limits.push_back(tilt.farthest);
  }
  std::sort(limits.begin(), limits.end());
  return limits;
}

} // namespace

QuietZones::QuietZones(const std::vector<BeamTilt>& ofRadar, const std::vector<QuietTilt>& quiet,
  const SamplingContext& context)
  : tiltCount(ofRadar.size())
{
  // About each limit lies a zone in which rounding decides: there the tilts are unknown.
  constexpr float margin = 10.0F * tangentMargin;
  float from = 0.0F;
  const auto add = [&](float to, bool isKnown)
  {
    const ColumnDirection middle = {0.0F, 0.5F * (from + to)};
    for (std::size_t i = 0; i < tiltCount; ++i)
    {
      tilts.push_back(isKnown ? TiltAt(ofRadar[i], quiet[i], middle, context) : Tilt::Unknown);
    }
    ends.push_back(to);
    from = to;
  };
  for (const float limit : LimitsOf(ofRadar, quiet, context))
  {
    const float below = (1.0F - margin) * limit;
    if (below > from)
    {
      add(below, true);
    }
    if ((1.0F + margin) * limit > from)
    {
      add((1.0F + margin) * limit, false);
    }
  }
}

const QuietZones::Tilt* QuietZones::At(const ColumnDirection& column) const
{
  const auto zone = static_cast<std::size_t>(
    std::lower_bound(ends.begin(), ends.end(), column.halfTangent) - ends.begin());
  return zone < ends.size() ? tilts.data() + zone * tiltCount : nullptr;
}

} // namespace nexrad
