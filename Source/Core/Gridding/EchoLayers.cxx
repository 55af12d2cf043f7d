// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/EchoLayers.h"

#include "Geometry/Angles.h"
#include "Gridding/BeamVolume.h"
#include "Gridding/SweepPlaces.h"
#include "Model/Elevation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

constexpr std::size_t sectors = 72;
constexpr double ringWidth = 4'000.0;    // m
constexpr double farthest = 300'000.0;   // m: beyond, the beam is wider than any layer
constexpr std::size_t raysPerSector = 2; // directions and distances at which a cell is sampled
constexpr std::size_t stepsPerRing = 2;

// The differences are summed over so many cells about each, and over the gaps beside: whether echo
// lies in layers is a matter of the weather and not of single gates.
constexpr std::ptrdiff_t sectorsBeside = 3; // 35° in all
constexpr std::ptrdiff_t ringsBeside = 4;   // 36 km in all

// One sweep of each tilt, the one with the most gates, ascending.
std::vector<const BeamSweep*> OneOfEachTilt(const std::vector<BeamSweep>& sweeps)
{
  std::vector<const BeamSweep*> sorted;
  for (const BeamSweep& sweep : sweeps)
  {
    sorted.push_back(&sweep);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const BeamSweep* a, const BeamSweep* b) { return a->elevation < b->elevation; });
  std::vector<const BeamSweep*> tilts;
  for (const BeamSweep* sweep : sorted)
  {
    if (tilts.empty() || sweep->elevation - tilts.back()->elevation > static_cast<float>(SameTilt))
    {
      tilts.push_back(sweep);
    }
    else if (sweep->codes.size() > tilts.back()->codes.size())
    {
      tilts.back() = sweep;
    }
  }
  return tilts;
}

// Slant range at which a sweep stands at a height h above the antenna.
double RangeAtHeight(const BeamSweep& sweep, double height, double radius)
{
  const double rise = radius * static_cast<double>(sweep.sine);
  return -rise + std::sqrt(rise * rise + 2.0 * radius * height + height * height);
}

// The gates at which one distance is compared: of the two tilts, over the place and at the height
// in the middle between them.
struct GatePlaces
{
  int lowerOver = -1;
  int upperOver = -1;
  int lowerLevel = -1;
  int upperLevel = -1;

  bool AllThere() const { return std::min({lowerOver, upperOver, lowerLevel, upperLevel}) >= 0; }
};

GatePlaces FindPlaces(
  const BeamSweep& lower, const BeamSweep& upper, double distance, double radius)
{
  const double arc = distance / radius;
  const double middle =
    0.5 * static_cast<double>(lower.elevation + upper.elevation) * RadiansPerDegree;
  const double height =
    2.0 * radius * std::sin(middle + 0.5 * arc) * std::sin(0.5 * arc) / std::cos(middle + arc);
  if (!(height > 0.0))
  {
    return {};
  }
  return {GateAt(lower, RangeOver(lower, arc, radius)),
    GateAt(upper, RangeOver(upper, arc, radius)),
    GateAt(lower, RangeAtHeight(lower, height, radius)),
    GateAt(upper, RangeAtHeight(upper, height, radius))};
}

// Reflectivity of a gate, where no echo and echo below 0 dBZ count as 0; not-a-number where nothing
// was measured.
float ValueAt(const BeamSweep& sweep, int entry, int gate)
{
  const std::uint16_t code =
    sweep.codes[static_cast<std::size_t>(entry) * sweep.Stride() + static_cast<std::size_t>(gate)];
  if (code == BeamSweep::NoEchoCode)
  {
    return 0.0F;
  }
  return code < BeamSweep::FirstValueCode
           ? unknown
           : std::max(0.0F, sweep.base + sweep.step * static_cast<float>(code));
}

// Squared differences between two tilts, by cell.
struct Differences
{
  std::vector<float> vertical; // dB², straight above each other
  std::vector<float> level;    // dB², at equal height
};

Differences Compare(
  const BeamSweep& lower, const BeamSweep& upper, std::size_t rings, double radius)
{
  Differences sums{std::vector<float>(sectors * rings), std::vector<float>(sectors * rings)};
  std::vector<GatePlaces> places;
  for (std::size_t step = 0; step < rings * stepsPerRing; ++step)
  {
    const double distance = (static_cast<double>(step) + 0.5) * ringWidth / stepsPerRing;
    places.push_back(FindPlaces(lower, upper, distance, radius));
  }
  for (std::size_t ray = 0; ray < sectors * raysPerSector; ++ray)
  {
    const float azimuth =
      (static_cast<float>(ray) + 0.5F) * 360.0F / static_cast<float>(sectors * raysPerSector);
    const int lowerEntry = NearestEntry(lower, azimuth);
    const int upperEntry = NearestEntry(upper, azimuth);
    if (lowerEntry < 0 || upperEntry < 0)
    {
      continue;
    }
    for (std::size_t step = 0; step < places.size(); ++step)
    {
      const GatePlaces& at = places[step];
      if (!at.AllThere())
      {
        continue;
      }
      const float vertical =
        ValueAt(upper, upperEntry, at.upperOver) - ValueAt(lower, lowerEntry, at.lowerOver);
      const float level =
        ValueAt(upper, upperEntry, at.upperLevel) - ValueAt(lower, lowerEntry, at.lowerLevel);
      if (!std::isnan(vertical + level))
      {
        const std::size_t cell = ray / raysPerSector * rings + step / stepsPerRing;
        sums.vertical[cell] += vertical * vertical;
        sums.level[cell] += level * level;
      }
    }
  }
  return sums;
}

// Sums over the cells about each cell.
std::vector<float> SumAround(const std::vector<float>& from, std::size_t rings)
{
  std::vector<float> alongRings(from.size());
  const auto count = static_cast<std::ptrdiff_t>(rings);
  for (std::size_t sector = 0; sector < sectors; ++sector)
  {
    for (std::ptrdiff_t ring = 0; ring < count; ++ring)
    {
      const auto row = from.begin() + static_cast<std::ptrdiff_t>(sector * rings);
      const auto begin = row + std::max<std::ptrdiff_t>(ring - ringsBeside, 0);
      const auto end = row + std::min<std::ptrdiff_t>(ring + ringsBeside + 1, count);
      float sum = 0.0F;
      for (auto each = begin; each != end; ++each)
      {
        sum += *each;
      }
      alongRings[sector * rings + static_cast<std::size_t>(ring)] = sum;
    }
  }
  std::vector<float> around(from.size());
  for (std::size_t sector = 0; sector < sectors; ++sector)
  {
    for (std::ptrdiff_t off = -sectorsBeside; off <= sectorsBeside; ++off)
    {
      const auto other = (static_cast<std::ptrdiff_t>(sector + sectors) + off) %
                         static_cast<std::ptrdiff_t>(sectors);
      for (std::size_t ring = 0; ring < rings; ++ring)
      {
        around[sector * rings + ring] += alongRings[static_cast<std::size_t>(other) * rings + ring];
      }
    }
  }
  return around;
}

void AddTo(std::vector<float>& sums, const std::vector<float>& others)
{
  std::transform(sums.begin(), sums.end(), others.begin(), sums.begin(), std::plus<>());
}

// The errors of the two interpolations follow from these differences: on left-out tilts of real
// volumes 0.42 of the difference straight up, 0.65 of that at equal height, with a correlation of
// about one half. The share is the one of least squared error.
std::uint8_t ShareOf(float vertical, float level)
{
  constexpr float ratio = 0.42F / 0.65F;
  if (!(vertical > 0.0F))
  {
    return 0;
  }
  const float errors = level > 0.0F ? ratio * std::sqrt(vertical / level) : 1e6F;
  const float share = errors * (errors - 0.5F) / (errors * (errors - 1.0F) + 1.0F);
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

} // namespace

EchoLayers::EchoLayers(const std::vector<BeamSweep>& sweeps, double effectiveRadius)
  : rings(static_cast<std::size_t>(farthest / ringWidth))
  , ringsPerTangent(static_cast<float>(2.0 * effectiveRadius / ringWidth))
{
  const std::vector<const BeamSweep*> tilts = OneOfEachTilt(sweeps);
  std::vector<Differences> differences;
  for (std::size_t i = 0; i + 1 < tilts.size(); ++i)
  {
    const Differences sums = Compare(*tilts[i], *tilts[i + 1], rings, effectiveRadius);
    differences.push_back({SumAround(sums.vertical, rings), SumAround(sums.level, rings)});
  }
  for (std::size_t i = 0; i < differences.size(); ++i)
  {
    Differences pooled = differences[i];
    for (const std::size_t beside : {i - 1, i + 1})
    {
      if (beside < differences.size())
      {
        AddTo(pooled.vertical, differences[beside].vertical);
        AddTo(pooled.level, differences[beside].level);
      }
    }
    Gap gap{tilts[i]->elevation, tilts[i + 1]->elevation, {}};
    gap.shares.resize(pooled.vertical.size());
    std::transform(pooled.vertical.begin(), pooled.vertical.end(), pooled.level.begin(),
      gap.shares.begin(), ShareOf);
    gaps.push_back(std::move(gap));
  }
}

const EchoLayers::Gap* EchoLayers::FindGap(float elevation) const
{
  const auto found = std::find_if(gaps.begin(), gaps.end(),
    [elevation](const Gap& gap) { return gap.lower <= elevation && elevation < gap.upper; });
  return found != gaps.end() ? &*found : nullptr;
}

float EchoLayers::ShareAt(const Gap& gap, const ColumnDirection& column) const
{
  const auto ring = static_cast<std::size_t>(column.halfTangent * ringsPerTangent);
  const auto sector =
    static_cast<std::size_t>(column.azimuth * (static_cast<float>(sectors) / 360.0F));
  return ring < rings ? static_cast<float>(gap.shares[sector * rings + ring]) / 255.0F : 0.0F;
}

std::size_t EchoLayers::MemoryBytes() const
{
  return gaps.size() * (sizeof(Gap) + sectors * rings);
}

} // namespace nexrad
