// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormField.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Simulation/CounterNoise.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double deadLoss = 70.0; // dB below full strength at birth and death

constexpr double coreShoulder = 4'500.0; // m, height of a supercell's strongest echo
constexpr double coreSlope = 0.55;       // m of shift of its core downshear a metre of height

// Strength 0…1 at an age (0 at birth, 1 at death): quick growth, long maturity, quick decay.
double Strength(double age)
{
  if (age <= 0.0 || age >= 1.0)
  {
    return 0.0;
  }
  const double fromMiddle = 2.0 * age - 1.0;
  const double squared = fromMiddle * fromMiddle;
  return 1.0 - squared * squared;
}

// Builds the elements of one storm at one instant: places are given along and to the left of the
// direction downshear, in the storm's own lengths.
class ElementBuilder
{
public:
  ElementBuilder(const StormLife& life, double sinceMiddle, std::vector<StormElement>& result)
    : storm(life)
    , elements(result)
    , centreX(life.x + life.east * sinceMiddle)
    , centreY(life.y + life.north * sinceMiddle)
    , alongX(std::sin(life.downshear))
    , alongY(std::cos(life.downshear))
  {
  }

  PlanePoint Place(double along, double left) const
  {
    const double ahead = along * storm.size;
    const double aside = left * storm.size;
    return {
      centreX + alongX * ahead - alongY * aside, centreY + alongY * ahead + alongX * aside, 0.0};
  }

  // A vector of that length downshear.
  PlanePoint Along(double length) const { return {alongX * length, alongY * length, 0.0}; }

  // An element with its middle at a place, that much below full strength; the caller sets the rest.
  StormElement& Add(double along, double left, double longAxis, double shortAxis, double strength)
  {
    StormElement element;
    const PlanePoint place = this->Place(along, left);
    element.x = place.x;
    element.y = place.y;
    element.alongX = alongX;
    element.alongY = alongY;
    element.longAxis = longAxis * storm.size;
    element.shortAxis = shortAxis * storm.size;
    element.peak = -deadLoss * (1.0 - strength);
    elements.push_back(element);
    return elements.back();
  }

private:
  const StormLife& storm;
  std::vector<StormElement>& elements;
  double centreX;
  double centreY;
  double alongX;
  double alongY;
};

void SetTower(StormElement& element, double peak, double shoulder, double top)
{
  element.peak += peak;
  element.profile = VerticalProfile::Tower;
  element.level = shoulder;
  element.depth = top - shoulder;
  element.fall = std::max(peak - 5.0, 10.0); // 5 dBZ at the top
}

void SetLayer(StormElement& element, double peak, double level, double depth)
{
  element.peak += peak;
  element.profile = VerticalProfile::Layer;
  element.level = level;
  element.depth = depth;
  element.fall = 22.0;
}

void SetStratiform(StormElement& element, double peak, double top)
{
  element.peak += peak;
  element.plateau = true;
  element.edge = 22.0;
  element.profile = VerticalProfile::Stratiform;
  element.level = MeltingLevel;
  element.depth = top - MeltingLevel;
  element.fall = peak; // 0 dBZ at the top
}

void Lean(StormElement& element, double slope)
{
  element.tiltX = slope * element.alongX;
  element.tiltY = slope * element.alongY;
}

// A hook: small blobs along an arc that leaves the core on its right rear flank and curls round the
// mesocyclone.
void AddHook(ElementBuilder& builder, double peak, double strength)
{
  constexpr int blobs = 11;
  constexpr double radius = 4'200.0;
  constexpr double centreAlong = -6'500.0;
  constexpr double centreLeft = -7'500.0;
  for (int blob = 0; blob < blobs; ++blob)
  {
    const double angle = (70.0 + 22.0 * blob) * RadiansPerDegree;
    StormElement& element = builder.Add(centreAlong + radius * std::cos(angle),
      centreLeft + radius * std::sin(angle), 2'000.0, 2'000.0, strength);
    SetTower(element, peak - 10.0 - 0.75 * blob, 1'800.0, 5'500.0);
  }
}

StormVortex VortexAt(const ElementBuilder& builder, double along, double left, double slope)
{
  const PlanePoint place = builder.Place(along, left);
  const PlanePoint ahead = builder.Along(slope);
  StormVortex vortex;
  vortex.x = place.x;
  vortex.y = place.y;
  vortex.tiltX = ahead.x;
  vortex.tiltY = ahead.y;
  return vortex;
}

// Rotation inside the hook: strongest at 3.5 km, gone at 12 km, wider upwards.
StormVortex Mesocyclone(const StormLife& storm, const ElementBuilder& builder, double strength)
{
  StormVortex vortex = VortexAt(builder, -6'500.0, -7'500.0, 0.3);
  vortex.level = 1'000.0;
  vortex.coreRadius = 3'000.0 * storm.size;
  vortex.widening = 0.15;
  vortex.rotation = {28.0 * strength, 3'500.0, 8'500.0};
  return vortex;
}

// Convergence below the core and divergence at its top.
StormVortex Updraft(const StormLife& storm, const ElementBuilder& builder, double strength)
{
  StormVortex vortex = VortexAt(builder, 0.0, 0.0, coreSlope);
  vortex.level = coreShoulder;
  vortex.coreRadius = 5'000.0 * storm.size;
  vortex.inflow = {9.0 * strength, 500.0, 2'500.0};
  vortex.outflow = {22.0 * strength, storm.top - 1'500.0, 3'500.0};
  return vortex;
}

void AddSupercell(const StormLife& storm, double sinceMiddle, std::vector<StormElement>& elements,
  std::vector<StormVortex>& vortices)
{
  const double age = 0.5 + sinceMiddle / storm.lifetime;
  const double strength = Strength(age);
  // The anvil and the rain behind the storm come later than the core, and outlive it.
  const double lateStrength = Strength((age - 0.12) / 1.15);
  const double peak = storm.peak;
  ElementBuilder builder(storm, sinceMiddle, elements);

  StormElement& core = builder.Add(0.0, 0.0, 7'000.0, 5'500.0, strength);
  SetTower(core, peak, coreShoulder, storm.top);
  Lean(core, coreSlope);
  // Echo aloft over the inflow on the right flank, with weak echo below it.
  StormElement& overhang = builder.Add(-1'500.0, -7'500.0, 5'500.0, 4'500.0, strength);
  SetLayer(overhang, peak - 9.0, 6'800.0, 2'600.0);
  Lean(overhang, 0.3);
  StormElement& forwardFlank = builder.Add(17'000.0, 3'500.0, 15'000.0, 9'000.0, strength);
  SetTower(forwardFlank, peak - 19.0, 3'500.0, 0.75 * storm.top);
  AddHook(builder, peak, strength);

  const double spread = 0.45 + 0.55 * lateStrength;
  const double length = spread * storm.anvilLength;
  StormElement& anvil =
    builder.Add(48'000.0 * length, 2'000.0, 66'000.0 * length, 28'000.0 * spread, lateStrength);
  SetLayer(anvil, 25.0, 0.7 * storm.top, 3'000.0);
  anvil.plateau = true;
  anvil.edge = 18.0;
  const double extent = storm.trailingExtent;
  StormElement& trailing = builder.Add(
    -34'000.0 * extent, 9'000.0 * extent, 32'000.0 * extent, 27'000.0 * extent, lateStrength);
  SetStratiform(trailing, 22.0 + 6.0 * extent, 8'500.0);

  vortices.push_back(Mesocyclone(storm, builder, strength));
  vortices.push_back(Updraft(storm, builder, strength));
}

} // namespace

void AddElements(const StormLife& storm, double seconds, std::vector<StormElement>& elements,
  std::vector<StormVortex>& vortices)
{
  // The nearest of the days' repetitions; std::remainder is many times slower.
  const double apart = seconds - storm.middleTime;
  const double sinceMiddle = apart - SecondsPerDay * std::floor(apart / SecondsPerDay + 0.5);
  constexpr double longest = 0.8; // of a lifetime, from the middle to the end of what outlives it
  if (std::abs(sinceMiddle) > longest * storm.lifetime)
  {
    return;
  }
  if (storm.kind == StormKind::Supercell)
  {
    AddSupercell(storm, sinceMiddle, elements, vortices);
    return;
  }
  const double strength = Strength(0.5 + sinceMiddle / storm.lifetime);
  ElementBuilder builder(storm, sinceMiddle, elements);
  if (storm.kind == StormKind::Cell)
  {
    StormElement& cell = builder.Add(0.0, 0.0, 3'400.0, 2'800.0, strength);
    SetTower(cell, storm.peak, 0.45 * storm.top, storm.top);
    Lean(cell, 0.4);
  }
  else
  {
    SetStratiform(builder.Add(0.0, 0.0, 48'000.0, 26'000.0, strength), storm.peak, storm.top);
  }
}

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

} // namespace nexrad
