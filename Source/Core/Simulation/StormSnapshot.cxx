// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Simulation/StormSnapshot.h"

#include <algorithm>
#include <cmath>

namespace nexrad
{

namespace
{

constexpr double brightBandDepth = 450.0; // m

double StratiformDrop(const StormElement& element, double above)
{
  double drop = above > 0.0 ? element.fall * above / element.depth : 0.0;
  const double distance = above / brightBandDepth;
  constexpr double negligible = 3.0;
  if (std::abs(distance) < negligible)
  {
    drop -= BrightBandGain * std::exp(-distance * distance);
  }
  return drop;
}

} // namespace

double StormElement::VerticalDrop(double z) const
{
  const double above = z - level;
  if (profile == VerticalProfile::Stratiform)
  {
    return StratiformDrop(*this, above);
  }
  if (profile == VerticalProfile::Tower && above <= 0.0)
  {
    return 0.0;
  }
  const double distance = above / depth;
  return fall * distance * distance;
}

ElementBounds BoundsOf(const StormElement& element)
{
  const bool stratiform = element.profile == VerticalProfile::Stratiform;
  const double strongest = element.peak + (stratiform ? BrightBandGain : 0.0);
  const double margin = std::max(strongest - MinimumReflectivity, 0.0);
  const double distance = std::sqrt(margin / element.edge);
  const double reach = element.plateau ? std::sqrt(distance) : distance;
  const double height =
    element.depth * (stratiform ? margin / element.fall : std::sqrt(margin / element.fall));

  ElementBounds bounds{};
  bounds.top = element.level + height;
  bounds.bottom = element.profile == VerticalProfile::Layer ? element.level - height : 0.0;
  bounds.bottom = std::max(bounds.bottom, 0.0);
  const double middle = (bounds.top + bounds.bottom) / 2.0 - element.level;
  const double lean = std::hypot(element.tiltX, element.tiltY) * (bounds.top - bounds.bottom) / 2.0;
  bounds.x = element.x + element.tiltX * middle;
  bounds.y = element.y + element.tiltY * middle;
  bounds.alongX = element.alongX;
  bounds.alongY = element.alongY;
  bounds.halfLength = reach * element.longAxis + lean;
  bounds.halfWidth = reach * element.shortAxis + lean;
  return bounds;
}

namespace
{

// Insects and eddies of the boundary layer: a weak return everywhere near the ground, seen by a
// radar for some tens of kilometres. It stays below 0 dBZ, so that it is never a storm.
constexpr double clearAirPeak = -4.0;    // dBZ
constexpr double clearAirDepth = 1900.0; // m
constexpr double clearAirFall = 8.0;     // dB lost at that height
constexpr double clearAirTexture = 0.5;  // share of the storms' texture

double ClearAir(double z)
{
  const double relative = z / clearAirDepth;
  const double squared = relative * relative;
  return clearAirPeak - clearAirFall * squared * squared;
}

// A wave of the texture: its wavelengths along the axes (as turns a metre) and its amplitude, dB.
struct TextureWave
{
  double x, y, z;
  double amplitude;
};
constexpr std::array<TextureWave, 3> textureWaves = {
  {{1.0 / 31'000.0, -1.0 / 43'000.0, 1.0 / 30'000.0, 1.4},
    {-1.0 / 37'000.0, 1.0 / 14'000.0, -1.0 / 20'000.0, 1.2},
    {1.0 / 9'500.0, 1.0 / 17'000.0, 1.0 / 16'000.0, 0.9}}};

// A wave of period 1 between -1 and 1, of parabolic arcs: as smooth as the texture needs to be, and
// several times cheaper than a sine.
double Wave(double turns)
{
  const double position = 2.0 * (turns - std::floor(turns)) - 1.0;
  return 4.0 * position * (std::abs(position) - 1.0);
}

constexpr double textureEast = 14.0; // m/s
constexpr double textureNorth = 12.0;

// Phases of the waves after a drift of so many seconds. Each wave drifts a whole number of
// wavelengths a day, so that the day repeats without a jump.
std::array<double, textureWaves.size()> TexturePhases(double seconds)
{
  std::array<double, textureWaves.size()> phases{};
  for (std::size_t index = 0; index < phases.size(); ++index)
  {
    const TextureWave& wave = textureWaves[index];
    const double turns = std::round((wave.x * textureEast + wave.y * textureNorth) * SecondsPerDay);
    phases[index] = -turns * seconds / SecondsPerDay;
  }
  return phases;
}

} // namespace

StormSnapshot::StormSnapshot(
  std::vector<StormElement> elementsNow, std::vector<StormVortex> vorticesNow, double seconds)
  : elements(std::move(elementsNow))
  , vortices(std::move(vorticesNow))
  , texturePhases(TexturePhases(seconds))
{
  // A storm at its birth or its death is too weak to be seen.
  const auto unseen = [](const StormElement& element)
  { return element.peak + BrightBandGain < MinimumReflectivity; };
  elements.erase(std::remove_if(elements.begin(), elements.end(), unseen), elements.end());
  const auto isStill = [](const StormVortex& vortex)
  {
    constexpr double least = 0.01; // m/s
    return vortex.rotation.speed + vortex.inflow.speed + vortex.outflow.speed < least;
  };
  vortices.erase(std::remove_if(vortices.begin(), vortices.end(), isStill), vortices.end());
  bounds.reserve(elements.size());
  for (const StormElement& element : elements)
  {
    bounds.push_back(BoundsOf(element));
  }
}

void StormSnapshot::FindElements(const Cylinder& within, std::vector<int>& found) const
{
  found.clear();
  for (std::size_t index = 0; index < bounds.size(); ++index)
  {
    if (bounds[index].Touch(within))
    {
      found.push_back(static_cast<int>(index));
    }
  }
}

void StormSnapshot::FindElements(
  const Cylinder& within, const std::vector<int>& among, std::vector<int>& found) const
{
  found.clear();
  for (const int index : among)
  {
    if (bounds[static_cast<std::size_t>(index)].Touch(within))
    {
      found.push_back(index);
    }
  }
}

double StormSnapshot::Texture(const PlanePoint& point) const
{
  // Each wave bends the next, so that no pattern repeats before the eye.
  constexpr double bend = 0.35; // turns
  double sum = 0.0;
  double last = 0.0;
  for (std::size_t index = 0; index < textureWaves.size(); ++index)
  {
    const TextureWave& wave = textureWaves[index];
    last = Wave(
      wave.x * point.x + wave.y * point.y + wave.z * point.z + texturePhases[index] + bend * last);
    sum += wave.amplitude * last;
  }
  return sum;
}

double StormSnapshot::Reflectivity(const PlanePoint& point) const
{
  std::vector<int> candidates;
  this->FindElements({point.x, point.y, 0.0, point.z, point.z}, candidates);
  return this->Reflectivity(point, candidates);
}

double StormSnapshot::Reflectivity(
  const PlanePoint& point, const std::vector<int>& candidates) const
{
  double strongest = NoReflectivity;
  for (const int index : candidates)
  {
    strongest = std::max(strongest, elements[static_cast<std::size_t>(index)].Reflectivity(point));
  }
  const double clearAir = point.z < ClearAirTop() ? ClearAir(point.z) : NoReflectivity;
  if (std::max(strongest, clearAir) < MinimumReflectivity)
  {
    return NoReflectivity;
  }
  const double texture = this->Texture(point);
  return std::max(strongest < MinimumReflectivity ? NoReflectivity : strongest + texture,
    clearAir + clearAirTexture * texture);
}

void StormSnapshot::FindVortices(const Cylinder& within, std::vector<int>& found) const
{
  found.clear();
  for (std::size_t index = 0; index < vortices.size(); ++index)
  {
    if (vortices[index].Touches(within, StormVortex::Reach))
    {
      found.push_back(static_cast<int>(index));
    }
  }
}

double StormSnapshot::ClearAirTop()
{
  static const double top =
    clearAirDepth * std::pow((clearAirPeak - MinimumReflectivity) / clearAirFall, 0.25);
  return top;
}

double StormSnapshot::ClearAirMaximum()
{
  return clearAirPeak + clearAirTexture * TextureAmplitude;
}

} // namespace nexrad
