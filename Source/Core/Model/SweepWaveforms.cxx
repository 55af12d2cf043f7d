// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/SweepWaveforms.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/SiteTable.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace nexrad
{

namespace
{

bool MeasuresVelocity(const Sweep& sweep)
{
  return sweep.Has(MomentName::VEL) || sweep.Has(MomentName::SW);
}

// As message 5 says; Unknown where it has no cut that fits the sweep.
Waveform FindInPattern(const RadarVolume& volume, const Sweep& sweep)
{
  const CoverageCut* cut =
    volume.coveragePattern ? FindCut(*volume.coveragePattern, sweep) : nullptr;
  const bool fits = cut != nullptr &&
                    !(cut->waveform == Waveform::ContiguousSurveillance && MeasuresVelocity(sweep));
  return fits ? cut->waveform : Waveform::Unknown;
}

// As the rays tell; `before` is the sweep scanned before, or nullptr.
Waveform FindInRays(const Sweep& sweep, const Sweep* before, bool terminal)
{
  constexpr double lowestBatch = 1.7;  // degrees
  constexpr double highestBatch = 7.0; // degrees
  if (!MeasuresVelocity(sweep))
  {
    return Waveform::ContiguousSurveillance;
  }
  const double elevation = sweep.MedianElevation();
  if (terminal || elevation > highestBatch)
  {
    return Waveform::ContiguousDopplerWithout;
  }
  const bool split = before != nullptr && before->waveform == Waveform::ContiguousSurveillance &&
                     std::abs(before->MedianElevation() - elevation) <= SameTilt;
  return split || elevation < lowestBatch ? Waveform::ContiguousDoppler : Waveform::Batch;
}

float RangeOf(const Ray& ray, bool terminal)
{
  constexpr float shortest = 50'000.0F;
  constexpr float longest = 1'000'000.0F;
  constexpr float rangeTimesVelocity = 299'792'458.0F * 0.111F / 8.0F; // m²/s
  if (ray.unambiguousRange >= shortest && ray.unambiguousRange <= longest)
  {
    return ray.unambiguousRange;
  }
  const float range = ray.nyquist > 0.0F && !terminal ? rangeTimesVelocity / ray.nyquist : 0.0F;
  return range >= shortest && range <= longest ? range : 0.0F;
}

} // namespace

void ResolveWaveforms(RadarVolume& volume)
{
  const bool terminal = IsTerminal(volume.site);
  const Sweep* before = nullptr;
  for (Sweep& sweep : volume.sweeps)
  {
    const Waveform known = FindInPattern(volume, sweep);
    sweep.waveform = known != Waveform::Unknown ? known : FindInRays(sweep, before, terminal);
    for (Ray& ray : sweep.rays)
    {
      ray.unambiguousRange = RangeOf(ray, terminal);
    }
    before = &sweep;
  }
}

const char* ToString(Waveform waveform)
{
  constexpr std::array<const char*, 6> texts = {"", "contiguous surveillance", "contiguous Doppler",
    "contiguous Doppler without ambiguity resolution", "batch", "staggered pulse pair"};
  return texts[static_cast<std::size_t>(waveform)];
}

} // namespace nexrad
