// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Velocity/VelocityVolume.h"

#include "nexrad/System/Error.h"

#include <cmath>
#include <limits>
#include <string>

namespace nexrad
{

namespace
{

VelocitySweep MakeSweep(const PolarSweep& polar)
{
  VelocitySweep sweep;
  sweep.elevationNumber = polar.elevationNumber;
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
    sweep.rays.push_back({own.azimuth, own.elevation, own.nyquist, own.time});
    polar.Read(ray, codes.data());
    for (const std::uint16_t code : codes)
    {
      const auto state = static_cast<VelocityState>(StateOf(code));
      sweep.states.push_back(state);
      sweep.values.push_back(state == VelocityState::Valid
                               ? polar.scale.ValueOf(code)
                               : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return sweep;
}

} // namespace

VelocityVolume MakeVelocityVolume(const RadarVolume& volume)
{
  return MakeVelocityVolume(MakePolarVolume(volume, MomentName::VEL));
}

VelocityVolume MakeVelocityVolume(const PolarVolume& volume)
{
  VelocityVolume velocities;
  velocities.site = volume.site;
  velocities.start = volume.start;
  velocities.end = volume.end;
  velocities.synthetic = volume.synthetic;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    velocities.sweeps.push_back(MakeSweep(sweep));
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
