// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/PolarVolume.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace nexrad
{

namespace
{

using RayList = std::vector<const Ray*>;

// The rays of a sweep that have the moment, by gate geometry, in the order in which each geometry
// comes first. Nearly always there is one.
std::vector<RayList> GroupByGeometry(const Sweep& sweep, MomentName moment)
{
  std::vector<RayList> groups;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> places;
  for (const Ray& ray : sweep.rays)
  {
    const MomentRow& row = ray.Row(moment);
    if (row.gates > 0)
    {
      const auto place = places.emplace(std::pair(row.firstGate, row.gateSpacing), groups.size());
      if (place.second)
      {
        groups.emplace_back();
      }
      groups[place.first->second].push_back(&ray);
    }
  }
  return groups;
}

void FillRay(const MomentRow& row, std::size_t start, PolarSweep& sweep)
{
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    const GateState state = row.State(gate);
    sweep.states[start + gate] = state;
    if (state == GateState::Valid)
    {
      sweep.values[start + gate] = row.Value(gate);
    }
  }
}

PolarSweep MakeSweep(const RayList& rays, MomentName moment)
{
  PolarSweep sweep;
  const MomentRow& first = rays.front()->Row(moment);
  sweep.elevationNumber = rays.front()->elevationNumber;
  sweep.firstGate = first.firstGate;
  sweep.gateSpacing = first.gateSpacing;
  for (const Ray* ray : rays)
  {
    sweep.gates = std::max<std::size_t>(sweep.gates, ray->Row(moment).gates);
    sweep.rays.push_back({ray->azimuth, ray->elevation, ray->time});
  }
  const std::size_t count = rays.size() * sweep.gates;
  sweep.values.assign(count, std::numeric_limits<float>::quiet_NaN());
  sweep.states.assign(count, GateState::NotSampled);
  for (std::size_t index = 0; index < rays.size(); ++index)
  {
    FillRay(rays[index]->Row(moment), sweep.Index(index, 0), sweep);
  }
  return sweep;
}

} // namespace

PolarVolume MakePolarVolume(const RadarVolume& volume, MomentName moment)
{
  PolarVolume polar;
  polar.site = volume.site;
  polar.moment = moment;
  polar.start = volume.Start().value_or(Time{});
  polar.end = volume.End().value_or(Time{});
  polar.synthetic = volume.synthetic;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const RayList& rays : GroupByGeometry(sweep, moment))
    {
      polar.sweeps.push_back(MakeSweep(rays, moment));
    }
  }
  return polar;
}

} // namespace nexrad
