// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Beams/TiltMeans.h"

#include "nexrad/Beams/BeamSweep.h"
#include "nexrad/Beams/SweepPlaces.h"

#include <algorithm>
#include <cmath>
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
  }

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

  // Writes the means of the rays that were added, and forgets these. Returns between which places
  // the means are above 0 dBZ.
  TiltMeans::Span Write(float* means)
  {
    TiltMeans::Span echo;
    std::copy(quiet.begin(), quiet.end(), means);
    if (rays == 0)
    {
      std::fill(means, means + TiltMeans::Rings, unknown);
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
  std::vector<float> quiet;             // means where no ray holds anything
  std::vector<Sum> sums;                // of each ring; empty but from first to last
  int rays = 0;
  std::size_t first = TiltMeans::Rings;
  std::size_t last = 0;
};

} // namespace

TiltMeans::TiltMeans(const BeamSweep& sweep, const BeamModel& beam)
  : elevation(sweep.elevation)
  , last(0.0F)
  , means(Sectors * Rings)
{
  const std::vector<std::size_t> rings = RingsOf(sweep, beam);
  last = static_cast<float>(rings.empty() ? 0 : rings.back());
  SectorMeans sums(sweep, rings);
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
    echoes.push_back(sums.Write(means.data() + sector * Rings));
  }
}

} // namespace nexrad
