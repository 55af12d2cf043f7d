// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormField.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Simulation/CounterNoise.h"

#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

// The box that the storms' middles are spread over, m in the plane: where the radars are.
constexpr double west = -440'000.0;
constexpr double east = 390'000.0;
constexpr double south = -230'000.0;
constexpr double north = 330'000.0;

// How many storms of a kind a day has, and how they differ. `least` and `most` bound a uniform
// draw.
struct Population
{
  StormKind kind;
  int count;
  double leastLife, mostLife;       // s
  double leastPeak, mostPeak;       // dBZ
  double leastSize, mostSize;       // factor
  double leastTop, mostTop;         // m
  double leastSpeed, mostSpeed;     // m/s
  double leastBearing, mostBearing; // degrees, where the storm moves to
};
constexpr Population populations[] = {
  {StormKind::Supercell, 86, 9'000, 16'000, 55, 64, 0.85, 1.3, 12'000, 16'000, 15, 21, 45, 68},
  {StormKind::Cell, 340, 2'400, 5'400, 36, 52, 0.7, 1.4, 6'000, 10'500, 18, 25, 36, 58},
  {StormKind::RainArea, 32, 12'000, 24'000, 24, 32, 0.8, 1.3, 5'000, 6'500, 16, 22, 40, 60}};

// Share of the day's storms whose middle lies before a time of day (0…1, 0…1): a steady rate and a
// wave that is highest at 20:00 UTC, the afternoon of Missouri.
double ActivityBefore(double day)
{
  constexpr double swing = 0.5;
  constexpr double turn = 360.0 * RadiansPerDegree;
  constexpr double peak = 20.0 / 24.0;
  return day + swing / turn * (std::sin(turn * (day - peak)) + std::sin(turn * peak));
}

// The time of day before which that share of the storms lies.
double TimeOfShare(double share)
{
  double low = 0.0;
  double high = 1.0;
  for (int step = 0; step < 40; ++step)
  {
    const double middle = (low + high) / 2.0;
    (ActivityBefore(middle) < share ? low : high) = middle;
  }
  return (low + high) / 2.0;
}

double Fraction(double value)
{
  return value - std::floor(value);
}

} // namespace

std::vector<StormLife> MakeStormDay(std::uint32_t seed)
{
  std::vector<StormLife> storms;
  for (const Population& population : populations)
  {
    const std::uint64_t kindKey = Mix(seed, static_cast<std::uint64_t>(population.kind));
    for (int index = 0; index < population.count; ++index)
    {
      const std::uint64_t key = Mix(kindKey, static_cast<std::uint64_t>(index));
      std::uint64_t draw = 0;
      const auto between = [key, &draw](double least, double most)
      { return least + (most - least) * Uniform(key, draw++); };

      StormLife storm;
      storm.kind = population.kind;
      storm.middleTime =
        SecondsPerDay * TimeOfShare((index + between(0.0, 1.0)) / population.count);
      storm.lifetime = between(population.leastLife, population.mostLife);
      // An additive sequence of two irrational steps fills the box evenly in any stretch of it.
      storm.x = west + (east - west) * Fraction(Uniform(kindKey, 1'000'001) + index * 0.7548776662);
      storm.y =
        south + (north - south) * Fraction(Uniform(kindKey, 1'000'002) + index * 0.5698402910);
      const double speed = between(population.leastSpeed, population.mostSpeed);
      const double bearing =
        between(population.leastBearing, population.mostBearing) * RadiansPerDegree;
      storm.east = speed * std::sin(bearing);
      storm.north = speed * std::cos(bearing);
      storm.peak = between(population.leastPeak, population.mostPeak);
      storm.size = between(population.leastSize, population.mostSize);
      storm.top = between(population.leastTop, population.mostTop);
      constexpr double jitter = 40'000.0; // m
      storm.x += between(-jitter, jitter);
      storm.y += between(-jitter, jitter);
      storm.downshear = between(52.0, 76.0) * RadiansPerDegree;
      storm.anvilLength = between(0.75, 1.25);
      storm.trailingExtent = between(0.6, 1.35);
      storms.push_back(storm);
    }
  }
  return storms;
}

StormField::StormField(std::uint32_t seed)
  : storms(MakeStormDay(seed))
{
}

StormSnapshot StormField::At(Time time) const
{
  constexpr std::int64_t dayLength = 86'400'000;
  const std::int64_t sinceMidnight =
    ((time.time_since_epoch().count() % dayLength) + dayLength) % dayLength;
  const double seconds = static_cast<double>(sinceMidnight) / 1000.0;
  constexpr std::size_t usualElements = 256;
  std::vector<StormElement> elements;
  std::vector<StormVortex> vortices;
  elements.reserve(usualElements);
  for (const StormLife& storm : storms)
  {
    AddElements(storm, seconds, elements, vortices);
  }
  return {std::move(elements), std::move(vortices), seconds};
}

double StormField::Reflectivity(double longitude, double latitude, double height, Time time) const
{
  return this->At(time).Reflectivity(StormPlane::FromGeographic(longitude, latitude, height));
}

} // namespace nexrad
