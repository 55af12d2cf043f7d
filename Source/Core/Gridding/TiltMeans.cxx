// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/TiltMeans.h"

#include "Gridding/BeamVolume.h"
#include "Gridding/SweepPlaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

// The gates of the rays of one sector.
class SectorSums
{
public:
  void Add(const BeamSweep& sweep, std::size_t entry, const std::vector<std::size_t>& rings)
  {
    ++rays;
    if (LargestCode(sweep, entry) == BeamSweep::NoEchoCode)
    {
      return;
    }
    quiet = false;
    const std::uint16_t* codes = sweep.codes.data() + entry * sweep.Stride();
    for (std::size_t gate = 0; gate < rings.size(); ++gate)
    {
      const std::uint16_t code = codes[gate];
      if (code == BeamSweep::NoEchoCode)
      {
        continue;
      }
      Sum& sum = sums[rings[gate]];
      if (code >= BeamSweep::FirstValueCode)
      {
        sum.value += sweep.base + sweep.step * static_cast<float>(code);
      }
      else
      {
        ++sum.missing;
      }
    }
  }

  // Whether there are rays, and none that holds anything.
  bool IsQuiet() const { return rays > 0 && quiet; }

  // `gatesOf` are those of one ray in each ring. Rings narrower than the gates take the mean of the
  // ring before. Returns between which places the means are above 0 dBZ.
  TiltMeans::Span Write(const std::vector<int>& gatesOf, float* means) const
  {
    TiltMeans::Span echo;
    float before = unknown;
    for (std::size_t ring = 0; ring < TiltMeans::Rings; ++ring)
    {
      const int gates = rays * gatesOf[ring];
      const int measured = gates - sums[ring].missing;
      const bool between =
        gatesOf[ring] == 0 && ring + 1 < TiltMeans::Rings && gatesOf[ring + 1] > 0;
      float mean = unknown;
      if (2 * measured > gates)
      {
        // Most sums are 0, and need no division.
        const float sum = sums[ring].value;
        mean = sum == 0.0F ? 0.0F : sum / static_cast<float>(measured);
      }
      before = between ? before : mean;
      means[ring] = before;
      if (before > 0.0F)
      {
        const auto middle = static_cast<float>(ring) + 0.5F;
        echo.begin = std::min(echo.begin, middle - 1.0F);
        echo.end = middle + 1.0F;
      }
    }
    return echo;
  }

private:
  struct Sum
  {
    int missing = 0;    // gates that were not measured
    float value = 0.0F; // of the others, dBZ, no echo as 0
  };
  int rays = 0;
  bool quiet = true; // no ray holds anything but no echo
  std::array<Sum, TiltMeans::Rings + 1> sums;
};

} // namespace

TiltMeans::TiltMeans(const BeamSweep& sweep, const BeamModel& beam)
  : elevation(sweep.elevation)
  , last(0.0F)
{
  const std::vector<std::size_t> rings = RingsOf(sweep, beam);
  last = static_cast<float>(rings.empty() ? 0 : rings.back());
  std::vector<int> gatesOf(Rings + 1, 0);
  for (const std::size_t ring : rings)
  {
    ++gatesOf[ring];
  }
  std::size_t entry = 1; // the first repeats the last ray
  means.resize(Sectors * Rings);
  std::vector<float> quietRow; // what each sector has in which no ray holds anything
  for (std::size_t sector = 0; sector < Sectors; ++sector)
  {
    SectorSums sums;
    const float end = static_cast<float>(sector + 1);
    const std::size_t first = entry;
    for (; entry + 1 < sweep.azimuths.size() && sweep.azimuths[entry] < end; ++entry)
    {
      sums.Add(sweep, entry, rings);
    }
    const int nearest = entry == first ? NearestEntry(sweep, end - 0.5F) : -1;
    if (nearest >= 0)
    {
      sums.Add(sweep, static_cast<std::size_t>(nearest), rings);
    }
    float* row = means.data() + sector * Rings;
    if (!sums.IsQuiet())
    {
      echoes.push_back(sums.Write(gatesOf, row));
      continue;
    }
    if (quietRow.empty())
    {
      quietRow.resize(Rings);
      sums.Write(gatesOf, quietRow.data());
    }
    std::copy(quietRow.begin(), quietRow.end(), row);
    echoes.push_back({});
  }
}

} // namespace nexrad
