// SPDX-License-Identifier: BSD-3-Clause
#include "LeftOutTilts.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/Elevation.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double nearest = 20'000.0;   // m: nearer gates see the ground
constexpr double farthest = 100'000.0; // m: beyond, gaps are wider than most echo is high
constexpr double highest = 18'000.0;   // m above the radar

bool IsAt(const PolarSweep& sweep, double tilt)
{
  return std::abs(MedianElevation(sweep) - tilt) < SameTilt;
}

std::vector<double> TiltsOf(const PolarVolume& volume)
{
  std::vector<double> tilts;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    const auto same = [&sweep](double tilt) { return IsAt(sweep, tilt); };
    if (std::none_of(tilts.begin(), tilts.end(), same))
    {
      tilts.push_back(MedianElevation(sweep));
    }
  }
  std::sort(tilts.begin(), tilts.end());
  return tilts;
}

// What one gate is foretold as.
struct GateForecast
{
  double point = 0.0; // dBZ
  double beam = 0.0;
};

// The mean of Z over the two-way pattern of a beam of 0.95°, upwards and downwards; nothing where
// the middle of the beam was not seen.
std::optional<GateForecast> ForecastAt(const ElevationProfile& profile, double elevation)
{
  const std::optional<double> middle = profile(elevation);
  if (!middle)
  {
    return std::nullopt;
  }
  const double sigma = 0.95 / std::sqrt(16.0 * std::log(2.0));
  double sum = 0.0;
  double weights = 0.0;
  for (int node = -3; node <= 3; ++node)
  {
    const double off = 0.8 * node; // standard deviations
    if (const auto value = node == 0 ? middle : profile(elevation + off * sigma))
    {
      const double weight = std::exp(-0.5 * off * off);
      sum += *value > 0.0 ? weight * std::pow(10.0, *value / 10.0) : 0.0;
      weights += weight;
    }
  }
  return GateForecast{*middle, 10.0 * std::log10(std::max(sum / weights, 1.0))};
}

void AddGate(const PolarRay& ray, double range, double measured,
  const std::vector<const TiltScheme*>& schemes, std::vector<SchemeErrors>& errors)
{
  std::vector<GateForecast> forecasts;
  for (const TiltScheme* scheme : schemes)
  {
    const auto forecast = ForecastAt(scheme->ProfileAt(static_cast<double>(ray.azimuth), range),
      static_cast<double>(ray.elevation));
    if (!forecast)
    {
      return;
    }
    forecasts.push_back(*forecast);
  }
  for (std::size_t i = 0; i < schemes.size(); ++i)
  {
    errors[i].point.Add(forecasts[i].point, measured);
    errors[i].beam.Add(forecasts[i].beam, measured);
  }
}

} // namespace

void GateErrors::Add(double foretold, double measured)
{
  const double error = foretold - measured;
  if (std::max(foretold, measured) >= 10.0)
  {
    squares += error * error;
    sum += error;
    ++gates;
  }
  if (foretold >= 10.0)
  {
    sumOfForetold += error;
    ++gatesForetold;
  }
  if (std::max(foretold, measured) > 0.0)
  {
    sumOfEcho += error;
    ++gatesWithEcho;
  }
}

double GateErrors::Rmse() const
{
  return std::sqrt(squares / static_cast<double>(gates));
}

double GateErrors::Bias() const
{
  return sum / static_cast<double>(gates);
}

double GateErrors::BiasOfForetold() const
{
  return sumOfForetold / static_cast<double>(gatesForetold);
}

double GateErrors::BiasOfEcho() const
{
  return sumOfEcho / static_cast<double>(gatesWithEcho);
}

std::vector<LeftOutTilt> LeaveTiltsOut(const PolarVolume& whole)
{
  const std::vector<double> tilts = TiltsOf(whole);
  std::vector<LeftOutTilt> all;
  for (std::size_t tilt = 1; tilt + 1 < tilts.size(); ++tilt)
  {
    LeftOutTilt left{whole, {}, tilts[tilt + 1] + 0.5, farthest};
    left.others.sweeps.clear();
    for (const PolarSweep& sweep : whole.sweeps)
    {
      if (!IsAt(sweep, tilts[tilt]))
      {
        left.others.sweeps.push_back(sweep);
      }
      else if (left.measured.rays.empty())
      {
        left.measured = sweep;
      }
    }
    left.farthest =
      std::min(farthest, highest / std::sin(std::max(tilts[tilt], 1.0) * RadiansPerDegree));
    all.push_back(std::move(left));
  }
  return all;
}

std::vector<SortedTilt> SortTilts(const PolarVolume& volume)
{
  std::vector<SortedTilt> tilts;
  for (const double tilt : TiltsOf(volume))
  {
    tilts.emplace_back(*std::find_if(volume.sweeps.begin(), volume.sweeps.end(),
      [tilt](const PolarSweep& sweep) { return IsAt(sweep, tilt); }));
  }
  return tilts;
}

void AddErrors(const LeftOutTilt& tilt, const std::vector<const TiltScheme*>& schemes,
  std::vector<SchemeErrors>& errors)
{
  errors.resize(schemes.size());
  const testing::NumberSweep sweep = testing::NumbersOf(tilt.measured);
  const auto step = static_cast<std::size_t>(std::max(1.0, std::round(1000.0 / sweep.gateSpacing)));
  const std::size_t rayStep = sweep.rays.size() > 540 ? 2 : 1;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ray += rayStep)
  {
    for (std::size_t gate = 0; gate < sweep.gates; gate += step)
    {
      const double range = sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate);
      const auto measured = MeasuredAt(sweep, ray, gate);
      if (measured && range >= nearest && range <= tilt.farthest)
      {
        AddGate(sweep.rays[ray], range, *measured, schemes, errors);
      }
    }
  }
}

} // namespace nexrad
