// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/BeamColumn.h"

#include "nexrad/Beams/TiltEdges.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

SiteLevels::SiteLevels(
  const GridSpecification& grid, double altitude, double effectiveRadius, double overlapLength)
  : radius(static_cast<float>(effectiveRadius))
  , bottom(static_cast<float>(grid.origin[2] - altitude))
  , perMetre(static_cast<float>(1.0 / grid.spacing[2]))
{
  for (int level = 0; level < grid.dimensions[2]; ++level)
  {
    const double height = grid.Coordinate(2, level) - altitude;
    const double part = overlapLength > 0.0 ? height / overlapLength : 0.0;
    ratio.push_back(static_cast<float>(height / (effectiveRadius + height)));
    weight.push_back(static_cast<float>(std::exp(-part * part)));
  }
}

namespace
{

// Straight above the antenna every elevation is 90°; so near to it the beams' heights are none.
constexpr float smallestHalfTangent = 1e-7F; // 2 m

// Where the beams end below and above a tilt. Rays lie beside their tilt; what a ray saw reaches
// half a beam width to either side of it, and not of the tilt (Formulas G3). A tilt that holds
// sweeps of several elevations keeps its own place within, so that no ray hides a neighbour.
float LowerEdge(const TiltEdges& tilt, const TiltSample& sample)
{
  const bool seen = sample.state != VoxelState::NotScanned;
  const float beside = seen ? tilt.perDegree * (sample.lowest - tilt.elevation) : 0.0F;
  return std::min(tilt.lower + beside, tilt.tangent);
}

float UpperEdge(const TiltEdges& tilt, const TiltSample& sample)
{
  const bool seen = sample.state != VoxelState::NotScanned;
  const float beside = seen ? tilt.perDegree * (sample.highest - tilt.elevation) : 0.0F;
  return std::max(tilt.upper + beside, tilt.tangent);
}

// How high beams pass over a column.
class HeightsOver
{
public:
  explicit HeightsOver(const SiteColumn& site)
    : radius(site.levels->radius)
    , bottom(site.levels->bottom)
    , perMetre(site.levels->perMetre)
    , count(static_cast<float>(site.levels->ratio.size()))
    , t(std::max(site.halfTangent, smallestHalfTangent))
    , sine(2.0F * t / (1.0F + t * t))
  {
  }

  // h/(a_e + h) at the tangent of an elevation.
  float RatioAt(float tangent) const { return (tangent + t) * sine; }

  // The first level at or above that.
  int LevelAt(float tangent) const
  {
    const float ratio = this->RatioAt(tangent);
    // Nearly straight up the formula has no answer, and none is needed.
    const float height = ratio < 0.1F ? radius * ratio / (1.0F - ratio) : 1e6F;
    const float level = std::clamp((height - bottom) * perMetre, 0.0F, count);
    const int below = static_cast<int>(level);
    return static_cast<float>(below) < level ? below + 1 : below;
  }

private:
  const float radius; // copies: nothing else can change them
  const float bottom;
  const float perMetre;
  const float count;
  const float t;
  const float sine;
};

// Whether layers change anything in the gap above a tilt.
bool ChangedByLayers(const SiteColumn& site, std::size_t tilt)
{
  return site.layers != nullptr && site.layers[tilt].Any();
}

// An echo of 0 dBZ or less beside none: it would not differ from none where no echo counts as 0
// dBZ.
bool IsWeakEdge(const TiltSample& lower, const TiltSample& upper)
{
  return lower.state != upper.state &&
         (lower.state == VoxelState::Echo ? lower : upper).value <= 0.0F;
}

} // namespace

// Two neighbouring tilts over a column, or one tilt and the edge of its beam. Most gaps need few of
// the levels that can be asked for.
struct BeamColumn::Gap
{
  const HeightsOver& over;
  const TiltSample* lower;
  const TiltSample* upper;
  const TiltEdges* ofLower; // nullptr below the lowest tilt
  const TiltEdges* ofUpper; // nullptr above the highest tilt
  std::size_t tilt;         // the lower one, when there are two
  int from;                 // first level of the gap
  int to;                   // first level above it

  bool HasTwo() const { return ofLower != nullptr && ofUpper != nullptr; }
  // The first level half a beam width above the lower tilt.
  int LowerEnd() const
  {
    return ofLower != nullptr ? over.LevelAt(UpperEdge(*ofLower, *lower)) : from;
  }
  // The first level within half a beam width of the upper tilt.
  int UpperBegin() const
  {
    return ofUpper != nullptr ? over.LevelAt(LowerEdge(*ofUpper, *upper)) : to;
  }
  // The first level nearer to the upper tilt.
  int Middle() const
  {
    return this->HasTwo() ? std::clamp(over.LevelAt(ofLower->middle), from, to) : from;
  }
  // Where the echo of one of two tilts ends when the other has none (Formulas G8).
  int EchoEnd() const
  {
    const bool below = lower->state == VoxelState::Echo;
    return std::clamp(over.LevelAt(below ? ofLower->endAbove : ofLower->endBelow), from, to);
  }
};

BeamColumn::BeamColumn(int levels, OverlapStrategy theStrategy, const ValueRule& theRule,
  bool withAncillaryArrays, bool withTrend)
  : levelCount(levels)
  , strategy(theStrategy)
  , rule(theRule)
  , ancillary(withAncillaryArrays)
  , trend(withTrend && theRule.zeroIsNone && !theRule.linear)
{
  const auto count = static_cast<std::size_t>(levels);
  for (std::vector<float>* each : {&scanned, &echo, &sum, &ages, &weights, &shares, &values})
  {
    each->assign(count, 0.0F);
  }
  for (std::vector<std::uint8_t>* each : {&radars, &nearestSites})
  {
    each->assign(count, 0);
  }
  states.assign(count, VoxelState::NotScanned);
  unknown = states;
}

void BeamColumn::Clear()
{
  std::fill(scanned.begin(), scanned.end(), 0.0F);
  for (std::vector<float>* each : {&echo, &sum})
  {
    std::fill(each->begin() + echoFrom, each->begin() + echoTo, 0.0F);
  }
  echoFrom = echoTo = 0;
  if (anyUnknown)
  {
    std::fill(unknown.begin(), unknown.end(), VoxelState::NotScanned);
    anyUnknown = false;
  }
  if (ancillary)
  {
    std::fill(ages.begin(), ages.end(), 0.0F);
    std::fill(radars.begin(), radars.end(), std::uint8_t(0));
    std::fill(nearestSites.begin(), nearestSites.end(), NoSite);
  }
}

void BeamColumn::Add(const SiteColumn& site)
{
  const std::vector<TiltEdges>& edges = *site.edges;
  const TiltSample* samples = site.samples;
  const HeightsOver over(site);
  static constexpr TiltSample nothing;
  int from = over.LevelAt(LowerEdge(edges.front(), samples[0]));
  for (std::size_t i = 0; i <= edges.size() && from < levelCount; ++i)
  {
    // The gap below tilt i: the first reaches down from it, the last up from the tilt before.
    const bool hasLower = i > 0;
    const bool hasUpper = i < edges.size();
    const float end = hasUpper ? edges[i].tangent : UpperEdge(edges.back(), samples[i - 1]);
    const Gap gap{over, hasLower ? &samples[i - 1] : &nothing, hasUpper ? &samples[i] : &nothing,
      hasLower ? &edges[i - 1] : nullptr, hasUpper ? &edges[i] : nullptr, hasLower ? i - 1 : 0,
      from, std::max(from, over.LevelAt(end))};
    if (gap.from < gap.to &&
        (gap.lower->state != VoxelState::NotScanned || gap.upper->state != VoxelState::NotScanned))
    {
      this->AddGap(site, gap);
    }
    from = gap.to;
  }
}

std::pair<int, int> BeamColumn::QuietLevels(
  const SiteColumn& site, std::size_t firstTilt, std::size_t endTilt) const
{
  if (firstTilt == endTilt)
  {
    return {0, 0};
  }
  const std::vector<TiltEdges>& edges = *site.edges;
  const HeightsOver over(site);
  const std::size_t last = endTilt - 1;
  int from = over.LevelAt(LowerEdge(edges[firstTilt], site.samples[firstTilt]));
  int to = over.LevelAt(edges[last].tangent);
  to = to < levelCount ? over.LevelAt(UpperEdge(edges[last], site.samples[last])) : to;
  // Beside a tilt that did not scan the column, half a beam width counts, but not beyond that tilt.
  from = firstTilt > 0 ? std::max(from, over.LevelAt(edges[firstTilt - 1].tangent)) : from;
  to = endTilt < edges.size() ? std::min(to, over.LevelAt(edges[endTilt].tangent)) : to;
  return from < to ? std::pair(from, to) : std::pair(0, 0);
}

void BeamColumn::AddQuiet(const SiteColumn& site, std::size_t firstTilt, std::size_t endTilt)
{
  const auto [from, to] = this->QuietLevels(site, firstTilt, endTilt);
  const float* ofLevel = site.levels->weight.data();
  for (int z = from; z < to; ++z)
  {
    weights[static_cast<std::size_t>(z)] = site.weight * ofLevel[z];
  }
  this->AccumulateNone(from, to);
}

void BeamColumn::AddGap(const SiteColumn& site, const Gap& gap)
{
  const VoxelState lower = gap.lower->state;
  const VoxelState upper = gap.upper->state;
  const bool measuredLower = lower == VoxelState::Echo || lower == VoxelState::NoEcho;
  const bool measuredUpper = upper == VoxelState::Echo || upper == VoxelState::NoEcho;
  if (measuredLower && measuredUpper)
  {
    if (lower == VoxelState::NoEcho && upper == VoxelState::NoEcho &&
        !(trend && ChangedByLayers(site, gap.tilt)))
    {
      this->AddNone(site, gap, gap.from, gap.to);
    }
    else if (trend && !IsWeakEdge(*gap.lower, *gap.upper))
    {
      this->AddTrend(site, gap);
    }
    else if (lower == upper && !rule.nearest)
    {
      this->AddEcho(site, gap, gap.from, gap.to, gap.lower->value, gap.upper->value);
    }
    else
    {
      this->AddEdge(site, gap);
    }
    return;
  }
  // What is not measured carries no weight: the other counts within half a beam width (G3).
  if (IsUnknown(lower) || IsUnknown(upper))
  {
    const int from =
      lower == VoxelState::NotScanned ? std::max(gap.from, gap.UpperBegin()) : gap.from;
    const int to = upper == VoxelState::NotScanned ? std::min(gap.to, gap.LowerEnd()) : gap.to;
    const bool isFolded = lower == VoxelState::RangeFolded || upper == VoxelState::RangeFolded;
    this->AddUnknown(isFolded ? VoxelState::RangeFolded : VoxelState::Filtered, from, to);
  }
  if (measuredLower)
  {
    this->AddState(site, gap, *gap.lower, gap.from, std::min(gap.to, gap.LowerEnd()));
  }
  if (measuredUpper)
  {
    this->AddState(site, gap, *gap.upper, std::max(gap.from, gap.UpperBegin()), gap.to);
  }
}

// Between an echo and none: reflectivity falls towards 0 dBZ, others end midway (Formulas G8).
void BeamColumn::AddEdge(const SiteColumn& site, const Gap& gap)
{
  const bool echoBelow = gap.lower->state == VoxelState::Echo;
  const float value = echoBelow ? gap.lower->value : gap.upper->value;
  const float zero = rule.linear ? 1.0F : 0.0F;
  const bool sameState = gap.lower->state == gap.upper->state; // of a moment that takes the nearest
  if (sameState || !rule.zeroIsNone || value <= zero)
  {
    const int middle = gap.Middle();
    this->AddState(site, gap, *gap.lower, gap.from, middle);
    this->AddState(site, gap, *gap.upper, middle, gap.to);
    return;
  }
  const float beyond = value + (zero - value) / gap.ofLower->endShare;
  const int end = gap.EchoEnd();
  if (echoBelow)
  {
    this->AddEcho(site, gap, gap.from, end, value, beyond);
    this->AddNone(site, gap, end, gap.to);
  }
  else
  {
    this->AddNone(site, gap, gap.from, end);
    this->AddEcho(site, gap, end, gap.to, beyond, value);
  }
}

// Reflectivity between two tilts that both measured (Formulas G11, G12): above 0 dBZ it is an echo,
// and so it is wherever both tilts have one.
void BeamColumn::AddTrend(const SiteColumn& site, const Gap& gap)
{
  this->ShareLevels(site, gap, gap.from, gap.to);
  const TiltInterpolation upwards(
    ValuesAbout(site.samples, site.edges->size(), gap.tilt), *gap.ofLower);
  for (int level = gap.from; level < gap.to; ++level)
  {
    const auto at = static_cast<std::size_t>(level);
    values[at] = upwards.At(shares[at]);
  }
  if (ChangedByLayers(site, gap.tilt))
  {
    const EchoLayers::Changes changes = site.layers[gap.tilt];
    for (int level = gap.from; level < gap.to; ++level)
    {
      const auto at = static_cast<std::size_t>(level);
      values[at] = changes.Apply(values[at], shares[at]);
    }
  }
  this->WeighLevels(site, gap, gap.from, gap.to);
  this->AccumulateTrend(gap);
  this->AddAncillary(site, gap, gap.from, gap.to);
}

// What layers alone tell must be more than their changes are precise.
void BeamColumn::AccumulateTrend(const Gap& gap)
{
  const bool below = gap.lower->state == VoxelState::Echo;
  const bool above = gap.upper->state == VoxelState::Echo;
  if (below && above)
  {
    this->AccumulateEcho(gap.from, gap.to);
    return;
  }
  const float least = below || above ? 0.0F : EchoLayers::Precision;
  const auto isEcho = [this, least](int level)
  { return values[static_cast<std::size_t>(level)] > least; };
  for (int begin = gap.from; begin < gap.to;)
  {
    const bool echoes = isEcho(begin);
    int end = begin + 1;
    while (end < gap.to && isEcho(end) == echoes)
    {
      ++end;
    }
    echoes ? this->AccumulateEcho(begin, end) : this->AccumulateNone(begin, end);
    begin = end;
  }
}

void BeamColumn::AddState(
  const SiteColumn& site, const Gap& gap, const TiltSample& sample, int from, int to)
{
  if (sample.state == VoxelState::Echo)
  {
    this->AddEcho(site, gap, from, to, sample.value, sample.value);
  }
  else
  {
    this->AddNone(site, gap, from, to);
  }
}

void BeamColumn::ShareLevels(const SiteColumn& site, const Gap& gap, int from, int to)
{
  const float* ratio = site.levels->ratio.data();
  float ratioFrom = 0.0F; // at the lower tilt
  float perRatio = 0.0F;  // 1 / its difference to the upper tilt
  float bend = 0.0F;
  if (gap.HasTwo())
  {
    ratioFrom = gap.over.RatioAt(gap.ofLower->tangent);
    perRatio = 1.0F / (gap.over.RatioAt(gap.ofUpper->tangent) - ratioFrom);
    bend = gap.ofLower->bend;
  }
  float* share = shares.data();
  for (int z = from; z < to; ++z)
  {
    const float linear = std::clamp((ratio[z] - ratioFrom) * perRatio, 0.0F, 1.0F);
    share[z] = linear + bend * linear * (1.0F - linear);
  }
}

void BeamColumn::WeighLevels(const SiteColumn& site, const Gap& gap, int from, int to)
{
  const float* ofLevel = site.levels->weight.data();
  float* weight = weights.data();
  const bool both = gap.lower->fade > 0.0F && gap.upper->fade > 0.0F;
  const float lower =
    site.weight * (both ? gap.lower->fade : std::max(gap.lower->fade, gap.upper->fade));
  const float upper = both ? site.weight * gap.upper->fade : lower;
  if (lower == upper)
  {
    for (int z = from; z < to; ++z)
    {
      weight[z] = lower * ofLevel[z];
    }
    return;
  }
  this->ShareLevels(site, gap, from, to);
  for (int z = from; z < to; ++z)
  {
    weight[z] = (lower + shares[static_cast<std::size_t>(z)] * (upper - lower)) * ofLevel[z];
  }
}

void BeamColumn::AddNone(const SiteColumn& site, const Gap& gap, int from, int to)
{
  this->WeighLevels(site, gap, from, to);
  this->AccumulateNone(from, to);
  this->AddAncillary(site, gap, from, to);
}

void BeamColumn::AccumulateNone(int from, int to)
{
  const bool nearestAlone = strategy == OverlapStrategy::Nearest;
  const float* weight = weights.data();
  float* all = scanned.data();
  for (int z = from; z < to; ++z)
  {
    all[z] = nearestAlone && all[z] > 0.0F ? all[z] : all[z] + weight[z];
  }
}

void BeamColumn::AddEcho(
  const SiteColumn& site, const Gap& gap, int from, int to, float lower, float upper)
{
  this->WeighLevels(site, gap, from, to);
  float* value = values.data();
  if (lower == upper)
  {
    std::fill(value + from, value + std::max(from, to), lower);
  }
  else
  {
    this->ShareLevels(site, gap, from, to);
    const float difference =
      rule.period > 0.0F ? std::remainder(upper - lower, rule.period) : upper - lower;
    for (int z = from; z < to; ++z)
    {
      value[z] = lower + shares[static_cast<std::size_t>(z)] * difference;
    }
  }
  this->AccumulateEcho(from, to);
  this->AddAncillary(site, gap, from, to);
}

void BeamColumn::AccumulateEcho(int from, int to)
{
  if (from < to)
  {
    echoFrom = echoTo > 0 ? std::min(echoFrom, from) : from;
    echoTo = std::max(echoTo, to);
  }
  const float* value = values.data();
  const float* weight = weights.data();
  float* all = scanned.data();
  float* seen = echo.data();
  float* total = sum.data();
  if (strategy == OverlapStrategy::Maximum)
  {
    for (int z = from; z < to; ++z)
    {
      total[z] = seen[z] > 0.0F ? std::max(total[z], value[z]) : value[z];
      seen[z] += weight[z];
      all[z] += weight[z];
    }
    return;
  }
  const bool nearestAlone = strategy == OverlapStrategy::Nearest;
  for (int z = from; z < to; ++z)
  {
    const float counted = nearestAlone && all[z] > 0.0F ? 0.0F : weight[z];
    total[z] += counted * value[z];
    seen[z] += counted;
    all[z] += counted;
  }
}

void BeamColumn::AddUnknown(VoxelState state, int from, int to)
{
  anyUnknown = true;
  for (int z = from; z < to; ++z)
  {
    VoxelState& known = unknown[static_cast<std::size_t>(z)];
    known = known == VoxelState::RangeFolded ? known : state;
  }
}

void BeamColumn::AddAncillary(const SiteColumn& site, const Gap& gap, int from, int to)
{
  if (!ancillary)
  {
    return;
  }
  const int middle = gap.Middle();
  for (int z = from; z < to; ++z)
  {
    const auto at = static_cast<std::size_t>(z);
    const bool upper = gap.lower->fade == 0.0F || (gap.upper->fade > 0.0F && z >= middle);
    const float age = upper ? gap.upper->age : gap.lower->age;
    ages[at] = radars[at] == 0 ? age : std::min(ages[at], age);
    nearestSites[at] = radars[at] == 0 ? static_cast<std::uint8_t>(std::min(site.site, NoSite - 1))
                                       : nearestSites[at];
    ++radars[at];
  }
}

bool BeamColumn::HasEcho() const
{
  return std::any_of(echo.begin(), echo.end(), [](float weight) { return weight > 0.0F; });
}

bool BeamColumn::HasSameSums(const BeamColumn& other) const
{
  return scanned == other.scanned && echo == other.echo && sum == other.sum &&
         unknown == other.unknown && (!ancillary || (ages == other.ages && radars == other.radars));
}

void BeamColumn::Finish(float fill)
{
  const float* all = scanned.data();
  const VoxelState* other = unknown.data();
  VoxelState* state = states.data();
  for (int z = 0; z < levelCount; ++z)
  {
    const VoxelState known = other[z];
    state[z] = all[z] > 0.0F ? VoxelState::NoEcho : known;
  }
  std::fill(values.begin(), values.end(), fill);
  const float half = strategy == OverlapStrategy::Maximum ? 0.0F : 0.5F;
  for (auto z = static_cast<std::size_t>(echoFrom); z < static_cast<std::size_t>(echoTo); ++z)
  {
    const bool isEcho = echo[z] > 0.0F && echo[z] >= half * scanned[z];
    const float mean = strategy == OverlapStrategy::Maximum ? sum[z] : sum[z] / echo[z];
    values[z] = isEcho ? mean : fill;
    states[z] = isEcho ? VoxelState::Echo : states[z];
  }
  if (rule.linear || rule.period > 0.0F)
  {
    this->ConvertEchoes();
  }
}

void BeamColumn::ConvertEchoes()
{
  for (std::size_t z = 0; z < values.size(); ++z)
  {
    if (states[z] == VoxelState::Echo)
    {
      const float turns = rule.linear ? 0.0F : std::floor(values[z] / rule.period);
      values[z] = rule.linear ? 10.0F * std::log10(values[z]) : values[z] - turns * rule.period;
    }
  }
}

void BeamColumn::FillColumn()
{
  std::size_t next = 0; // lowest level not yet dealt with
  for (std::size_t z = 0; z < states.size(); ++z)
  {
    if (states[z] == VoxelState::NotScanned)
    {
      continue;
    }
    for (std::size_t empty = next; empty < z; ++empty)
    {
      // Part of the way from one known voxel to another; the nearer one when one has no value.
      const std::size_t from = next == 0 ? z : next - 1;
      const auto gap = static_cast<float>(z - next + 1);
      const float part = next == 0 ? 1.0F : static_cast<float>(empty - next + 1) / gap;
      const bool bothEcho = states[from] == VoxelState::Echo && states[z] == VoxelState::Echo;
      const std::size_t nearer = part < 0.5F ? from : z;
      states[empty] = states[nearer];
      values[empty] = bothEcho ? values[from] + part * (values[z] - values[from]) : values[nearer];
    }
    next = z + 1;
  }
}

} // namespace nexrad
