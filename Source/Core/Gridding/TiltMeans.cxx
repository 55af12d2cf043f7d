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
      ++quietRays;
      return;
    }
    const std::uint16_t* codes = sweep.codes.data() + entry * sweep.Stride();
    for (std::size_t gate = 0; gate < rings.size(); ++gate)
    {
      const std::uint16_t code = codes[gate];
      Sum& sum = sums[rings[gate]];
      if (code == BeamSweep::NoEchoCode || code >= BeamSweep::FirstValueCode)
      {
        ++sum.measured;
        sum.value +=
          code == BeamSweep::NoEchoCode ? 0.0F : sweep.base + sweep.step * static_cast<float>(code);
      }
    }
  }

  // Whether there are rays, and none that holds anything.
  bool IsQuiet() const { return rays > 0 && quietRays == rays; }

  // `gatesOf` are those of one ray in each ring. Rings narrower than the gates take the mean of the
  // ring before. Returns whether any mean is above 0 dBZ.
  bool Write(const std::vector<int>& gatesOf, std::vector<float>& means) const
  {
    float before = unknown;
    bool any = false;
    for (std::size_t ring = 0; ring < TiltMeans::Rings; ++ring)
    {
      const int gates = gatesOf[ring];
      const int measured = sums[ring].measured + quietRays * gates;
      const bool between = gates == 0 && ring + 1 < TiltMeans::Rings && gatesOf[ring + 1] > 0;
      const float mean =
        2 * measured > rays * gates ? sums[ring].value / static_cast<float>(measured) : unknown;
      means.push_back(between ? before : mean);
      before = means.back();
      any = any || before > 0.0F;
    }
    return any;
  }

private:
  struct Sum
  {
    int measured = 0;
    float value = 0.0F;
  };
  int rays = 0;
  int quietRays = 0; // with nothing but no echo
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
  means.reserve(Sectors * Rings);
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
    if (!sums.IsQuiet())
    {
      echoes.push_back(sums.Write(gatesOf, means));
      continue;
    }
    if (quietRow.empty())
    {
      sums.Write(gatesOf, quietRow);
    }
    means.insert(means.end(), quietRow.begin(), quietRow.end());
    echoes.push_back(false);
  }
}

float TiltMeans::At(std::size_t sector, float place) const
{
  const float from = place - 0.5F;
  if (!(from >= 0.0F && from < static_cast<float>(Rings - 1)))
  {
    return std::numeric_limits<float>::quiet_NaN();
  }
  const auto ring = static_cast<std::size_t>(from);
  const float* row = means.data() + sector * Rings + ring;
  return row[0] + (from - static_cast<float>(ring)) * (row[1] - row[0]);
}

} // namespace nexrad
