// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/VelocityVolume.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double widestStep = 1.6; // degrees between two rays that are neighbours
constexpr double binWidth = 0.5;   // degrees
constexpr std::size_t bins = 720;

// SweepRing::rowOfBin of rows at these azimuths.
std::vector<std::size_t> RowsOfBins(const std::vector<float>& azimuths)
{
  std::vector<std::size_t> rows(bins, SweepRing::NoRow);
  std::vector<double> apart(bins, widestStep);
  for (std::size_t row = 0; row < azimuths.size(); ++row)
  {
    const auto azimuth = static_cast<double>(azimuths[row]);
    const auto centre = static_cast<std::ptrdiff_t>(azimuth / binWidth);
    for (std::ptrdiff_t step = -3; step <= 3; ++step)
    {
      const auto bin = static_cast<std::size_t>((centre + step + std::ptrdiff_t(bins))) % bins;
      const double distance =
        std::abs(AngleDifference((static_cast<double>(bin) + 0.5) * binWidth, azimuth));
      if (distance < apart[bin])
      {
        apart[bin] = distance;
        rows[bin] = row;
      }
    }
  }
  return rows;
}

} // namespace

VelocityVolume MakeVelocityVolume(const PolarVolume& volume)
{
  VelocityVolume velocities;
  for (const PolarSweep& polar : volume.sweeps)
  {
    VelocitySweep& sweep = velocities.sweeps.emplace_back();
    sweep.elevation = MedianElevation(polar);
    sweep.firstGate = polar.firstGate;
    sweep.gateSpacing = polar.gateSpacing;
    sweep.gates = polar.gates;
    sweep.values.reserve(polar.rays.size() * polar.gates);
    sweep.states.reserve(polar.rays.size() * polar.gates);
    std::vector<std::uint16_t> codes(polar.gates);
    for (std::size_t ray = 0; ray < polar.rays.size(); ++ray)
    {
      const PolarRay& own = polar.rays[ray];
      sweep.rays.push_back({own.azimuth, own.elevation, own.nyquist});
      polar.Read(ray, codes.data());
      for (const std::uint16_t code : codes)
      {
        const GateState state = StateOf(code);
        sweep.states.push_back(state);
        sweep.values.push_back(state == GateState::Valid ? polar.scale.ValueOf(code)
                                                         : std::numeric_limits<float>::quiet_NaN());
      }
    }
  }
  return velocities;
}

SweepRing MakeSweepRing(const VelocitySweep& sweep)
{
  SweepRing ring;
  static_cast<RangeGates&>(ring) = sweep;
  ring.rows = sweep.rays.size();
  ring.velocity.reserve(ring.rows * ring.gates);
  std::vector<std::pair<float, std::size_t>> order; // azimuth and ray
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const float turned = std::fmod(sweep.rays[ray].azimuth, 360.0F);
    order.emplace_back(turned < 0.0F ? turned + 360.0F : turned, ray);
  }
  std::sort(order.begin(), order.end());
  for (const auto& [azimuth, ray] : order)
  {
    ring.ray.push_back(ray);
    ring.azimuth.push_back(azimuth);
    ring.nyquist.push_back(sweep.rays[ray].nyquist);
    const auto first = sweep.values.begin() + static_cast<std::ptrdiff_t>(sweep.Index(ray, 0));
    ring.velocity.insert(
      ring.velocity.end(), first, first + static_cast<std::ptrdiff_t>(sweep.gates));
    if (!(ring.nyquist.back() > 0.0F))
    {
      std::fill(ring.velocity.end() - static_cast<std::ptrdiff_t>(sweep.gates), ring.velocity.end(),
        std::numeric_limits<float>::quiet_NaN());
    }
  }
  for (std::size_t row = 0; row < ring.rows; ++row)
  {
    const double step = AngleDifference(
      static_cast<double>(ring.azimuth[row]), static_cast<double>(ring.azimuth[ring.NextRow(row)]));
    ring.beside.push_back(ring.rows > 2 && std::abs(step) <= widestStep ? 1 : 0);
  }
  ring.rowOfBin = RowsOfBins(ring.azimuth);
  return ring;
}

std::size_t SweepRing::RowAt(float azimuth) const
{
  return rowOfBin[static_cast<std::size_t>(static_cast<double>(azimuth) / binWidth) % bins];
}

} // namespace nexrad
