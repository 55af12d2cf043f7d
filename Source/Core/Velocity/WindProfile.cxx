// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/WindProfile.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace nexrad
{

double Wind::Direction() const
{
  const double direction = std::atan2(-east, -north) / RadiansPerDegree;
  return direction < 0.0 ? direction + 360.0 : direction;
}

std::optional<Wind> WindProfile::At(double height, double reach) const
{
  constexpr double widestGap = 2000.0; // m between levels
  const auto above = std::lower_bound(levels.begin(), levels.end(), height,
    [](const ProfileLevel& level, double value) { return level.height < value; });
  const auto isNear = [&](const ProfileLevel& level)
  { return std::abs(level.height - height) <= reach; };
  if (above != levels.end() && above != levels.begin())
  {
    const ProfileLevel& low = *(above - 1);
    const double gap = above->height - low.height;
    if (gap <= widestGap)
    {
      const double share = (height - low.height) / gap;
      return Wind{low.wind.east + share * (above->wind.east - low.wind.east),
        low.wind.north + share * (above->wind.north - low.wind.north)};
    }
  }
  if (above != levels.end() && isNear(*above))
  {
    return above->wind;
  }
  if (above != levels.begin() && isNear(*(above - 1)))
  {
    return (above - 1)->wind;
  }
  return std::nullopt;
}

double WindProfile::DistanceTo(double height) const
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const ProfileLevel& level : levels)
  {
    nearest = std::min(nearest, std::abs(level.height - height));
  }
  return nearest;
}

namespace
{

constexpr std::size_t sectors = 12;
constexpr double nearestGate =
  3'000.0; // m of ground distance: closer in, side lobes see the ground
constexpr std::size_t gatesOfSector = 10; // that a sector has at least to count
constexpr double mostRms = 5.0;           // m/s
constexpr double mostOffset = 7.0;        // m/s
constexpr double topHeight = 20'000.0;    // m; no weather is higher

// One gate: its velocity is offset + east·u + north·w.
struct Sample
{
  double east;
  double north;
  double velocity;
  std::size_t sector;
};

struct Fit
{
  double offset = 0.0;
  Wind wind;
  double rms = 0.0;
  std::size_t gates = 0;
  std::array<std::size_t, sectors> inSector{};

  double Of(const Sample& sample) const
  {
    return offset + sample.east * wind.east + sample.north * wind.north;
  }
};

// The normal equations of a fit.
class NormalEquations
{
public:
  void Add(const Sample& sample)
  {
    const std::array<double, 3> row = {1.0, sample.east, sample.north};
    for (std::size_t i = 0; i < 3; ++i)
    {
      for (std::size_t j = 0; j < 3; ++j)
      {
        matrix[i][j] += row[i] * row[j];
      }
      matrix[i][3] += row[i] * sample.velocity;
    }
  }

  // By elimination with pivots; empty where the samples determine no wind.
  std::optional<std::array<double, 3>> Solve() const
  {
    auto rows = matrix;
    const double least = 1e-6 * rows[0][0];
    for (std::size_t step = 0; step < 3; ++step)
    {
      const auto pivot = std::max_element(rows.begin() + std::ptrdiff_t(step), rows.end(),
        [step](auto& a, auto& b) { return std::abs(a[step]) < std::abs(b[step]); });
      std::swap(rows[step], *pivot);
      if (!(std::abs(rows[step][step]) > least))
      {
        return std::nullopt;
      }
      for (std::size_t other = 0; other < 3; ++other)
      {
        const double factor = other == step ? 0.0 : rows[other][step] / rows[step][step];
        for (std::size_t column = 0; column < 4; ++column)
        {
          rows[other][column] -= factor * rows[step][column];
        }
      }
    }
    return std::array<double, 3>{
      rows[0][3] / rows[0][0], rows[1][3] / rows[1][1], rows[2][3] / rows[2][2]};
  }

private:
  std::array<std::array<double, 4>, 3> matrix{};
};

// The fit to the samples within a distance, m/s, of an earlier fit.
std::optional<Fit> FitSamples(
  const std::vector<Sample>& samples, const Fit& before, double distance)
{
  NormalEquations equations;
  Fit fit;
  std::vector<const Sample*> used;
  for (const Sample& sample : samples)
  {
    if (std::abs(sample.velocity - before.Of(sample)) <= distance)
    {
      equations.Add(sample);
      used.push_back(&sample);
      ++fit.inSector[sample.sector];
    }
  }
  const auto solution = equations.Solve();
  if (!solution)
  {
    return std::nullopt;
  }
  fit.offset = (*solution)[0];
  fit.wind = {(*solution)[1], (*solution)[2]};
  fit.gates = used.size();
  double squares = 0.0;
  for (const Sample* sample : used)
  {
    const double away = sample->velocity - fit.Of(*sample);
    squares += away * away;
  }
  fit.rms = std::sqrt(squares / static_cast<double>(fit.gates));
  return fit;
}

std::optional<Fit> FitLayer(const std::vector<Sample>& samples)
{
  constexpr int repetitions = 2;
  constexpr double leastDistance = 2.0; // m/s: gates of a perfect wind are not left out
  std::optional<Fit> fit = FitSamples(samples, {}, std::numeric_limits<double>::infinity());
  for (int each = 0; each < repetitions && fit; ++each)
  {
    fit = FitSamples(samples, *fit, std::max(leastDistance, 2.0 * fit->rms));
  }
  return fit;
}

bool IsSound(const Fit& fit)
{
  const auto seen = std::count_if(fit.inSector.begin(), fit.inSector.end(),
    [](std::size_t gates) { return gates >= gatesOfSector; });
  return 2 * std::size_t(seen) >= sectors && fit.rms <= mostRms &&
         std::abs(fit.offset) <= mostOffset;
}

void AddSamples(const VelocitySweep& sweep, const ProfileOptions& options,
  std::vector<std::vector<Sample>>& layers)
{
  const BeamModel beam;
  const double level = std::cos(sweep.elevation * RadiansPerDegree);
  for (std::size_t gate = 0; gate < sweep.gates; ++gate)
  {
    const BeamPoint point = beam.Locate(std::max(0.0, sweep.RangeOf(gate)), sweep.elevation);
    const double place = std::floor(point.height / options.layerDepth);
    if (point.groundDistance < nearestGate || point.groundDistance > options.farthest ||
        place < 0.0 || place >= static_cast<double>(layers.size()))
    {
      continue;
    }
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      const auto value = static_cast<double>(sweep.values[sweep.Index(ray, gate)]);
      if (!std::isnan(value))
      {
        const double azimuth =
          std::fmod(static_cast<double>(sweep.rays[ray].azimuth) + 360.0, 360.0);
        layers[std::size_t(place)].push_back({level * std::sin(azimuth * RadiansPerDegree),
          level * std::cos(azimuth * RadiansPerDegree), value,
          std::size_t(azimuth / 30.0) % sectors});
      }
    }
  }
}

} // namespace

WindProfile FitWindProfile(const VelocityVolume& volume, const ProfileOptions& options)
{
  std::vector<std::vector<Sample>> layers(std::size_t(topHeight / options.layerDepth));
  for (const VelocitySweep& sweep : volume.sweeps)
  {
    AddSamples(sweep, options, layers);
  }
  WindProfile profile;
  for (std::size_t layer = 0; layer < layers.size(); ++layer)
  {
    const std::optional<Fit> fit = FitLayer(layers[layer]);
    if (fit && IsSound(*fit))
    {
      profile.levels.push_back(
        {(static_cast<double>(layer) + 0.5) * options.layerDepth, fit->wind, fit->rms, fit->gates});
    }
  }
  return profile;
}

} // namespace nexrad
