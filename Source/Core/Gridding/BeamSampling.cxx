// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/BeamSampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace nexrad
{

namespace
{

// What an observation of a tilt has in a direction: as TiltSample, at the observation's own time.
struct Observed
{
  VoxelState state = VoxelState::NotScanned;
  bool assumed = false; // TiltSample::assumed
  float value = 0.0F;
  float elevation = 0.0F; // degrees, of the nearest ray
  float time = 0.0F;      // s from the time of the merge
};

// Between two values, `share` of the way to the second.
inline float Blend(float first, float second, float share, const ValueRule& rule)
{
  float difference = second - first;
  if (rule.period > 0.0F)
  {
    difference = std::remainder(difference, rule.period);
  }
  return first + share * difference;
}

// From decibels to what is interpolated.
inline float Interpolated(float value, const ValueRule& rule)
{
  return rule.linear ? std::exp2(value * 0.332192809F) : value; // 10^(v/10)
}

// What lies about a point: weights by state, and the mean of the echoes.
struct Tally : StateWeights
{
  float value = 0.0F;

  void AddEcho(float own, float weight, const ValueRule& rule)
  {
    echo += weight;
    if (weight > 0.0F)
    {
      value = echo > weight ? Blend(value, own, weight / echo, rule) : own;
    }
  }
};

// Formulas G6; of reflectivity, where no echo counts as 0 dBZ, G8.
void Decide(const Tally& about, const ValueRule& rule, Observed& observed)
{
  observed.value = about.value;
  if (about.none + about.echo > 0.0F)
  {
    const float zero = rule.linear ? 1.0F : 0.0F;
    if (rule.zeroIsNone && about.echo > 0.0F && about.value > zero)
    {
      observed.state = VoxelState::Echo;
      observed.value = zero + (about.value - zero) * about.echo / (about.none + about.echo);
    }
    else
    {
      observed.state = about.none >= about.echo ? VoxelState::NoEcho : VoxelState::Echo;
    }
  }
  else
  {
    const std::uint16_t code = about.CodeOfNothing();
    observed.state = code == GateCode::Filtered      ? VoxelState::Filtered
                     : code == GateCode::RangeFolded ? VoxelState::RangeFolded
                                                     : VoxelState::NotScanned;
  }
}

inline void AddGate(
  const BeamSweep& sweep, std::uint16_t code, float weight, const ValueRule& rule, Tally& about)
{
  if (code < GateCode::FirstValue)
  {
    about.AddNothing(code, weight);
    return;
  }
  const float value = sweep.scale.ValueOf(code);
  about.AddEcho(Interpolated(value, rule), weight, rule);
}

// Weights of cells count in parts of 1/255, as the cells have them.
inline void AddCell(const SweepMeans& means, const SweepMeans::Cell& cell, float weight,
  const ValueRule& rule, Tally& about)
{
  if (cell.missing == 255)
  {
    about.AddNothing(cell.code, 255.0F * weight);
    return;
  }
  const int none = 255 - cell.missing - cell.echo;
  about.none += weight * static_cast<float>(none);
  if (cell.echo > 0)
  {
    const float value = means.scale.ValueOfNumber(static_cast<float>(cell.code));
    about.AddEcho(Interpolated(value, rule), weight * static_cast<float>(cell.echo), rule);
  }
}

// The two cells of a ring between which a direction lies.
struct CellPair
{
  const SweepMeans::Cell* cells;
  float share; // of the second
};

inline CellPair FindCells(
  const SweepMeans& means, std::size_t number, const RayPlace& rays, float azimuth)
{
  const SweepMeans::Ring& ring = means.rings[number];
  const SweepMeans::Cell* first = means.cells.data() + ring.first;
  if (ring.sectors == 0)
  {
    return {first + rays.entry, rays.share};
  }
  const float place = azimuth * ring.sectorsPerDegree + 0.5F;
  const int sector = static_cast<int>(place);
  return {first + sector, place - static_cast<float>(sector)};
}

// What a sweep has about a place where voxels are coarser than its gates or rays (Formulas G10).
inline void ObserveMeans(const SweepMeans& means, const RayPlace& rays, float azimuth, float range,
  const ValueRule& rule, Observed& observed)
{
  const auto last = static_cast<float>(means.rings.size() - 1);
  const float place =
    std::min(std::max((range - means.firstRing) * means.ringsPerMetre, 0.0F), last);
  const auto ring = static_cast<std::size_t>(place);
  const float forth = place - static_cast<float>(ring);
  const CellPair near = FindCells(means, ring, rays, azimuth);
  const CellPair far = forth > 0.0F ? FindCells(means, ring + 1, rays, azimuth) : near;
  // In one question, so that no cell waits for another to come from memory.
  if ((near.cells[0].Word() | near.cells[1].Word() | far.cells[0].Word() | far.cells[1].Word()) ==
      0)
  {
    observed.state = VoxelState::NoEcho;
    return;
  }
  const SweepMeans::Cell cells[4] = {near.cells[0], near.cells[1], far.cells[0], far.cells[1]};
  const float weights[4] = {(1.0F - near.share) * (1.0F - forth), near.share * (1.0F - forth),
    (1.0F - far.share) * forth, far.share * forth};
  const bool echoAlone = (cells[0].echo & cells[1].echo & cells[2].echo & cells[3].echo) == 255;
  if (echoAlone && !rule.linear && rule.period == 0.0F)
  {
    float number = 0.0F;
    for (int i = 0; i < 4; ++i)
    {
      number += weights[i] * static_cast<float>(cells[i].code);
    }
    observed.state = VoxelState::Echo;
    observed.value = means.scale.ValueOfNumber(number);
    return;
  }
  Tally about;
  for (int i = 0; i < 4; ++i)
  {
    AddCell(means, cells[i], weights[i], rule, about);
  }
  Decide(about, rule, observed);
}

// What a sweep has between two of its rays, at a place along them that is counted in gates and lies
// before the end of those that are stored.
inline void ObserveGates(const BeamSweep& sweep, const RayPlace& rays, float place,
  const ValueRule& rule, Observed& observed)
{
  const int gate = static_cast<int>(place);
  const float along = place - static_cast<float>(gate);
  const std::uint16_t* first = sweep.codes.get() +
                               static_cast<std::size_t>(rays.entry) * sweep.Stride() +
                               static_cast<std::size_t>(gate);
  const std::uint16_t* second = first + sweep.Stride();
  if ((first[0] | first[1] | second[0] | second[1]) == GateCode::NoEcho)
  {
    observed.state = VoxelState::NoEcho;
    return;
  }
  const float across = rule.nearest ? std::floor(rays.share + 0.5F) : rays.share;
  const float forth = rule.nearest ? std::floor(along + 0.5F) : along;
  Tally about;
  AddGate(sweep, first[0], (1.0F - across) * (1.0F - forth), rule, about);
  AddGate(sweep, first[1], (1.0F - across) * forth, rule, about);
  AddGate(sweep, second[0], across * (1.0F - forth), rule, about);
  AddGate(sweep, second[1], across * forth, rule, about);
  Decide(about, rule, observed);
}

// A place that a sweep passes, and the rays beside it; without a ray there is no place.
struct SweepPlace
{
  RayPlace rays = {-1, 0.0F};
  float range = 0.0F; // m, slant range
  float gate = 0.0F;  // the same in gates
};

// When and with what beam a sweep passed over a column, and what is known of it without its gates:
// where there are some, no echo. Observed values are filled where they stand, not handed on:
// `observed` must be as it is made.
inline SweepPlace FindPlace(const BeamSweep& sweep, float begin, const ColumnDirection& column,
  const SamplingContext& context, Observed& observed)
{
  SweepPlace place;
  place.range = RangeOver(sweep, column, context.effectiveRadius);
  place.gate = (place.range - sweep.firstGate) * sweep.gatesPerMetre;
  if (!(place.gate >= -0.5F))
  {
    return place;
  }
  place.rays = FindRays(sweep, column.azimuth);
  if (place.rays.entry < 0)
  {
    return place;
  }
  observed.time = TimeOf(sweep, begin, place.rays);
  observed.elevation = ElevationOf(sweep, place.rays);
  observed.state = VoxelState::NoEcho;
  if (place.gate > static_cast<float>(sweep.gates) - 0.5F)
  {
    observed.state = BeyondReach(sweep, column, context);
    observed.assumed = observed.state == VoxelState::NoEcho;
    place.rays.entry = -1;
  }
  return place;
}

inline void Observe(const BeamSweep& sweep, float begin, const ColumnDirection& column,
  const SamplingContext& context, Observed& observed)
{
  const SweepPlace place = FindPlace(sweep, begin, column, context, observed);
  if (place.rays.entry < 0)
  {
    return;
  }
  if (place.range < sweep.means.reach)
  {
    ObserveMeans(sweep.means, place.rays, column.azimuth, place.range, context.rule, observed);
    return;
  }
  const float gate = std::clamp(place.gate, 0.0F, static_cast<float>(sweep.gates - 1));
  if (gate < static_cast<float>(sweep.storedGates))
  {
    ObserveGates(sweep, place.rays, gate, context.rule, observed);
  }
}

// The nearer state where one of two sides must be chosen; else both echoes blended.
Observed BlendObserved(
  const Observed& lower, const Observed& upper, float share, const ValueRule& rule)
{
  if (lower.state == VoxelState::NotScanned || upper.state == VoxelState::NotScanned)
  {
    return {};
  }
  Observed blended = share < 0.5F ? lower : upper;
  blended.time = lower.time + share * (upper.time - lower.time);
  blended.elevation = lower.elevation + share * (upper.elevation - lower.elevation);
  if (lower.state == VoxelState::Echo && upper.state == VoxelState::Echo && !rule.nearest)
  {
    blended.value = Blend(lower.value, upper.value, share, rule);
  }
  return blended;
}

// What two sweeps tell of the tilt between them.
Observed ObserveBetween(
  const TiltObservation& observation, const ColumnDirection& column, const SamplingContext& context)
{
  Observed lower;
  Observed upper;
  Observe(*observation.lower, observation.lowerBegin, column, context, lower);
  Observe(*observation.upper, observation.upperBegin, column, context, upper);
  return BlendObserved(lower, upper, observation.shareOfUpper, context.rule);
}

inline void Observe(const TiltObservation& observation, const ColumnDirection& column,
  const SamplingContext& context, Observed& observed)
{
  if (observation.upper == nullptr)
  {
    Observe(*observation.lower, observation.lowerBegin, column, context, observed);
  }
  else
  {
    observed = ObserveBetween(observation, column, context);
  }
}

// Formulas A1, for values on either side of which one may be no echo.
void BlendTimes(const Observed& before, const Observed& after, float share,
  const SamplingContext& context, TiltSample& sample)
{
  const bool echoBefore = before.state == VoxelState::Echo;
  const bool echoAfter = after.state == VoxelState::Echo;
  const ValueRule& rule = context.rule;
  const Observed& nearer = share < 0.5F ? before : after;
  if (echoBefore && echoAfter)
  {
    sample.state = VoxelState::Echo;
    sample.value =
      rule.nearest ? nearer.value : Blend(before.value, after.value, share, context.rule);
    return;
  }
  const bool measured = !IsUnknown(before.state) && !IsUnknown(after.state);
  if (measured && echoBefore != echoAfter && rule.zeroIsNone)
  {
    const float zero = rule.linear ? 1.0F : 0.0F;
    sample.value = echoBefore ? before.value + share * (zero - before.value)
                              : zero + share * (after.value - zero);
    sample.state = sample.value > zero ? VoxelState::Echo : VoxelState::NoEcho;
    return;
  }
  // A folded or a filtered gate tells nothing: the other side stands alone.
  const Observed& told = measured ? nearer : IsUnknown(before.state) ? after : before;
  sample.state = told.state;
  sample.value = told.value;
}

// A sweep at the place where the echo of a column was at the time of its own rays. `observed` must
// be as it is made.
inline void ObserveAlong(const BeamSweep& sweep, float begin, float time,
  const ColumnDirection& column, const ColumnMotion& motion, const SamplingContext& context,
  Observed& observed)
{
  Observe(sweep, begin, DirectionAt(column, motion, time), context, observed);
  // Across the seam, where the last ray of a sweep meets the first, the time is another.
  constexpr float seam = 2.0F; // s, in which no echo moves as far as voxels are wide
  const float found = observed.time;
  if (observed.state != VoxelState::NotScanned && !(std::abs(found - time) < seam))
  {
    observed = {};
    Observe(sweep, begin, DirectionAt(column, motion, found), context, observed);
  }
}

// When a sweep passed over a column; where it has no ray, at its beginning.
inline float TimeOver(const BeamSweep& sweep, float begin, const ColumnDirection& column)
{
  const RayPlace rays = FindRays(sweep, column.azimuth);
  return rays.entry < 0 ? begin : TimeOf(sweep, begin, rays);
}

// An observation over the column, and of what.
struct FoundObservation
{
  Observed observed;
  const TiltObservation* observation = nullptr;
};

// As ObserveAlong, of two sweeps.
Observed ObserveAlongBetween(const TiltObservation& of, const ColumnDirection& column,
  const ColumnMotion& motion, const SamplingContext& context)
{
  Observed lower;
  Observed upper;
  ObserveAlong(*of.lower, of.lowerBegin, TimeOver(*of.lower, of.lowerBegin, column), column, motion,
    context, lower);
  ObserveAlong(*of.upper, of.upperBegin, TimeOver(*of.upper, of.upperBegin, column), column, motion,
    context, upper);
  return BlendObserved(lower, upper, of.shareOfUpper, context.rule);
}

inline void ObserveAlong(const FoundObservation& found, const ColumnDirection& column,
  const ColumnMotion& motion, const SamplingContext& context, Observed& observed)
{
  const TiltObservation& of = *found.observation;
  if (of.upper == nullptr)
  {
    ObserveAlong(*of.lower, of.lowerBegin, found.observed.time, column, motion, context, observed);
  }
  else
  {
    observed = ObserveAlongBetween(of, column, motion, context);
  }
}

// How much of an observation is to be found: all, or when and with what beam it was taken, and
// whether it scanned the place, which needs no gates of a sweep that is complete.
enum class ObservedDetail
{
  All,
  Circumstances
};

inline bool IsKnownWithoutGates(const TiltObservation& observation)
{
  return observation.upper == nullptr && observation.lower->complete;
}

// The first observation of a list that saw the column on its side of the time, within the gap. What
// is assumed beyond the gates of one observation gives way to what another measured. `found` must
// be as it is made.
inline void FindObserved(const std::vector<TiltObservation>& observations,
  const ColumnDirection& column, const SamplingContext& context, bool after, ObservedDetail detail,
  FoundObservation& found)
{
  FoundObservation assumed;
  for (const TiltObservation& observation : observations)
  {
    if (detail == ObservedDetail::Circumstances && IsKnownWithoutGates(observation))
    {
      FindPlace(*observation.lower, observation.lowerBegin, column, context, found.observed);
    }
    else
    {
      Observe(observation, column, context, found.observed);
    }
    const bool near = std::abs(found.observed.time) <= context.gap;
    if (found.observed.state != VoxelState::NotScanned && (found.observed.time > 0.0F) == after)
    {
      if (!found.observed.assumed && near)
      {
        found.observation = &observation;
        return;
      }
      if (!found.observed.assumed)
      {
        break;
      }
      if (near && assumed.observation == nullptr)
      {
        assumed = {found.observed, &observation};
      }
    }
    found.observed = {};
  }
  found = assumed;
}

// Samples the gates that FindObserved passed over.
inline void Complete(
  FoundObservation& found, const ColumnDirection& column, const SamplingContext& context)
{
  if (found.observation != nullptr && IsKnownWithoutGates(*found.observation))
  {
    found.observed = {};
    Observe(*found.observation, column, context, found.observed);
  }
}

inline bool TellsSomething(const Observed& observed)
{
  return observed.state == VoxelState::Echo || observed.state == VoxelState::NoEcho;
}

// Samples along the motion in place of two over a column; false where they are of no help (Formulas
// A2a). `source` and `target` must be as they are made.
inline bool FollowMotion(const FoundObservation& before, const FoundObservation& after,
  const ColumnDirection& column, const ColumnMotion& motion, const SamplingContext& context,
  Observed& source, Observed& target)
{
  ObserveAlong(before, column, motion, context, source);
  ObserveAlong(after, column, motion, context, target);
  return TellsSomething(source) && TellsSomething(target);
}

// h/(a_e + h) of a beam over a column (Formulas G7).
inline float RatioOver(float tangent, const ColumnDirection& column)
{
  const float t = column.halfTangent;
  return (tangent + t) * 2.0F * t / (1.0F + t * t);
}

// The same the other way round: tan(elevation).
inline float TangentTo(float ratio, const ColumnDirection& column)
{
  constexpr float leastHalfTangent = 1e-7F; // straight above the antenna there is no answer
  const float t = std::max(column.halfTangent, leastHalfTangent);
  return ratio * (1.0F + t * t) / (2.0F * t) - t;
}

// The observation at a tilt about a column that was taken nearest in time to another, along the
// motion.
Observed ObserveAlongNear(const BeamTilt& tilt, float time, const ColumnDirection& column,
  const ColumnMotion& motion, const SamplingContext& context)
{
  FoundObservation before;
  FoundObservation after;
  FindObserved(tilt.before, column, context, false, ObservedDetail::Circumstances, before);
  FindObserved(tilt.after, column, context, true, ObservedDetail::Circumstances, after);
  const auto apart = [time](const FoundObservation& found)
  {
    return found.observation != nullptr ? std::abs(found.observed.time - time)
                                        : std::numeric_limits<float>::infinity();
  };
  const FoundObservation& nearest = apart(after) < apart(before) ? after : before;
  Observed along;
  if (nearest.observation != nullptr)
  {
    ObserveAlong(nearest, column, motion, context, along);
  }
  return along;
}

// The neighbouring tilts about a height over a column, and how far it lies on the way to the upper
// one.
struct TiltPlace
{
  std::size_t lower;
  std::size_t upper;
  float share;
};

// Below the lowest tilt and above the highest these themselves, as long as they are not too far
// off: over some kilometres echo changes more along the ground than with height.
std::optional<TiltPlace> FindTiltPlace(const std::vector<BeamTilt>& tilts, float ratio,
  const ColumnDirection& column, const SamplingContext& context)
{
  constexpr float farthest = 2'000.0F; // m
  const float tangent = TangentTo(ratio, column);
  const auto above = std::find_if(
    tilts.begin(), tilts.end(), [tangent](const BeamTilt& tilt) { return tilt.tangent > tangent; });
  const auto upper = static_cast<std::size_t>(above - tilts.begin());
  if (upper > 0 && upper < tilts.size())
  {
    const float from = tilts[upper - 1].tangent;
    return TiltPlace{upper - 1, upper, (tangent - from) / (tilts[upper].tangent - from)};
  }
  const std::size_t outermost = upper > 0 ? upper - 1 : upper;
  const float off =
    context.effectiveRadius * std::abs(RatioOver(tilts[outermost].tangent, column) - ratio);
  return off <= farthest ? std::optional<TiltPlace>({outermost, outermost, 0.0F}) : std::nullopt;
}

// Puts in place of the only observation over a column at a tilt what the radar saw at the
// observation's time where the column's echo was or will be, at the same height: without an
// observation on the other side of the time, nothing makes up for the slope of the tilt (Formulas
// A2a).
void FollowMotionAlone(const std::vector<BeamTilt>& tilts, std::size_t tilt, Observed& alone,
  const ColumnDirection& column, const ColumnMotion& motion, const SamplingContext& context)
{
  if (!TellsSomething(alone))
  {
    return;
  }
  const ColumnDirection source = DirectionAt(column, motion, alone.time);
  const std::optional<TiltPlace> place =
    FindTiltPlace(tilts, RatioOver(tilts[tilt].tangent, column), source, context);
  if (!place)
  {
    return;
  }
  const Observed lower = ObserveAlongNear(tilts[place->lower], alone.time, column, motion, context);
  const Observed upper = place->upper == place->lower ? lower
                                                      : ObserveAlongNear(tilts[place->upper],
                                                          alone.time, column, motion, context);
  const Observed& nearer = place->share < 0.5F ? lower : upper;
  TiltSample moved;
  if (TellsSomething(lower) && TellsSomething(upper))
  {
    BlendTimes(lower, upper, place->share, context, moved);
  }
  else
  {
    moved.state = nearer.state;
    moved.value = nearer.value;
  }
  const bool echo = moved.state == VoxelState::Echo;
  if (echo || (moved.state == VoxelState::NoEcho && alone.state == VoxelState::Echo))
  {
    alone.state = moved.state;
    alone.value = moved.value;
    alone.assumed = nearer.assumed && !echo;
  }
}

// How much the observation after counts between two (Formulas A1, A6). Where a sweep was in
// progress, a observation along the motion may be from just across the time.
inline float ShareOfAfter(const Observed& before, const Observed& after, float gap)
{
  const float since = std::max(-before.time, 0.0F);
  const float until = std::max(after.time, 0.0F);
  const float weightBefore = until * FadeOf(since, gap);
  const float weightAfter = since * FadeOf(until, gap);
  const float sum = weightBefore + weightAfter;
  return sum > 0.0F ? weightAfter / sum : until < since ? 1.0F : 0.0F;
}

inline float Ramp(float value, float from, float to)
{
  return std::clamp((value - from) / (to - from), 0.0F, 1.0F);
}

// The same along the motion, where cells grow and decay between the observations: the stronger one
// counts more (Formulas A2b).
inline float ShareAmongCells(const Observed& before, const Observed& after, float share)
{
  const float first = before.state == VoxelState::Echo ? before.value : 0.0F;
  const float second = after.state == VoxelState::Echo ? after.value : 0.0F;
  const float part =
    Ramp(std::max(first, second), 30.0F, 40.0F) * Ramp(std::abs(first - second), 3.0F, 8.0F);
  const float weaker = first > second ? share : 1.0F - share;
  const float less = part * (weaker - weaker * weaker * std::sqrt(weaker)); // to weaker^2.5
  return first > second ? share - less : share + less;
}

// One observation without its counterpart, as it is.
void SampleOf(const Observed& observed, float gap, TiltSample& sample)
{
  sample.state = observed.state;
  sample.assumed = observed.assumed;
  sample.value = observed.value;
  sample.lowest = observed.elevation;
  sample.highest = observed.elevation;
  sample.age = std::abs(observed.time);
  sample.fade = FadeOf(sample.age, gap);
}

} // namespace

ColumnDirection DirectionAt(
  const ColumnDirection& column, const ColumnMotion& motion, float seconds)
{
  constexpr float degrees = 57.2957795F;
  const float along = column.halfTangent + motion.away * seconds;
  const float across = motion.clockwise * seconds;
  const float turn = across / along;
  // Far from the radar the turn is small: three terms of its series are off by 3e-5.
  const float angle = along > 0.0F && std::abs(turn) < 0.3F
                        ? turn * (1.0F - turn * turn * (1.0F / 3.0F - 0.2F * turn * turn))
                        : std::atan2(across, along);
  float azimuth = column.azimuth + degrees * angle;
  azimuth = azimuth < 0.0F ? azimuth + 360.0F : azimuth;
  azimuth = azimuth < 360.0F ? azimuth : azimuth - 360.0F;
  return {azimuth, std::sqrt(along * along + across * across)};
}

// Samples are filled where they stand, not handed on: a copy would wait for what was just written.
void SampleTilt(const std::vector<BeamTilt>& tilts, std::size_t number,
  const ColumnDirection& column, const SamplingContext& context, const ColumnMotion* motion,
  bool nothingAbout, TiltSample& sample)
{
  const BeamTilt& tilt = tilts[number];
  FoundObservation before;
  FoundObservation after;
  const bool moves = motion != nullptr && (motion->away != 0.0F || motion->clockwise != 0.0F);
  const bool follow = moves && !nothingAbout;
  const ObservedDetail detail = follow ? ObservedDetail::Circumstances : ObservedDetail::All;
  FindObserved(tilt.before, column, context, false, detail, before);
  FindObserved(tilt.after, column, context, true, detail, after);
  if (before.observation == nullptr || after.observation == nullptr)
  {
    FoundObservation& alone = before.observation == nullptr ? after : before;
    if (follow)
    {
      Complete(alone, column, context);
    }
    if (alone.observation != nullptr && motion != nullptr)
    {
      FollowMotionAlone(tilts, number, alone.observed, column, *motion, context);
    }
    if (alone.observation != nullptr)
    {
      SampleOf(alone.observed, context.gap, sample);
    }
    return;
  }
  sample.lowest = std::min(before.observed.elevation, after.observed.elevation);
  sample.highest = std::max(before.observed.elevation, after.observed.elevation);
  sample.age = std::min(-before.observed.time, after.observed.time);
  sample.fade =
    std::max(FadeOf(-before.observed.time, context.gap), FadeOf(after.observed.time, context.gap));
  Observed source;
  Observed target;
  const bool moved =
    follow && FollowMotion(before, after, column, *motion, context, source, target);
  if (follow && !moved)
  {
    Complete(before, column, context);
    Complete(after, column, context);
  }
  const Observed& first = moved ? source : before.observed;
  const Observed& second = moved ? target : after.observed;
  sample.assumed = first.assumed || second.assumed;
  if (first.state == VoxelState::NoEcho && second.state == VoxelState::NoEcho)
  {
    sample.state = VoxelState::NoEcho;
    return;
  }
  float share = ShareOfAfter(first, second, context.gap);
  if (moved && context.rule.zeroIsNone && !context.rule.linear)
  {
    share = ShareAmongCells(first, second, share);
  }
  BlendTimes(first, second, share, context, sample);
}

} // namespace nexrad
