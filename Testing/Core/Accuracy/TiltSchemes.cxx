// SPDX-License-Identifier: BSD-3-Clause
#include "TiltSchemes.h"

#include "PolarMerge.h"
#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

GridSpecification GridAbout(const Position& site, double farthest, double top)
{
  constexpr double width = 1'000.0;
  constexpr double height = 250.0;
  const int columns = 2 * static_cast<int>(std::ceil(farthest / width)) + 3;
  GridSpecification grid;
  grid.dimensions = {columns, columns, static_cast<int>(std::ceil(top / height)) + 1};
  grid.spacing = {width, width, height};
  grid.origin = {
    -0.5 * width * (columns - 1), -0.5 * width * (columns - 1), site.altitude + 0.5 * height};
  grid.centreLatitude = site.latitude;
  grid.centreLongitude = site.longitude;
  return grid;
}

} // namespace

std::optional<double> MeasuredAt(
  const testing::NumberSweep& sweep, std::size_t ray, std::size_t gate)
{
  const std::size_t at = sweep.Index(ray, gate);
  switch (sweep.states[at])
  {
  case GateState::Valid:
    return std::max<double>(sweep.values[at], 0.0);
  case GateState::BelowThreshold:
    return 0.0;
  default:
    return std::nullopt;
  }
}

SortedTilt::SortedTilt(const PolarSweep& ofSweep)
  : sweep(testing::NumbersOf(ofSweep))
  , elevation(MedianElevation(ofSweep))
{
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      measured.push_back(static_cast<float>(
        MeasuredAt(sweep, ray, gate).value_or(std::numeric_limits<double>::quiet_NaN())));
    }
  }
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    for (const double turn : {-360.0, 0.0, 360.0})
    {
      const double azimuth = static_cast<double>(sweep.rays[ray].azimuth) + turn;
      if (azimuth >= -180.0 && azimuth <= 540.0)
      {
        rays.emplace_back(azimuth, ray);
      }
    }
  }
  std::sort(rays.begin(), rays.end());
}

const SortedTilt::Ray& SortedTilt::Nearest(double azimuth) const
{
  const auto after = std::lower_bound(rays.begin(), rays.end(), Ray(azimuth, 0));
  if (after == rays.begin())
  {
    return *after;
  }
  const auto before = std::prev(after);
  return after == rays.end() || azimuth - before->first < after->first - azimuth ? *before : *after;
}

void SortedTilt::Visit(
  double azimuth, double window, const std::function<void(const Ray&)>& visit) const
{
  const auto end = std::upper_bound(rays.begin(), rays.end(), Ray(azimuth + window, rays.size()));
  std::for_each(std::lower_bound(rays.begin(), rays.end(), Ray(azimuth - window, 0)), end, visit);
}

NearestScheme::NearestScheme(const std::vector<SortedTilt>& theTilts)
  : tilts(theTilts)
{
}

ElevationProfile NearestScheme::ProfileAt(double azimuth, double range) const
{
  std::vector<std::pair<double, double>> gates; // elevation and value
  for (const SortedTilt& tilt : tilts)
  {
    const testing::NumberSweep& sweep = tilt.sweep;
    const std::size_t ray = tilt.Nearest(azimuth).second;
    const long gate = std::lround((range - sweep.firstGate) / sweep.gateSpacing);
    const bool isWithin = gate >= 0 && gate < static_cast<long>(sweep.gates);
    if (const float value = isWithin ? tilt.Gates(ray)[gate] : NAN; !std::isnan(value))
    {
      gates.emplace_back(static_cast<double>(sweep.rays[ray].elevation), value);
    }
  }
  return [gates](double elevation) -> std::optional<double>
  {
    const auto nearest = std::min_element(gates.begin(), gates.end(),
      [elevation](const auto& a, const auto& b)
      { return std::abs(a.first - elevation) < std::abs(b.first - elevation); });
    return nearest == gates.end() ? std::nullopt : std::optional<double>(nearest->second);
  };
}

BarnesScheme::BarnesScheme(const std::vector<SortedTilt>& theTilts, const BarnesLengths& theLengths)
  : tilts(theTilts)
  , lengths(theLengths)
{
}

BarnesScheme::TiltSum BarnesScheme::SumOver(
  const SortedTilt& tilt, double azimuth, double range) const
{
  const double window = 2.0 * lengths.horizontal; // the weight is 0.02 there
  const testing::NumberSweep& sweep = tilt.sweep;
  const double across =
    range * std::cos(tilt.elevation * RadiansPerDegree) * RadiansPerDegree; // m in a degree
  const auto gateAt = [&sweep](double at)
  { return std::ceil((at - sweep.firstGate) / sweep.gateSpacing); };
  const auto first = static_cast<std::size_t>(std::max(gateAt(range - window), 0.0));
  const auto end =
    std::min(sweep.gates, static_cast<std::size_t>(std::max(gateAt(range + window), 0.0)));
  const auto weightOf = [scale = 1.0 / (lengths.horizontal * lengths.horizontal)](double off)
  { return std::exp(-off * off * scale); };
  std::vector<double> along;
  for (std::size_t gate = first; gate < end; ++gate)
  {
    along.push_back(
      weightOf(sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate) - range));
  }
  TiltSum sum{tilt.elevation, 0.0, 0.0};
  const auto add = [&](const SortedTilt::Ray& ray)
  {
    const double aside = weightOf((ray.first - azimuth) * across);
    const float* const gates = tilt.Gates(ray.second) + first;
    for (std::size_t gate = 0; gate < along.size(); ++gate)
    {
      const double weight = std::isnan(gates[gate]) ? 0.0 : aside * along[gate];
      sum.values += weight > 0.0 ? weight * gates[gate] : 0.0;
      sum.weights += weight;
    }
  };
  tilt.Visit(azimuth, std::max(window / across, 0.6), add);
  return sum;
}

ElevationProfile BarnesScheme::ProfileAt(double azimuth, double range) const
{
  std::vector<TiltSum> sums;
  for (const SortedTilt& tilt : tilts)
  {
    sums.push_back(this->SumOver(tilt, azimuth, range));
  }
  return [sums, kappa = lengths.vertical](double elevation) -> std::optional<double>
  {
    // Not divided by their least distance, all weights would vanish far from the tilts.
    double least = 1e9;
    for (const TiltSum& sum : sums)
    {
      least = sum.weights > 0.0 ? std::min(least, std::abs(sum.elevation - elevation)) : least;
    }
    double values = 0.0;
    double weights = 0.0;
    for (const TiltSum& sum : sums)
    {
      const double off = sum.elevation - elevation;
      const double weight = std::exp((least * least - off * off) / (kappa * kappa));
      values += weight * sum.values;
      weights += weight * sum.weights;
    }
    return weights > 0.0 ? std::optional<double>(values / weights) : std::nullopt;
  };
}

MergedScheme::MergedScheme(
  const PolarVolume& from, const BeamMergeOptions& options, double farthest, double highest)
  : altitude(from.site.position->altitude)
{
  const double top = std::min(18'000.0, beam.HeightOver(farthest, highest));
  BeamMerger merger(GridAbout(*from.site.position, farthest, top), options);
  volume = *testing::MergePolar(merger, {&from}, from.start, ThreadLoop(2));
}

ElevationProfile MergedScheme::ProfileAt(double azimuth, double range) const
{
  const double east = std::sin(azimuth * RadiansPerDegree);
  const double north = std::cos(azimuth * RadiansPerDegree);
  return [this, east, north, range](double elevation)
  {
    const BeamPoint point = beam.Locate(range, elevation);
    return this->At(
      {point.groundDistance * east, point.groundDistance * north, point.height + altitude});
  };
}

std::optional<double> MergedScheme::At(const std::array<double, 3>& point) const
{
  const GridSpecification& grid = volume.grid;
  std::array<double, 3> place{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    place[axis] = (point[axis] - grid.origin[axis]) / grid.spacing[axis];
    if (place[axis] < 0.0 || place[axis] >= grid.dimensions[axis] - 1)
    {
      return std::nullopt;
    }
  }
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const std::array<int, 3> at{static_cast<int>(place[0]) + corner % 2,
      static_cast<int>(place[1]) + corner / 2 % 2, static_cast<int>(place[2]) + corner / 4};
    const auto index = static_cast<std::size_t>(at[2] * grid.dimensions[1] + at[1]) *
                         static_cast<std::size_t>(grid.dimensions[0]) +
                       static_cast<std::size_t>(at[0]);
    if (volume.states[index] == VoxelState::Echo)
    {
      sum += (1.0 - std::abs(place[0] - at[0])) * (1.0 - std::abs(place[1] - at[1])) *
             (1.0 - std::abs(place[2] - at[2])) * std::max<double>(volume.values[index], 0.0);
    }
    else if (volume.states[index] != VoxelState::NoEcho)
    {
      return std::nullopt;
    }
  }
  return sum;
}

} // namespace nexrad
