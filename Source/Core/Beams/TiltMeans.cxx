// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/TiltMeans.h"

#include "nexrad/Beams/BeamSweep.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace nexrad
{

namespace
{

// The ring of each gate; TiltMeans::Rings where it lies beyond.
std::vector<std::size_t> RingsOf(const BeamSweep& sweep, const BeamModel& beam)
{
  std::vector<std::size_t> rings;
  for (int gate = 0; gate < sweep.gates; ++gate)
  {
    const BeamPoint point = beam.Locate(RangeOf(sweep, gate), static_cast<double>(sweep.elevation));
    const double ring = point.groundDistance / TiltMeans::RingWidth;
    rings.push_back(ring >= 0.0 && ring < static_cast<double>(TiltMeans::Rings)
                      ? static_cast<std::size_t>(ring)
                      : TiltMeans::Rings);
  }
  return rings;
}

constexpr float unknown = std::numeric_limits<float>::quiet_NaN();

// Means of one sector after the other.
class SectorMeans
{
public:
  SectorMeans(const BeamSweep& theSweep, std::vector<std::size_t> ringOfGate)
    : sweep(theSweep)
    , rings(std::move(ringOfGate))
    , gatesOf(TiltMeans::Rings + 1)
    , sums(TiltMeans::Rings)
  {
    for (const std::size_t ring : rings)
    {
      ++gatesOf[ring];
    }
    float before = unknown;
    for (std::size_t ring = 0; ring < TiltMeans::Rings; ++ring)
    {
      before = gatesOf[ring] > 0 ? 0.0F : this->IsBetween(ring) ? before : unknown;
      quiet.push_back(before);
    }
    while (!quiet.empty() && std::isnan(quiet.back()))
    {
      quiet.pop_back();
    }
  }

  // Up to the last one with gates.
  std::size_t RingCount() const { return quiet.size(); }

  // Adds a ray of the sector.
  void Add(std::size_t entry)
  {
    ++rays;
    const std::uint16_t* codes = sweep.Row(entry);
    for (std::size_t gate = sweep.held[entry].begin; gate < sweep.held[entry].end; ++gate)
    {
      const std::uint16_t code = codes[gate];
      const std::size_t ring = rings[gate];
      if (code == GateCode::NoEcho || ring >= TiltMeans::Rings)
      {
        continue;
      }
      first = std::min(first, ring);
      last = std::max(last, ring);
      if (code >= GateCode::FirstValue)
      {
        sums[ring].value += sweep.scale.ValueOf(code);
      }
      else
      {
        ++sums[ring].missing;
      }
    }
  }

  // Appends the means of the rays that were added, and forgets these. Returns between which places
  // the means are above 0 dBZ.
  TiltMeans::Span AppendTo(std::vector<float>& all)
  {
    TiltMeans::Span echo;
    all.insert(all.end(), quiet.begin(), quiet.end());
    float* const means = all.data() + all.size() - quiet.size();
    if (rays == 0)
    {
      std::fill(means, means + quiet.size(), unknown);
    }
    for (std::size_t ring = first; ring <= last || this->IsBetween(ring); ++ring)
    {
      means[ring] = this->IsBetween(ring) ? means[ring - 1] : this->MeanOf(ring);
      if (means[ring] > 0.0F)
      {
        const auto middle = static_cast<float>(ring) + 0.5F;
        echo.begin = std::min(echo.begin, middle - 1.0F);
        echo.end = middle + 1.0F;
      }
      sums[ring] = {};
    }
    rays = 0;
    first = TiltMeans::Rings;
    last = 0;
    return echo;
  }

private:
  struct Sum
  {
    int missing = 0;    // gates that were not measured
    float value = 0.0F; // of the others, dBZ, no echo as 0
  };

  // Rings narrower than the gates take the mean of the ring before.
  bool IsBetween(std::size_t ring) const
  {
    return ring + 1 < TiltMeans::Rings && gatesOf[ring] == 0 && gatesOf[ring + 1] > 0;
  }

  float MeanOf(std::size_t ring) const
  {
    const int gates = rays * gatesOf[ring];
    const int measured = gates - sums[ring].missing;
    return 2 * measured > gates ? sums[ring].value / static_cast<float>(measured) : unknown;
  }

  const BeamSweep& sweep;
  const std::vector<std::size_t> rings; // of each gate
  std::vector<int> gatesOf;             // of one ray in each ring
  std::vector<float> quiet;             // means where no ray holds anything, to the last known one
  std::vector<Sum> sums;                // of each ring; empty but from first to last
  int rays = 0;
  std::size_t first = TiltMeans::Rings;
  std::size_t last = 0;
};

constexpr std::size_t shareSectors = 72;
constexpr std::size_t raysPerSector = TiltMeans::Sectors / shareSectors;
constexpr std::size_t shareRings = LayerShares::Rings;
constexpr double shareRingWidth = LayerShares::RingWidth;
constexpr std::size_t stepsPerRing = 2;

// Whether echo lies in layers is a matter of the weather and not of single gates: the differences
// are summed over so many cells about each.
constexpr std::ptrdiff_t sectorsBeside = 3; // 35° in all
constexpr std::ptrdiff_t ringsBeside = 4;   // 36 km in all

// Squared differences between two tilts, dB², by cell.
struct Differences
{
  std::vector<float> vertical; // straight above each other
  std::vector<float> level;    // at equal height
};

// Where two tilts stand at the height in the middle between them, in rings of TiltMeans.
struct ComparedPlaces
{
  float over = -1.0F;
  float lower = -1.0F;
  float upper = -1.0F;
};

ComparedPlaces FindPlaces(double lower, double upper, double distance, const BeamModel& beam)
{
  const double height = beam.HeightOver(distance, 0.5 * (lower + upper));
  if (!(height > 0.0 && std::isfinite(height)))
  {
    return {};
  }
  const auto inRings = [](double metres)
  { return static_cast<float>(metres / TiltMeans::RingWidth); };
  return {inRings(distance), inRings(beam.DistanceAt(height, lower)),
    inRings(beam.DistanceAt(height, upper))};
}

// Echo below 0 dBZ counts as none: its differences say little of where the weather is.
float EchoAt(const TiltMeans& tilt, std::size_t sector, float place)
{
  const float value = tilt.At(sector, place);
  return value < 0.0F ? 0.0F : value;
}

Differences Compare(const TiltMeans& lower, const TiltMeans& upper, const BeamModel& beam)
{
  Differences sums{
    std::vector<float>(shareSectors * shareRings), std::vector<float>(shareSectors * shareRings)};
  std::vector<ComparedPlaces> places;
  for (std::size_t step = 0; step < shareRings * stepsPerRing; ++step)
  {
    const double distance = (static_cast<double>(step) + 0.5) * shareRingWidth / stepsPerRing;
    places.push_back(FindPlaces(static_cast<double>(lower.Elevation()),
      static_cast<double>(upper.Elevation()), distance, beam));
  }
  for (std::size_t ray = 1; ray < TiltMeans::Sectors; ray += 2)
  {
    const TiltMeans::Span below = lower.EchoIn(ray);
    const TiltMeans::Span above = upper.EchoIn(ray);
    const float begin = std::min(below.begin, above.begin);
    const float end = std::max(below.end, above.end);
    for (std::size_t step = 0; step < places.size(); ++step)
    {
      const ComparedPlaces& at = places[step];
      // The upper tilt is that high before the lower one is.
      if (at.lower < begin || at.upper > end)
      {
        continue;
      }
      const float vertical = EchoAt(upper, ray, at.over) - EchoAt(lower, ray, at.over);
      const float level = EchoAt(upper, ray, at.upper) - EchoAt(lower, ray, at.lower);
      if (!std::isnan(vertical + level))
      {
        const std::size_t cell = ray / raysPerSector * shareRings + step / stepsPerRing;
        sums.vertical[cell] += vertical * vertical;
        sums.level[cell] += level * level;
      }
    }
  }
  return sums;
}

// Sums over the cells about each cell.
std::vector<float> SumAround(const std::vector<float>& from)
{
  std::vector<float> alongRings(from.size());
  constexpr auto count = static_cast<std::ptrdiff_t>(shareRings);
  for (std::size_t sector = 0; sector < shareSectors; ++sector)
  {
    const float* row = from.data() + sector * shareRings;
    for (std::ptrdiff_t ring = 0; ring < count; ++ring)
    {
      const std::ptrdiff_t end = std::min(ring + ringsBeside + 1, count);
      float& sum = alongRings[sector * shareRings + static_cast<std::size_t>(ring)];
      for (std::ptrdiff_t each = std::max<std::ptrdiff_t>(ring - ringsBeside, 0); each < end;
           ++each)
      {
        sum += row[each];
      }
    }
  }
  std::vector<float> around(from.size());
  for (std::size_t sector = 0; sector < shareSectors; ++sector)
  {
    for (std::ptrdiff_t off = -sectorsBeside; off <= sectorsBeside; ++off)
    {
      const auto turned = static_cast<std::ptrdiff_t>(sector + shareSectors) + off;
      const float* row =
        alongRings.data() + static_cast<std::size_t>(turned) % shareSectors * shareRings;
      std::transform(around.begin() + static_cast<std::ptrdiff_t>(sector * shareRings),
        around.begin() + static_cast<std::ptrdiff_t>((sector + 1) * shareRings), row,
        around.begin() + static_cast<std::ptrdiff_t>(sector * shareRings), std::plus<>());
    }
  }
  return around;
}

// The errors of the two interpolations follow from these differences: on left-out tilts of real
// volumes 0.42 of the difference straight up and 0.65 of that at equal height, with a correlation
// of about one half. The share is the one of least squared error.
float ShareOf(float vertical, float level)
{
  constexpr float ratio = 0.42F / 0.65F;
  if (!(vertical > 0.0F))
  {
    return 0.0F;
  }
  const float errors = level > 0.0F ? ratio * std::sqrt(vertical / level) : 1e6F;
  const float share = errors * (errors - 0.5F) / (errors * (errors - 1.0F) + 1.0F);
  return std::clamp(share, 0.0F, 1.0F);
}

void AddTo(std::vector<float>& sums, const std::vector<float>& others)
{
  std::transform(sums.begin(), sums.end(), others.begin(), sums.begin(), std::plus<>());
}

} // namespace

TiltMeans::TiltMeans(const BeamSweep& sweep, const BeamModel& beam)
  : elevation(sweep.elevation)
{
  const std::vector<std::size_t> rings = RingsOf(sweep, beam);
  last = static_cast<float>(rings.empty() ? 0 : rings.back());
  SectorMeans sums(sweep, rings);
  ringCount = sums.RingCount();
  means.reserve(Sectors * ringCount);
  std::size_t entry = 1; // the first repeats the last ray
  for (std::size_t sector = 0; sector < Sectors; ++sector)
  {
    const float end = static_cast<float>(sector + 1);
    const std::size_t first = entry;
    for (; entry + 1 < sweep.azimuths.size() && sweep.azimuths[entry] < end; ++entry)
    {
      sums.Add(entry);
    }
    const int nearest = entry == first ? NearestEntry(sweep, end - 0.5F) : -1;
    if (nearest >= 0)
    {
      sums.Add(static_cast<std::size_t>(nearest));
    }
    echoes.push_back(sums.AppendTo(means));
  }
}

LayerShares::LayerShares(const std::vector<TiltMeans>& tilts, const BeamModel& beam)
{
  std::vector<Differences> differences;
  for (std::size_t i = 0; i + 1 < tilts.size(); ++i)
  {
    const Differences sums = Compare(tilts[i], tilts[i + 1], beam);
    differences.push_back({SumAround(sums.vertical), SumAround(sums.level)});
  }
  for (std::size_t i = 0; i < differences.size(); ++i)
  {
    Differences pooled = differences[i];
    for (std::size_t beside = std::max<std::size_t>(i, 1) - 1;
         beside < std::min(i + 2, differences.size()); ++beside)
    {
      if (beside != i)
      {
        AddTo(pooled.vertical, differences[beside].vertical);
        AddTo(pooled.level, differences[beside].level);
      }
    }
    std::vector<float> ofGap(shareSectors * shareRings);
    std::transform(
      pooled.vertical.begin(), pooled.vertical.end(), pooled.level.begin(), ofGap.begin(), ShareOf);
    shares.push_back(std::move(ofGap));
  }
}

const float* LayerShares::Row(std::size_t gap, std::size_t sector) const
{
  return shares[gap].data() + sector / raysPerSector * shareRings;
}

} // namespace nexrad
