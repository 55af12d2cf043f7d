// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/EchoGrid.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace nexrad
{

namespace
{

constexpr double widestGap = 1.9; // degrees between two rays that are neighbours

} // namespace

EchoGrid::EchoGrid(const PolarSweep& sweep)
  : elevation(MedianElevation(sweep))
  , first(sweep.firstGate)
  , spacing(sweep.gateSpacing)
  , gates(sweep.gates)
  , values(sweep.rays.size() * sweep.gates, NoNumber)
  , empty(sweep.gates, NoNumber)
  , held(sweep.rays.size())
{
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sorted.emplace_back(ToFullTurn(static_cast<double>(sweep.rays[ray].azimuth)), ray);
  }
  std::sort(sorted.begin(), sorted.end());
  for (const auto& [azimuth, ray] : sorted)
  {
    azimuths.push_back(azimuth);
    order.push_back(ray);
  }
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    const std::size_t next = (place + 1) % order.size();
    const double apart = AngleBetween(azimuths[place], azimuths[next]);
    linked.push_back(next != place && apart <= widestGap ? 1 : 0);
  }
  std::vector<std::uint16_t> codes(gates);
  for (std::size_t place = 0; place < order.size(); ++place)
  {
    held[place] = sweep.rows.Held(order[place], gates);
    sweep.rows.Read(order[place], held[place].end, codes.data());
    float* row = values.data() + place * gates;
    for (std::size_t gate = held[place].begin; gate < held[place].end; ++gate)
    {
      const float value = sweep.scale.ValueOf(codes[gate]);
      row[gate] = codes[gate] >= GateCode::FirstValue ? value : NoNumber;
    }
  }
}

std::ptrdiff_t EchoGrid::GateAt(double range) const
{
  return std::lround((range - first) / spacing);
}

std::size_t EchoGrid::GatesWithin(double range) const
{
  const double count = std::floor((range - first) / spacing) + 1.0;
  return static_cast<std::size_t>(std::clamp(count, 0.0, static_cast<double>(gates)));
}

std::size_t EchoGrid::PlaceAt(double azimuth) const
{
  constexpr double farthest = 1.5; // degrees
  // Nearly always the rays lie evenly about the circle.
  const auto even = static_cast<std::size_t>(azimuth / 360.0 * static_cast<double>(order.size()));
  const std::size_t low = even - std::min<std::size_t>(even, 2);
  const std::size_t high = std::min<std::size_t>(even + 3, order.size());
  const bool lies = low < high && azimuths[low] < azimuth && azimuths[high - 1] >= azimuth;
  const auto begin = azimuths.begin() + static_cast<std::ptrdiff_t>(lies ? low : 0);
  const auto end = azimuths.begin() + static_cast<std::ptrdiff_t>(lies ? high : order.size());
  const auto next = std::lower_bound(begin, end, azimuth);
  const std::size_t after = static_cast<std::size_t>(next - azimuths.begin()) % order.size();
  const std::size_t before = (after + order.size() - 1) % order.size();
  const auto apart = [&](std::size_t place) { return AngleBetween(azimuths[place], azimuth); };
  const std::size_t nearest = apart(before) < apart(after) ? before : after;
  return apart(nearest) <= farthest ? nearest : order.size();
}

std::size_t EchoGrid::Beside(std::size_t place, int step) const
{
  const std::size_t count = order.size();
  for (int i = 0; i < std::abs(step); ++i)
  {
    const std::size_t next = (place + (step > 0 ? 1 : count - 1)) % count;
    if (linked[step > 0 ? place : next] == 0)
    {
      return count;
    }
    place = next;
  }
  return place;
}

const float* EchoGrid::RowBeside(std::size_t place, int step) const
{
  const std::size_t beside = this->Beside(place, step);
  return beside < this->Rays() ? this->Row(beside) : empty.data();
}

} // namespace nexrad
