// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Quality/EchoGrid.h"

#include "nexrad/Geometry/Angles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

namespace nexrad
{

SweepRays::SweepRays(const PolarSweep& sweep)
  : elevation(MedianElevation(sweep))
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
    linked.push_back(next != place && apart <= WidestGap ? 1 : 0);
  }
}

std::size_t SweepRays::PlaceAt(double azimuth, double farthest) const
{
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

std::size_t SweepRays::Beside(std::size_t place, int step) const
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

EchoGrid::EchoGrid(const PolarSweep& sweep)
  : SweepRays(sweep)
  , first(sweep.firstGate)
  , spacing(sweep.gateSpacing)
  , gates(sweep.gates)
{
  std::size_t count = gates;
  for (std::size_t place = 0; place < this->Rays(); ++place)
  {
    held.push_back(sweep.rows.Held(this->RayAt(place), gates));
    starts.push_back(count - held.back().begin);
    count += held.back().Size();
  }
  held.push_back({});
  starts.push_back(count);
  values.reset(new float[count]);
  std::vector<std::uint16_t> codes(gates);
  for (std::size_t place = 0; place < this->Rays(); ++place)
  {
    sweep.rows.Read(this->RayAt(place), held[place].end, codes.data());
    float* row = values.get() + starts[place];
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

void EchoGrid::Read(std::size_t place, const GateRange& range, float* to) const
{
  std::fill_n(to, range.Size(), NoNumber);
  const GateRange own = Common(range, held[place]);
  if (!own.IsEmpty())
  {
    std::copy_n(this->Row(place) + own.begin, own.Size(), to + (own.begin - range.begin));
  }
}

GateRegions::GateRegions(const EchoGrid& grid, const std::vector<std::uint8_t>& members)
{
  std::vector<std::size_t> firstRuns;
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    firstRuns.push_back(runs.size());
    const std::uint8_t* row = members.data() + grid.Index(place, 0);
    const GateRange held = grid.Held(place);
    const std::uint8_t* last = row + held.end;
    for (const std::uint8_t* begin = SkipZeros(row + held.begin, last); begin != last;)
    {
      const std::uint8_t* end = std::find(begin, last, std::uint8_t(0));
      runs.push_back({static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(begin - row),
        static_cast<std::uint32_t>(end - row), 0});
      begin = SkipZeros(end, last);
    }
  }
  firstRuns.push_back(runs.size());
  parents.resize(runs.size());
  std::iota(parents.begin(), parents.end(), std::uint32_t(0));
  for (std::size_t place = 0; place < grid.Rays(); ++place)
  {
    const std::size_t beside = grid.Beside(place, 1);
    if (beside < grid.Rays() && beside != place)
    {
      this->Join(place, beside, firstRuns);
    }
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
  {
    const std::uint32_t root = this->RootOf(static_cast<std::uint32_t>(i));
    // A root comes before all other runs of its region.
    runs[i].region = root == i ? static_cast<std::uint32_t>(count++) : runs[root].region;
  }
}

std::uint32_t GateRegions::RootOf(std::uint32_t run)
{
  while (parents[run] != run)
  {
    parents[run] = parents[parents[run]];
    run = parents[run];
  }
  return run;
}

// Joins the runs of two rows that touch.
void GateRegions::Join(
  std::size_t first, std::size_t second, const std::vector<std::size_t>& firstRuns)
{
  std::size_t one = firstRuns[first];
  std::size_t other = firstRuns[second];
  while (one < firstRuns[first + 1] && other < firstRuns[second + 1])
  {
    if (runs[one].begin <= runs[other].end && runs[other].begin <= runs[one].end)
    {
      const std::uint32_t a = this->RootOf(static_cast<std::uint32_t>(one));
      const std::uint32_t b = this->RootOf(static_cast<std::uint32_t>(other));
      parents[std::max(a, b)] = std::min(a, b);
    }
    (runs[one].end < runs[other].end ? one : other) += 1;
  }
}

} // namespace nexrad
