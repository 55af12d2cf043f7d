// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/BeamTilts.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

// Not-a-number where nothing was measured.
float ValueOf(const TiltSample& sample)
{
  const bool none = sample.state == VoxelState::NoEcho && !sample.assumed;
  return sample.state == VoxelState::Echo ? sample.value
         : none                           ? 0.0F
                                          : std::numeric_limits<float>::quiet_NaN();
}

using SweepList = std::vector<const BeamSweep*>;

float SecondsFrom(Time time, Time to)
{
  return static_cast<float>((to - time).count()) / 1000.0F;
}

float SpanOf(const BeamSweep& sweep)
{
  return SecondsFrom(sweep.begin, sweep.end);
}

// The sweeps of one tilt, of all volumes, and of each volume.
struct TiltSweeps
{
  float elevation = 0.0F;
  std::vector<SweepList> ofVolume;
};

std::vector<TiltSweeps> GroupByElevation(const std::vector<const BeamVolume*>& volumes)
{
  std::vector<std::pair<const BeamSweep*, std::size_t>> sweeps;
  for (std::size_t volume = 0; volume < volumes.size(); ++volume)
  {
    for (const BeamSweep& sweep : volumes[volume]->sweeps)
    {
      sweeps.emplace_back(&sweep, volume);
    }
  }
  std::stable_sort(sweeps.begin(), sweeps.end(),
    [](const auto& a, const auto& b) { return a.first->elevation < b.first->elevation; });
  std::vector<TiltSweeps> tilts;
  float lowest = std::numeric_limits<float>::lowest();
  std::size_t count = 0;
  for (const auto& [sweep, volume] : sweeps)
  {
    if (tilts.empty() || sweep->elevation - lowest > static_cast<float>(SameTilt))
    {
      tilts.push_back({0.0F, std::vector<SweepList>(volumes.size())});
      lowest = sweep->elevation;
      count = 0;
    }
    TiltSweeps& tilt = tilts.back();
    ++count;
    tilt.elevation += (sweep->elevation - tilt.elevation) / static_cast<float>(count);
    tilt.ofVolume[volume].push_back(sweep);
  }
  return tilts;
}

// Of repeated cuts, the one scanned nearest in time to another sweep.
const BeamSweep* NearestInTime(const SweepList& sweeps, const BeamSweep& other)
{
  const auto apart = [&other](const BeamSweep* sweep)
  { return std::abs((sweep->begin - other.begin).count()); };
  return *std::min_element(sweeps.begin(), sweeps.end(),
    [&apart](const BeamSweep* a, const BeamSweep* b) { return apart(a) < apart(b); });
}

// What the sweeps of a volume below and above a tilt tell of it, when it has some on both sides.
TiltObservation Between(const std::vector<TiltSweeps>& tilts, std::size_t tilt, std::size_t volume)
{
  if (tilt == 0 || tilt + 1 == tilts.size())
  {
    return {};
  }
  std::size_t below = tilt - 1;
  while (below > 0 && tilts[below].ofVolume[volume].empty())
  {
    --below;
  }
  std::size_t above = tilt + 1;
  while (above + 1 < tilts.size() && tilts[above].ofVolume[volume].empty())
  {
    ++above;
  }
  const SweepList& lower = tilts[below].ofVolume[volume];
  const SweepList& upper = tilts[above].ofVolume[volume];
  if (lower.empty() || upper.empty())
  {
    return {};
  }
  TiltObservation observation;
  observation.lower = lower.back();
  observation.upper = NearestInTime(upper, *observation.lower);
  observation.shareOfUpper = (tilts[tilt].elevation - observation.lower->elevation) /
                             (observation.upper->elevation - observation.lower->elevation);
  return observation;
}

// Puts an observation among those before and after the time, unless all of it is too far away.
void AddObservation(BeamTilt& tilt, TiltObservation observation, Time time, float gap)
{
  observation.lowerBegin = SecondsFrom(time, observation.lower->begin);
  observation.upperBegin =
    observation.upper != nullptr ? SecondsFrom(time, observation.upper->begin) : 0.0F;
  if (observation.Begin() <= 0.0F && observation.End() >= -gap)
  {
    tilt.before.push_back(observation);
  }
  if (observation.End() > 0.0F && observation.Begin() <= gap)
  {
    tilt.after.push_back(observation);
  }
}

// The latest observation before the time first, and the earliest after it.
void SortByTime(BeamTilt& tilt)
{
  const auto earlier = [](const TiltObservation& a, const TiltObservation& b)
  { return a.Begin() < b.Begin(); };
  std::stable_sort(tilt.before.begin(), tilt.before.end(),
    [&earlier](const auto& a, const auto& b) { return earlier(b, a); });
  std::stable_sort(tilt.after.begin(), tilt.after.end(), earlier);
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

bool TiltObservation::IsWhole(bool after) const
{
  return upper == nullptr && (after ? this->Begin() > 0.0F : this->End() <= 0.0F) &&
         lower->IsClosed();
}

float TiltObservation::Begin() const
{
  return upper == nullptr ? lowerBegin : std::min(lowerBegin, upperBegin);
}

float TiltObservation::End() const
{
  const float end = lowerBegin + SpanOf(*lower);
  return upper == nullptr ? end : std::max(end, upperBegin + SpanOf(*upper));
}

std::vector<BeamTilt> FindTilts(
  const std::vector<const BeamVolume*>& volumes, Time time, Duration gap)
{
  const float seconds = static_cast<float>(gap.count()) / 1000.0F;
  const std::vector<TiltSweeps> groups = GroupByElevation(volumes);
  std::vector<BeamTilt> tilts;
  for (std::size_t i = 0; i < groups.size(); ++i)
  {
    BeamTilt tilt;
    tilt.elevation = groups[i].elevation;
    tilt.tangent = static_cast<float>(std::tan(groups[i].elevation * RadiansPerDegree));
    for (const SweepList& sweeps : groups[i].ofVolume)
    {
      for (const BeamSweep* sweep : sweeps)
      {
        AddObservation(tilt, {sweep}, time, seconds);
      }
    }
    if (tilt.before.empty() && tilt.after.empty())
    {
      continue;
    }
    BeamTilt substitutes;
    for (std::size_t volume = 0; volume < volumes.size(); ++volume)
    {
      const SweepList& own = groups[i].ofVolume[volume];
      const bool strays =
        std::any_of(own.begin(), own.end(), [](const BeamSweep* sweep) { return sweep->strays; });
      const TiltObservation between =
        own.empty() || strays ? Between(groups, i, volume) : TiltObservation{};
      if (between.lower != nullptr)
      {
        AddObservation(own.empty() ? tilt : substitutes, between, time, seconds);
      }
    }
    SortByTime(tilt);
    SortByTime(substitutes);
    tilt.before.insert(tilt.before.end(), substitutes.before.begin(), substitutes.before.end());
    tilt.after.insert(tilt.after.end(), substitutes.after.begin(), substitutes.after.end());
    tilts.push_back(std::move(tilt));
  }
  return tilts;
}

} // namespace nexrad
