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

// A ray and those beside it, as places in the order of azimuths; Rays() where there is none.
using RayPlaces = std::array<std::size_t, 3>;

// Which gates of a sweep have a value.
class HeldGates : public SweepRays
{
public:
  explicit HeldGates(const PolarSweep& theSweep)
    : SweepRays(theSweep)
    , sweep(theSweep)
    , cosine(std::cos(this->Elevation() * RadiansPerDegree))
  {
    std::vector<std::uint16_t> codes(sweep.gates);
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      sweep.Read(ray, codes.data());
      std::transform(codes.begin(), codes.end(), std::back_inserter(valid),
        [](std::uint16_t code)
        { return code >= GateCode::FirstValue ? std::uint8_t(1) : std::uint8_t(0); });
    }
  }

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
    const std::size_t nearest = this->PlaceAt(azimuth, WidestGap);
    return nearest < this->Rays() ? this->PlacesBeside(nearest)
                                  : RayPlaces{nearest, nearest, nearest};
  }

  RayPlaces PlacesBeside(std::size_t place) const
  {
    const bool several = this->Rays() > 2; // else the ray before is the one after
    return {several ? this->Beside(place, -1) : this->Rays(), place,
      several ? this->Beside(place, 1) : this->Rays()};
  }

  // How many of the nine gates about a gate of these rays have a value.
  int CountAbout(const RayPlaces& places, std::ptrdiff_t gate) const
  {
    int count = 0;
    const std::ptrdiff_t first = std::max<std::ptrdiff_t>(gate - 1, 0);
    const std::ptrdiff_t last = std::min(gate + 1, static_cast<std::ptrdiff_t>(sweep.gates) - 1);
    for (const std::size_t place : places)
    {
      for (std::ptrdiff_t each = first; place < this->Rays() && each <= last; ++each)
      {
        count += valid[this->RayAt(place) * sweep.gates + static_cast<std::size_t>(each)];
      }
    }
    return count;
  }

private:
  const PolarSweep& sweep;
  const double cosine;
  std::vector<std::uint8_t> valid; // 1 for a gate with a value, rays × gates
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

// Takes the gates out of a sweep that have too few neighbours.
void TakeOutSpeckle(
  const HeldGates& own, const std::vector<HeldGates>& sweeps, int neighbours, PolarSweep& sweep)
{
  const Cuts below = FindNextTilt(sweeps, own, -1.0);
  const Cuts above = FindNextTilt(sweeps, own, 1.0);
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t place = 0; place < own.Rays(); ++place)
  {
    const RayPlaces beside = own.PlacesBeside(place);
    const BesideRay lower(below, own.AzimuthAt(place));
    const BesideRay upper(above, own.AzimuthAt(place));
    sweep.Read(own.RayAt(place), codes.data());
    bool changed = false;
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      if (codes[gate] < GateCode::FirstValue)
      {
        continue;
      }
      int count = own.CountAbout(beside, static_cast<std::ptrdiff_t>(gate)) - 1;
      count += count < neighbours ? lower.CountAt(own.DistanceOf(gate)) : 0;
      count += count < neighbours ? upper.CountAt(own.DistanceOf(gate)) : 0;
      if (count < neighbours)
      {
        codes[gate] = GateCode::Filtered;
        changed = true;
      }
    }
    if (changed)
    {
      sweep.rows.Replace(own.RayAt(place), codes.data());
    }
  }
}

} // namespace

void Despeckle(PolarVolume& volume, int neighbours)
{
  if (neighbours < 0 || neighbours > MostNeighbours)
  {
    throw Error("despeckling by " + std::to_string(neighbours) +
                " neighbours: must be from 0, which keeps all, to " +
                std::to_string(MostNeighbours));
  }
  if (neighbours == 0)
  {
    return;
  }
  std::vector<PolarSweep*> sweeps;
  std::vector<HeldGates> held; // as they were
  for (PolarSweep& sweep : volume.sweeps)
  {
    if (!sweep.rays.empty() && sweep.gates > 0 && sweep.gateSpacing > 0.0)
    {
      sweeps.push_back(&sweep);
      held.emplace_back(sweep);
    }
  }
  for (std::size_t i = 0; i < sweeps.size(); ++i)
  {
    TakeOutSpeckle(held[i], held, neighbours, *sweeps[i]);
  }
}

} // namespace nexrad
