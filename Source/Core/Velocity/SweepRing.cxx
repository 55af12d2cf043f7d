// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/SweepRing.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double widestStep = 1.6; // degrees between two rays that are neighbours
constexpr double binWidth = 0.5;   // degrees
constexpr std::size_t bins = 720;

std::vector<std::pair<float, std::size_t>> OrderRays(const VelocitySweep& sweep)
{
  std::vector<std::pair<float, std::size_t>> order;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const float turned = std::fmod(sweep.rays[ray].azimuth, 360.0F);
    order.emplace_back(turned < 0.0F ? turned + 360.0F : turned, ray);
  }
  std::sort(order.begin(), order.end());
  return order;
}

} // namespace

SweepRing MakeSweepRing(const VelocitySweep& sweep)
{
  SweepRing ring;
  ring.rows = sweep.rays.size();
  ring.gates = sweep.gates;
  ring.elevation = sweep.elevation;
  ring.firstGate = sweep.firstGate;
  ring.gateSpacing = sweep.gateSpacing;
  ring.velocity.reserve(ring.rows * ring.gates);
  for (const auto& [azimuth, ray] : OrderRays(sweep))
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
  return ring;
}

RowFinder::RowFinder(const SweepRing& ring)
  : rowOfBin(bins, None)
{
  std::vector<double> apart(bins, widestStep);
  for (std::size_t row = 0; row < ring.rows; ++row)
  {
    const auto centre =
      static_cast<std::ptrdiff_t>(static_cast<double>(ring.azimuth[row]) / binWidth);
    for (std::ptrdiff_t step = -3; step <= 3; ++step)
    {
      const auto bin = static_cast<std::size_t>((centre + step + std::ptrdiff_t(bins))) % bins;
      const double distance = std::abs(AngleDifference(
        (static_cast<double>(bin) + 0.5) * binWidth, static_cast<double>(ring.azimuth[row])));
      if (distance < apart[bin])
      {
        apart[bin] = distance;
        rowOfBin[bin] = row;
      }
    }
  }
}

std::size_t RowFinder::RowAt(float azimuth) const
{
  return rowOfBin[static_cast<std::size_t>(static_cast<double>(azimuth) / binWidth) % bins];
}

} // namespace nexrad
