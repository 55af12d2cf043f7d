// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/AddedEcho.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Simulation/CounterNoise.h"
#include "nexrad/Simulation/StormSnapshot.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double cellLength = 250.0;  // m
constexpr double targetSpread = 8.0;  // dB, standard deviation of the targets
constexpr int areas = 3;              // ridges, and patches
constexpr double sideLobeLoss = 45.0; // dB, two-way
constexpr double sideLobeFall = 1.5;  // dB a degree farther from the target

// Numbers of the random draws of a cell and of the areas.
enum Draw : std::uint64_t
{
  ClutterPresence = 1,
  ClutterStrength,
  TargetHeight,
  PatchPresence,
  PatchStrength,
  Ridges = 100,
  Patches = 200
};

std::uint64_t CellKey(std::uint64_t key, const SeenPlace& place)
{
  const auto azimuth = static_cast<std::uint64_t>(std::floor(place.azimuth));
  const auto range = static_cast<std::uint64_t>(std::max(place.range, 0.0) / cellLength);
  return Mix(Mix(key, azimuth), range);
}

} // namespace

GroundEcho::GroundEcho(std::uint64_t radarKey, double beamWidth)
  : key(radarKey)
  , width(beamWidth)
{
  for (std::uint64_t area = 0; area < areas; ++area)
  {
    // In thirds of the circle, so that no two lie upon each other.
    const auto draw = [this, area](
                        std::uint64_t first, std::uint64_t number, double least, double most)
    { return least + (most - least) * Uniform(key, first + 10 * area + number); };
    const double third = 120.0 * static_cast<double>(area);
    ridges.push_back({third + draw(Ridges, 0, 30.0, 90.0), draw(Ridges, 1, 12.0, 28.0),
      draw(Ridges, 2, 25'000.0, 80'000.0), draw(Ridges, 3, 1'500.0, 3'500.0),
      draw(Ridges, 4, -400.0, 400.0)});
    patches.push_back({third + draw(Patches, 0, 30.0, 90.0), draw(Patches, 1, 15.0, 28.0),
      draw(Patches, 2, 50'000.0, 130'000.0), draw(Patches, 3, 14'000.0, 32'000.0), 0.0});
  }
}

double GroundEcho::SquaredDistance(const Area& area, const SeenPlace& place)
{
  const double turn = std::remainder(place.azimuth - area.azimuth, 360.0);
  const double across = turn / area.halfWidth;
  const double along = (place.range - area.range - area.slope * turn) / area.halfLength;
  return across * across + along * along;
}

double GroundEcho::PatternLoss(double elevation, double target) const
{
  // A Gaussian one-way pattern has lost 3 dB half a width off its middle; echo passes it twice.
  const double above = std::max(elevation - target, 0.0);
  const double mainLobe = 24.0 * above * above / (width * width);
  return std::min(mainLobe, sideLobeLoss + sideLobeFall * above);
}

double GroundEcho::Clutter(const SeenPlace& place) const
{
  constexpr double nearRange = 14'000.0; // m, over which targets grow rare
  double share = 0.9 * std::exp(-place.range * place.range / (nearRange * nearRange));
  double strength = 46.0;
  for (const Area& ridge : ridges)
  {
    if (SquaredDistance(ridge, place) < 1.0)
    {
      share = 0.85;
      strength = 50.0;
    }
  }
  const std::uint64_t cell = CellKey(key, place);
  if (share < 1e-3 || Uniform(cell, ClutterPresence) > share)
  {
    return NoReflectivity;
  }
  const double target = 0.4 * Uniform(cell, TargetHeight);
  return strength + targetSpread * Normal(cell, ClutterStrength) -
         this->PatternLoss(place.elevation, target);
}

double GroundEcho::AnomalousPropagation(const SeenPlace& place) const
{
  constexpr double highest = 0.5;  // degrees, up to which the beam is bent to the ground
  constexpr double decline = 90.0; // dB a degree above
  for (const Area& patch : patches)
  {
    const double squared = SquaredDistance(patch, place);
    const std::uint64_t cell = CellKey(key, place);
    if (squared < 1.0 && Uniform(cell, PatchPresence) < 1.0 - 0.6 * squared)
    {
      return 44.0 - 14.0 * squared + targetSpread * Normal(cell, PatchStrength) -
             decline * std::max(place.elevation - highest, 0.0);
    }
  }
  return NoReflectivity;
}

namespace
{

// Numbers of the noise streams within a ray.
constexpr std::uint64_t groundStream = 16U << 16;
constexpr std::uint64_t biologicalStream = 17U << 16;
constexpr std::uint64_t powerStream = 18U << 16;
constexpr std::uint64_t speckleStream = 19U << 16;
constexpr std::uint64_t speckleStrengthStream = 20U << 16;

// Numbers of the draws of a radar's cuts.
constexpr std::uint64_t interferenceDraw = 300;
constexpr std::uint64_t patternDraw = 400;

// Reflectivity of one power at all ranges, of which 50 km has `reference` dBZ.
double OfPower(double reference, double range)
{
  constexpr double nearest = 250.0; // m, nearer gates count as there
  return reference + 20.0 * std::log10(std::max(range, nearest) / 50'000.0);
}

double FromDecibel(double decibel)
{
  return std::pow(10.0, decibel / 10.0);
}

} // namespace

AddedEcho::AddedEcho(const std::set<EchoKind>& kinds, std::uint64_t radarKey, double beamWidth)
  : added(kinds)
  , key(radarKey)
  , width(beamWidth)
  , ground(radarKey, beamWidth)
{
}

double AddedEcho::Biological(const BeamTrace& beam, const SeenPlace& place) const
{
  constexpr double strongest = 20.0;  // dBZ
  constexpr double depth = 1'200.0;   // m
  constexpr double fall = 14.0;       // dB lost at that height
  constexpr double highest = 2'500.0; // m above the antenna
  const double height = beam.At(place.range, place.elevation).height;
  if (height > highest)
  {
    return NoReflectivity;
  }
  const WindVector flight = OwnFlight();
  const double aside = place.azimuth * RadiansPerDegree - std::atan2(flight.east, flight.north);
  return strongest - fall * height * height / (depth * depth) - 3.0 * std::cos(2.0 * aside);
}

double AddedEcho::Sun(const SeenPlace& place) const
{
  constexpr double azimuth = 268.0;
  constexpr double elevation = 0.9;
  constexpr double power = -1.0; // dBZ at 50 km
  const double aside =
    std::remainder(place.azimuth - azimuth, 360.0) * std::cos(place.elevation * RadiansPerDegree);
  const double above = place.elevation - elevation;
  return OfPower(power, place.range) - 12.0 * (aside * aside + above * above) / (width * width);
}

bool AddedEcho::IsInterference(const BeamTrace& beam, const RayPlace& place) const
{
  constexpr double highest = 5.0; // degrees of elevation
  const double share = Uniform(key, interferenceDraw + static_cast<std::uint64_t>(place.cut));
  return beam.Elevation() < highest && place.index == static_cast<int>(share * place.rays);
}

bool AddedEcho::IsTestPattern(const RayPlace& place) const
{
  const double share = Uniform(key, patternDraw + static_cast<std::uint64_t>(place.cut));
  const int first = static_cast<int>(share * (place.rays - 1));
  return added.count(EchoKind::TestPattern) > 0 && place.cut % 3 == 1 &&
         (place.index == first || place.index == first + 1);
}

double AddedEcho::ValueOf(EchoKind kind, const BeamTrace& beam, const RayPlace& ray,
  const SeenPlace& place, std::uint64_t gate) const
{
  constexpr double speckleShare = 1.0 / 1250.0;
  switch (kind)
  {
  case EchoKind::Clutter:
    return ground.Clutter(place) + 1.5 * Normal(ray.key, groundStream + gate);
  case EchoKind::AnomalousPropagation:
    return ground.AnomalousPropagation(place) + 1.5 * Normal(ray.key, groundStream + gate);
  case EchoKind::Biological:
    return this->Biological(beam, place) + 2.5 * Normal(ray.key, biologicalStream + gate);
  case EchoKind::Sun:
    return this->Sun(place);
  case EchoKind::Interference:
    return this->IsInterference(beam, ray)
             ? OfPower(12.0, place.range) + Normal(ray.key, powerStream + gate)
             : NoReflectivity;
  case EchoKind::Speckle:
    return Uniform(ray.key, speckleStream + gate) < speckleShare
             ? OfPower(-3.5 + 20.0 * Uniform(ray.key, speckleStrengthStream + gate), place.range)
             : NoReflectivity;
  default:
    return NoReflectivity;
  }
}

void AddedEcho::AddTo(const BeamTrace& beam, const RayPlace& place, const GateLayout& layout,
  std::vector<double>& reflectivity, std::vector<EchoKind>& kinds) const
{
  for (int gate = 0; gate < layout.gates; ++gate)
  {
    const auto index = static_cast<std::size_t>(gate);
    const SeenPlace seen{beam.Azimuth(), beam.Elevation(), layout.Range(gate)};
    double strongest = reflectivity[index];
    double sum = std::isfinite(strongest) ? FromDecibel(strongest) : 0.0;
    for (const EchoKind kind : added)
    {
      const double value = this->ValueOf(kind, beam, place, seen, index);
      sum += FromDecibel(value);
      if (value > strongest)
      {
        strongest = value;
        kinds[index] = kind;
      }
    }
    reflectivity[index] = sum > 0.0 ? 10.0 * std::log10(sum) : NoReflectivity;
  }
}

} // namespace nexrad
