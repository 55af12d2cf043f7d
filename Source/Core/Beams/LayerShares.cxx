// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/LayerShares.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace nexrad
{

namespace
{

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
