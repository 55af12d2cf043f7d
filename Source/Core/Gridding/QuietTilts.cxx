// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/QuietTilts.h"

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

// Whether all rays are so near in time.
bool CountsAsMuch(
  const TiltObservation& observation, const SamplingContext& context, float leastFade)
{
  return FadeOf(-observation.Begin(), context.gap) >= leastFade &&
         FadeOf(observation.End(), context.gap) >= leastFade;
}

// tan(γ/2) at which a sweep passes the height up to which weather reaches: t of
// (tan e + t) 2t/(1 + t²) = ceiling.
float TangentAtCeiling(const BeamSweep& sweep, const SamplingContext& context)
{
  const float slope = sweep.sine / sweep.cosine;
  const float a = 2.0F - context.ceiling;
  return (std::sqrt(slope * slope + a * context.ceiling) - slope) / a;
}

// What the distance tells of a sweep: tan(γ/2) of columns at its limits.
struct SweepLimits
{
  float first;   // gate
  float last;    // gate
  float ceiling; // above which nothing can be

  SweepLimits(const BeamSweep& sweep, const SamplingContext& context)
    : first(FirstTangent(sweep, context))
    , last(LastTangent(sweep, context))
    , ceiling(TangentAtCeiling(sweep, context))
  {
  }

  // Neither gates nor the height tell anything.
  bool IsBeyond(float t) const { return t > last && t < ceiling; }
  bool HasGatesOrNothing(float t) const { return t > first && (t < last || t > ceiling); }
};

// The same of an observation. One between two sweeps tells nothing where one of them does not.
struct ObservationLimits
{
  std::vector<SweepLimits> sweeps; // one, or two
  bool closed;                     // it is of one sweep, which has rays in all directions

  ObservationLimits(const TiltObservation& observation, const SamplingContext& context)
    : sweeps({SweepLimits(*observation.lower, context)})
    , closed(observation.upper == nullptr && observation.lower->IsClosed())
  {
    if (observation.upper != nullptr)
    {
      sweeps.emplace_back(*observation.upper, context);
    }
  }

  bool IsBeyond(float t) const
  {
    return std::any_of(
      sweeps.begin(), sweeps.end(), [t](const SweepLimits& each) { return each.IsBeyond(t); });
  }
  // Its rays lie before or after the time of the merge, wherever the column is.
  bool Covers(float t) const { return closed && sweeps.front().HasGatesOrNothing(t); }
};

// The same of a tilt.
struct TiltLimits
{
  QuietTilt quiet;
  std::vector<ObservationLimits> observations;
  bool inFull = true; // all of them count in full
  bool count = true;  // all of them count

  TiltLimits(const BeamTilt& tilt, const QuietTilt& theQuiet, const SamplingContext& context)
    : quiet(theQuiet)
  {
    for (const std::vector<TiltObservation>* side : {&tilt.before, &tilt.after})
    {
      for (const TiltObservation& observation : *side)
      {
        observations.emplace_back(observation, context);
        inFull = inFull && CountsAsMuch(observation, context, 1.0F);
        count = count && CountsAsMuch(observation, context, LeastFade);
      }
    }
  }

  QuietZones::Tilt At(float t, const SamplingContext& context) const
  {
    const auto covers = [t](const ObservationLimits& each) { return each.Covers(t); };
    const auto isBeyond = [t](const ObservationLimits& each) { return each.IsBeyond(t); };
    const bool covered = count && std::any_of(observations.begin(), observations.end(), covers);
    TiltSample ofAnyRay;
    if ((covered && inFull) || SampleQuiet(quiet, {0.0F, t}, context, ofAnyRay))
    {
      return QuietZones::Tilt::NoEcho;
    }
    if (covered)
    {
      return QuietZones::Tilt::AgingNoEcho;
    }
    return std::all_of(observations.begin(), observations.end(), isBeyond)
             ? QuietZones::Tilt::NotScanned
             : QuietZones::Tilt::Unknown;
  }
};

// All places at which something may change.
std::vector<float> LimitsOf(const std::vector<TiltLimits>& tilts)
{
  std::vector<float> limits;
  for (const TiltLimits& tilt : tilts)
  {
    limits.insert(limits.end(), {tilt.quiet.nearest, tilt.quiet.farthest});
    for (const ObservationLimits& observation : tilt.observations)
    {
      for (const SweepLimits& sweep : observation.sweeps)
      {
        limits.insert(limits.end(), {sweep.first, sweep.last, sweep.ceiling});
      }
    }
  }
  std::sort(limits.begin(), limits.end());
  return limits;
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
  if (!before.IsWhole(!hasBefore) || !after.IsWhole(hasAfter) ||
      !CountsAsMuch(before, context, 1.0F) || !CountsAsMuch(after, context, 1.0F))
  {
    return quiet;
  }
  quiet.before = before.lower;
  quiet.after = after.lower;
  quiet.alone = !hasBefore || !hasAfter;
  quiet.nearest = (1.0F + tangentMargin) * std::max(FirstTangent(*quiet.before, context),
                                             FirstTangent(*quiet.after, context));
  quiet.farthest = (1.0F - tangentMargin) * std::min(LastTangent(*quiet.before, context),
                                              LastTangent(*quiet.after, context));
  return quiet;
}

bool SampleQuiet(const QuietTilt& quiet, const ColumnDirection& column,
  const SamplingContext& context, TiltSample& sample)
{
  const float t = column.halfTangent;
  const bool inside = t > quiet.nearest && t < quiet.farthest;
  const bool nothingBeyond = t > quiet.farthest * (1.0F + 4.0F * tangentMargin) &&
                             quiet.before != nullptr && !quiet.alone &&
                             BeyondReach(*quiet.before, column, context) == VoxelState::NoEcho &&
                             BeyondReach(*quiet.after, column, context) == VoxelState::NoEcho;
  if (quiet.before == nullptr || !(inside || nothingBeyond))
  {
    return false;
  }
  const float before = ElevationOf(*quiet.before, FindRays(*quiet.before, column.azimuth));
  const float after = ElevationOf(*quiet.after, FindRays(*quiet.after, column.azimuth));
  sample.state = VoxelState::NoEcho;
  sample.assumed = !inside;
  sample.lowest = std::min(before, after);
  sample.highest = std::max(before, after);
  sample.fade = 1.0F;
  return true;
}

QuietZones::QuietZones(const std::vector<BeamTilt>& ofRadar, const std::vector<QuietTilt>& quiet,
  const SamplingContext& context)
  : tiltCount(ofRadar.size())
{
  std::vector<TiltLimits> limitsOfTilts;
  for (std::size_t i = 0; i < tiltCount; ++i)
  {
    limitsOfTilts.emplace_back(ofRadar[i], quiet[i], context);
  }
  float from = 0.0F;
  const auto add = [&](float to, bool isKnown)
  {
    for (const TiltLimits& tilt : limitsOfTilts)
    {
      tilts.push_back(isKnown ? tilt.At(0.5F * (from + to), context) : Tilt::Unknown);
    }
    ends.push_back(to);
    from = to;
  };
  // About each limit lies a zone in which rounding decides: there the tilts are unknown.
  constexpr float margin = 10.0F * tangentMargin;
  for (const float limit : LimitsOf(limitsOfTilts))
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
