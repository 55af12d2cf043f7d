// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/MomentChecks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace nexrad
{

namespace
{

// What the values of a moment's words may be, in its unit.
struct ValueLimits
{
  double lowestFrom; // the lowest value lies from here
  double lowestTo;   // to here
  double highest;    // the highest value is at least this
  double largestStep;
};

// In the order of MomentName. Codings of real files: REF -32 by 0.5; VEL -63.5 by 0.5 or -127 by 1;
// SW -63.5 by 0.5; ZDR -7.9 by 1/16 or -13 by 1/32; PHI 0 by 0.35; RHO 0.21 by 1/300; CFP 0 by 1.
constexpr std::array<ValueLimits, MomentCount> limits = {{
  {-100.0, 0.0, 30.0, 2.0},  // REF
  {-300.0, 0.0, 5.0, 4.0},   // VEL
  {-300.0, 1.0, 5.0, 4.0},   // SW
  {-50.0, 0.0, 2.0, 1.0},    // ZDR
  {-360.0, 10.0, 80.0, 4.0}, // PHI
  {-1.0, 0.9, 0.9, 0.1},     // RHO
  {-100.0, 10.0, 10.0, 2.0}, // CFP
}};

bool IsPossible(MomentName name, const MomentRow& row)
{
  const ValueLimits& limit = limits[static_cast<std::size_t>(name)];
  const double largestWord = row.wordBits == 16 ? 65535.0 : 255.0;
  const double scale = static_cast<double>(row.scale);
  const double lowest = (row.firstValue - static_cast<double>(row.offset)) / scale;
  const double highest = (largestWord - static_cast<double>(row.offset)) / scale;
  return scale > 0.0 && 1.0 / scale <= limit.largestStep && lowest >= limit.lowestFrom &&
         lowest <= limit.lowestTo && highest >= limit.highest;
}

using Coding = std::tuple<float, float, std::uint8_t>;

Coding CodingOf(const MomentRow& row)
{
  return {row.scale, row.offset, row.wordBits};
}

std::string DescribeCoding(const Coding& coding)
{
  char text[96];
  std::snprintf(text, sizeof text, "scale %.9g, offset %.9g and %d bits",
    static_cast<double>(std::get<0>(coding)), static_cast<double>(std::get<1>(coding)),
    static_cast<int>(std::get<2>(coding)));
  return text;
}

// Of the properties that rows of a sweep have, counted by rays, those that most have. Who makes a
// table of a sweep makes one for each.
template <class Property>
std::set<Property> FindCommon(const std::map<Property, std::size_t>& counts)
{
  constexpr std::size_t mostKept = 4;
  std::vector<std::pair<std::size_t, Property>> sorted;
  for (const auto& [property, rays] : counts)
  {
    sorted.emplace_back(rays, property);
  }
  const std::size_t kept = std::min(sorted.size(), mostKept);
  std::partial_sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(kept),
    sorted.end(), std::greater<>());
  std::set<Property> common;
  for (std::size_t i = 0; i < kept; ++i)
  {
    common.insert(sorted[i].second);
  }
  return common;
}

// The coding of more than half of the rays that have the moment; the most common ones where there
// is none.
std::set<Coding> FindCommonCodings(const std::map<Coding, std::size_t>& counts)
{
  std::size_t all = 0;
  for (const auto& entry : counts)
  {
    all += entry.second;
  }
  for (const auto& [coding, rays] : counts)
  {
    if (2 * rays > all)
    {
      return {coding};
    }
  }
  return FindCommon(counts);
}

// Why the row of a ray cannot be believed; "" when it can.
std::string FindCodingFault(MomentName name, const MomentRow& row, const std::set<Coding>& common)
{
  const bool possible = IsPossible(name, row);
  if (possible && common.count(CodingOf(row)) > 0)
  {
    return {};
  }
  const std::string has = std::string(ToString(name)) + " has " + DescribeCoding(CodingOf(row));
  return has +
         (!possible ? ", which give values that it cannot have"
           : common.size() > 1
             ? ", which few rays of its sweep have"
             : ", most rays of its sweep have " + DescribeCoding(*common.begin())) +
         ": left out";
}

using GateGeometry = std::pair<std::int32_t, std::int32_t>; // first gate and distance, m

GateGeometry GeometryOf(const MomentRow& row)
{
  return {row.firstGate, row.gateSpacing};
}

std::string FindGeometryFault(
  MomentName name, const MomentRow& row, const std::set<GateGeometry>& common)
{
  return common.count(GeometryOf(row)) > 0
           ? ""
           : std::string(ToString(name)) +
               " has its gates where few rays of its sweep have theirs: left out";
}

// Takes out the rows that have a fault, judged by what the rows of a moment in a sweep have in
// common.
template <class Property>
void RemoveRows(RadarVolume& volume, const RayDamageReceiver& report,
  Property (*propertyOf)(const MomentRow&),
  std::set<Property> (*findCommon)(const std::map<Property, std::size_t>& counts),
  std::string (*findFault)(MomentName, const MomentRow&, const std::set<Property>& common))
{
  for (std::size_t index = 0; index < volume.sweeps.size(); ++index)
  {
    std::vector<Ray>& rays = volume.sweeps[index].rays;
    for (const MomentName name : AllMoments)
    {
      std::map<Property, std::size_t> counts;
      for (const Ray& ray : rays)
      {
        if (ray.Row(name).gates > 0)
        {
          ++counts[propertyOf(ray.Row(name))];
        }
      }
      const std::set<Property> common = findCommon(counts);
      for (std::size_t ray = 0; ray < rays.size(); ++ray)
      {
        MomentRow& row = rays[ray].Row(name);
        const std::string fault = row.gates > 0 ? findFault(name, row, common) : "";
        if (!fault.empty())
        {
          report(index, ray, fault);
          row = MomentRow{};
        }
      }
    }
  }
}

// Gates of the rays of a sweep, and places for them in a table.
struct SweepSize
{
  std::size_t rays = 0;
  std::size_t gates = 0;
  std::size_t widest = 0;

  std::size_t Places() const { return rays * widest; }
};

constexpr std::size_t placesPerGate = 2;

SweepSize SizeOf(const Sweep& sweep, MomentName name)
{
  SweepSize size;
  for (const Ray& ray : sweep.rays)
  {
    const std::size_t gates = ray.Row(name).gates;
    size.rays += gates > 0 ? 1 : 0;
    size.gates += gates;
    size.widest = std::max(size.widest, gates);
  }
  return size;
}

void CutSweep(
  RadarVolume& volume, std::size_t index, MomentName name, const RayDamageReceiver& report)
{
  Sweep& sweep = volume.sweeps[index];
  const SweepSize size = SizeOf(sweep, name);
  if (size.Places() <= placesPerGate * size.gates)
  {
    return;
  }
  const std::size_t kept = placesPerGate * size.gates / size.rays;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    MomentRow& row = sweep.rays[ray].Row(name);
    if (row.gates > kept)
    {
      report(index, ray,
        std::string(ToString(name)) + " has " + std::to_string(row.gates) +
          " gates, the rays of its sweep " + std::to_string(size.gates / size.rays) +
          " in the mean: those from " + std::to_string(kept) + " on are left out");
      row.gates = static_cast<std::uint16_t>(kept);
    }
  }
}

void CutWideRows(RadarVolume& volume, const RayDamageReceiver& report)
{
  constexpr std::size_t alwaysAllowed = std::size_t(1) << 22;
  std::size_t places = 0;
  std::size_t gates = 0;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const MomentName name : AllMoments)
    {
      const SweepSize size = SizeOf(sweep, name);
      places += size.Places();
      gates += size.gates;
    }
  }
  if (places <= placesPerGate * gates + alwaysAllowed)
  {
    return;
  }
  for (std::size_t index = 0; index < volume.sweeps.size(); ++index)
  {
    for (const MomentName name : AllMoments)
    {
      CutSweep(volume, index, name, report);
    }
  }
}

} // namespace

void CheckMoments(RadarVolume& volume, const RayDamageReceiver& report)
{
  RemoveRows(volume, report, CodingOf, FindCommonCodings, FindCodingFault);
  RemoveRows(volume, report, GeometryOf, FindCommon<GateGeometry>, FindGeometryFault);
  CutWideRows(volume, report);
}

} // namespace nexrad
