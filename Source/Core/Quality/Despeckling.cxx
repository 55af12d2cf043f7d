// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/Despeckling.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Model/Elevation.h"
#include "nexrad/Quality/EchoGrid.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

constexpr std::size_t noRay = std::numeric_limits<std::size_t>::max();

// A ray and those beside it, as places in the order of azimuths; noRay where there is none.
using RayPlaces = std::array<std::size_t, 3>;

// Which gates of a sweep have a value, and the rays in the order of their azimuths.
class HeldGates
{
public:
  explicit HeldGates(const PolarSweep& theSweep)
    : sweep(theSweep)
    , elevation(MedianElevation(theSweep))
    , cosine(std::cos(elevation * RadiansPerDegree))
  {
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      order.emplace_back(ToFullTurn(static_cast<double>(sweep.rays[ray].azimuth)), ray);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::uint16_t> codes(sweep.gates);
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      sweep.Read(ray, codes.data());
      std::transform(codes.begin(), codes.end(), std::back_inserter(valid),
        [](std::uint16_t code)
        { return code >= GateCode::FirstValue ? std::uint8_t(1) : std::uint8_t(0); });
    }
  }

  double Elevation() const { return elevation; }
  std::size_t Rays() const { return order.size(); }
  std::size_t RayAt(std::size_t place) const { return order[place].second; }
  double AzimuthAt(std::size_t place) const { return order[place].first; }
  std::size_t Index(std::size_t ray, std::size_t gate) const { return ray * sweep.gates + gate; }
  bool HasValue(std::size_t index) const { return valid[index] != 0; }

  // m along the ground, but for the earth's curvature, which is the same for all tilts.
  double DistanceOf(std::size_t gate) const
  {
    return (sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate)) * cosine;
  }

  // The gate nearest to a distance; it need not exist.
  std::ptrdiff_t GateAt(double distance) const
  {
    return std::llround((distance / cosine - sweep.firstGate) / sweep.gateSpacing);
  }

  // The ray nearest to an azimuth and those beside it.
  RayPlaces PlacesAbout(double azimuth) const
  {
    const auto next = std::lower_bound(order.begin(), order.end(), std::make_pair(azimuth, noRay),
      [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t count = order.size();
    const std::size_t after = static_cast<std::size_t>(next - order.begin()) % count;
    const std::size_t before = (after + count - 1) % count;
    const bool nearerBefore = this->Apart(before, azimuth) < this->Apart(after, azimuth);
    const std::size_t nearest = nearerBefore ? before : after;
    if (this->Apart(nearest, azimuth) > WidestGap)
    {
      return {noRay, noRay, noRay};
    }
    return this->PlacesBeside(nearest);
  }

  RayPlaces PlacesBeside(std::size_t place) const
  {
    const std::size_t count = order.size();
    const std::size_t before = (place + count - 1) % count;
    const std::size_t after = (place + 1) % count;
    const double azimuth = order[place].first;
    const bool several = count > 2; // else the ray before is the one after
    return {several && this->Apart(before, azimuth) <= WidestGap ? before : noRay, place,
      several && this->Apart(after, azimuth) <= WidestGap ? after : noRay};
  }

  // How many of the nine gates about a gate of these rays have a value.
  int CountAbout(const RayPlaces& places, std::ptrdiff_t gate) const
  {
    int count = 0;
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(gate - 1, 0);
    const std::ptrdiff_t last = std::min(gate + 1, static_cast<std::ptrdiff_t>(sweep.gates) - 1);
    for (const std::size_t place : places)
    {
      for (std::ptrdiff_t each = first; place != noRay && each <= last; ++each)
      {
        count += valid[this->Index(order[place].second, static_cast<std::size_t>(each))];
      }
    }
    return count;
  }

private:
  double Apart(std::size_t place, double azimuth) const
  {
    return std::abs(AngleDifference(order[place].first, azimuth));
  }

  const PolarSweep& sweep;
  const double elevation;
  const double cosine;
  std::vector<std::pair<double, std::size_t>> order; // azimuth 0…360 and ray
  std::vector<std::uint8_t> valid;                   // 1 for a gate with a value, rays × gates
};

using Cuts = std::vector<const HeldGates*>;

// All cuts of the next tilt below (side −1) or above (side 1).
Cuts FindNextTilt(const std::vector<HeldGates>& sweeps, const HeldGates& own, double side)
{
  const auto rise = [&own, side](const HeldGates& other)
  { return side * (other.Elevation() - own.Elevation()); };
  double nearest = std::numeric_limits<double>::infinity();
  for (const HeldGates& other : sweeps)
  {
    nearest = rise(other) > SameTilt ? std::min(nearest, rise(other)) : nearest;
  }
  Cuts cuts;
  for (const HeldGates& other : sweeps)
  {
    if (rise(other) > SameTilt && rise(other) <= nearest + SameTilt)
    {
      cuts.push_back(&other);
    }
  }
  return cuts;
}

// The nine gates of a neighbouring tilt that are nearest to those of one ray: of its cuts, those
// with the most values.
class BesideRay
{
public:
  BesideRay(const Cuts& cuts, double azimuth)
  {
    for (const HeldGates* cut : cuts)
    {
      places.emplace_back(cut, cut->PlacesAbout(azimuth));
    }
  }

  int CountAt(double distance) const
  {
    int most = 0;
    for (const auto& [cut, rays] : places)
    {
      most = std::max(most, cut->CountAbout(rays, cut->GateAt(distance)));
    }
    return most;
  }

private:
  std::vector<std::pair<const HeldGates*, RayPlaces>> places;
};

// Indices of the gates of a sweep that have too few neighbours, ascending.
std::vector<std::size_t> FindSpeckle(const PolarSweep& sweep, const HeldGates& own,
  const std::vector<HeldGates>& sweeps, int neighbours)
{
  const Cuts below = FindNextTilt(sweeps, own, -1.0);
  const Cuts above = FindNextTilt(sweeps, own, 1.0);
  std::vector<std::size_t> speckle;
  for (std::size_t place = 0; place < own.Rays(); ++place)
  {
    const RayPlaces beside = own.PlacesBeside(place);
    const BesideRay lower(below, own.AzimuthAt(place));
    const BesideRay upper(above, own.AzimuthAt(place));
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const std::size_t index = own.Index(own.RayAt(place), gate);
      if (!own.HasValue(index))
      {
        continue;
      }
      int count = own.CountAbout(beside, static_cast<std::ptrdiff_t>(gate)) - 1;
      count += count < neighbours ? lower.CountAt(own.DistanceOf(gate)) : 0;
      count += count < neighbours ? upper.CountAt(own.DistanceOf(gate)) : 0;
      if (count < neighbours)
      {
        speckle.push_back(index);
      }
    }
  }
  std::sort(speckle.begin(), speckle.end());
  return speckle;
}

// Takes gates out of a sweep; `speckle` ascending.
void TakeOut(const std::vector<std::size_t>& speckle, PolarSweep& sweep)
{
  GateRows rows(sweep.rows.LargestCode());
  std::vector<std::uint16_t> codes(sweep.gates);
  auto next = speckle.begin();
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.Read(ray, codes.data());
    for (; next != speckle.end() && *next < (ray + 1) * sweep.gates; ++next)
    {
      codes[*next - ray * sweep.gates] = GateCode::Filtered;
    }
    rows.Append(codes.data(), codes.size());
  }
  rows.Finish();
  sweep.rows = std::move(rows);
}

} // namespace

std::vector<std::size_t> Despeckle(PolarVolume& volume, int neighbours)
{
  if (neighbours < 0 || neighbours > MostNeighbours)
  {
    throw Error("despeckling by " + std::to_string(neighbours) +
                " neighbours: must be from 0, which keeps all, to " +
                std::to_string(MostNeighbours));
  }
  std::vector<std::size_t> removed(volume.sweeps.size(), 0);
  if (neighbours == 0)
  {
    return removed;
  }
  std::vector<HeldGates> sweeps;
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
  {
    const PolarSweep& sweep = volume.sweeps[i];
    if (!sweep.rays.empty() && sweep.gates > 0 && sweep.gateSpacing > 0.0)
    {
      sweeps.emplace_back(sweep);
      numbers.push_back(i);
    }
  }
  std::vector<std::vector<std::size_t>> speckle;
  for (std::size_t i = 0; i < sweeps.size(); ++i)
  {
    speckle.push_back(FindSpeckle(volume.sweeps[numbers[i]], sweeps[i], sweeps, neighbours));
  }
  for (std::size_t i = 0; i < speckle.size(); ++i)
  {
    removed[numbers[i]] = speckle[i].size();
    if (!speckle[i].empty())
    {
      TakeOut(speckle[i], volume.sweeps[numbers[i]]);
    }
  }
  return removed;
}

} // namespace nexrad
