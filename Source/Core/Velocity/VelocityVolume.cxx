// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/VelocityVolume.h"

#include "nexrad/Model/Elevation.h"
#include "nexrad/Model/MomentLimits.h"
#include "nexrad/Polar/PolarVolume.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace nexrad
{

namespace
{

using RayList = std::vector<const Ray*>;

void SetRay(VelocitySweep& sweep, std::size_t index, const Ray& ray)
{
  const MomentRow& row = ray.Row(MomentName::VEL);
  const std::size_t first = sweep.Index(index, 0);
  for (std::size_t gate = 0; gate < row.gates; ++gate)
  {
    const GateState state = row.State(gate);
    const float value = row.Value(gate);
    const bool valid = state == GateState::Valid && std::isfinite(value);
    sweep.states[first + gate] = valid                       ? VelocityState::Valid
                                 : state == GateState::Valid ? VelocityState::NotSampled
                                                             : VelocityState(state);
    if (valid)
    {
      sweep.values[first + gate] = value;
    }
  }
  for (const std::size_t gate : ImpossibleGates(ray, MomentName::VEL))
  {
    sweep.states[first + gate] = VelocityState::NotSampled;
    sweep.values[first + gate] = std::numeric_limits<float>::quiet_NaN();
  }
}

VelocitySweep MakeSweep(const RayList& rays)
{
  VelocitySweep sweep;
  const MomentRow& first = rays.front()->Row(MomentName::VEL);
  sweep.elevationNumber = rays.front()->elevationNumber;
  sweep.firstGate = first.firstGate;
  sweep.gateSpacing = first.gateSpacing;
  std::vector<double> elevations;
  for (const Ray* ray : rays)
  {
    sweep.gates = std::max<std::size_t>(sweep.gates, ray->Row(MomentName::VEL).gates);
    sweep.rays.push_back({ray->azimuth, ray->elevation, ray->nyquist, ray->time});
    elevations.push_back(static_cast<double>(ray->elevation));
  }
  sweep.elevation = MedianOf(std::move(elevations));
  sweep.values.assign(rays.size() * sweep.gates, std::numeric_limits<float>::quiet_NaN());
  sweep.states.assign(rays.size() * sweep.gates, VelocityState::NotSampled);
  for (std::size_t index = 0; index < rays.size(); ++index)
  {
    SetRay(sweep, index, *rays[index]);
  }
  return sweep;
}

} // namespace

VelocityVolume MakeVelocityVolume(const RadarVolume& volume)
{
  VelocityVolume velocities;
  velocities.site = volume.site;
  velocities.start = volume.Start().value_or(Time{});
  velocities.end = volume.End().value_or(Time{});
  velocities.synthetic = volume.synthetic;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const RayList& rays : RaysByGeometry(sweep, MomentName::VEL))
    {
      velocities.sweeps.push_back(MakeSweep(rays));
    }
  }
  return velocities;
}

void FoldVelocities(VelocitySweep& sweep, float nyquist)
{
  if (!(nyquist > 0.0F))
  {
    throw Error("a Nyquist velocity of " + std::to_string(nyquist) + " m/s; it must be above 0");
  }
  for (VelocityRay& ray : sweep.rays)
  {
    ray.nyquist = nyquist;
  }
  for (float& value : sweep.values)
  {
    value = std::remainder(value, 2.0F * nyquist); // NaN stays NaN
  }
}

} // namespace nexrad
