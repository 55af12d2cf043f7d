// SPDX-License-Identifier: BSD-3-Clause
#include "VelocityScan.h"

#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"

#include <cmath>
#include <limits>
#include <random>

namespace nexrad::testing
{

namespace
{

// A sum of twelve even numbers, which all standard libraries give alike.
double Noise(std::mt19937& generator)
{
  double sum = -6.0;
  for (int each = 0; each < 12; ++each)
  {
    sum += static_cast<double>(generator()) / 4294967296.0;
  }
  return sum;
}

VelocitySweep ScanSweep(const VelocityScan& scan, double elevation, std::mt19937& generator)
{
  VelocitySweep sweep;
  sweep.elevation = elevation;
  sweep.firstGate = scan.gateSpacing;
  sweep.gateSpacing = scan.gateSpacing;
  sweep.gates = scan.gates;
  const BeamModel beam;
  for (std::size_t ray = 0; ray < scan.rays; ++ray)
  {
    const double azimuth =
      360.0 * (static_cast<double>(ray) + 0.5) / static_cast<double>(scan.rays);
    const double sine = std::sin(azimuth * RadiansPerDegree);
    const double cosine = std::cos(azimuth * RadiansPerDegree);
    sweep.rays.push_back({static_cast<float>(azimuth), static_cast<float>(elevation), 0.0F});
    for (std::size_t gate = 0; gate < scan.gates; ++gate)
    {
      const BeamPoint point = beam.Locate(sweep.RangeOf(gate), elevation);
      const PlaceOverRadar place = {
        point.groundDistance * sine, point.groundDistance * cosine, point.height};
      const double noise = scan.noise * Noise(generator);
      const bool echo = !scan.echo || scan.echo(place);
      const Wind wind = scan.wind(place);
      const double radial =
        (wind.east * sine + wind.north * cosine) * std::cos(elevation * RadiansPerDegree);
      sweep.states.push_back(echo ? GateState::Valid : GateState::BelowThreshold);
      sweep.values.push_back(
        echo ? static_cast<float>(radial + noise) : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return sweep;
}

} // namespace

VelocityVolume ScanVelocities(const VelocityScan& scan)
{
  std::mt19937 generator(14);
  VelocityVolume volume;
  for (const double elevation : scan.elevations)
  {
    volume.sweeps.push_back(ScanSweep(scan, elevation, generator));
  }
  return volume;
}

void FoldVelocities(VelocitySweep& sweep, float nyquist)
{
  for (VelocityRay& ray : sweep.rays)
  {
    ray.nyquist = nyquist;
  }
  for (float& value : sweep.values)
  {
    value = std::remainder(value, 2.0F * nyquist); // NaN stays NaN
  }
}

VelocityVolume FoldedAt(VelocityVolume volume, float nyquist)
{
  for (VelocitySweep& sweep : volume.sweeps)
  {
    FoldVelocities(sweep, nyquist);
  }
  return volume;
}

} // namespace nexrad::testing
