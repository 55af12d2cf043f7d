// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/GroundEcho.h"

#include "nexrad/Simulation/CounterNoise.h"
#include "nexrad/Simulation/GateLayout.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// Key of the cell that a place lies in.
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

} // namespace nexrad
