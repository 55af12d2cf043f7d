// SPDX-License-Identifier: BSD-3-Clause
// A synthetic field of echo that moves, and radars that scan it ray by ray, each at its own time.
#pragma once

#include "SweepMaker.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Motion/MotionField.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// Round storms, the same at all heights, all with one velocity. Places in m east and north of a
/// radar, or of what else the caller counts from; times in s from the same moment.
struct MovingEcho
{
  struct Storm
  {
    double east = 0.0;
    double north = 0.0; ///< at second 0
    double dbz = 50.0;  ///< in its middle
  };
  static constexpr double Length = 8'000.0; ///< m, to 1/e
  static constexpr double Threshold = 5.0;  ///< dBZ, what is weaker is no echo

  std::vector<Storm> storms;
  Velocity velocity;

  /// dBZ
  double At(double east, double north, double seconds) const
  {
    double strongest = 0.0;
    for (const Storm& storm : storms)
    {
      const double x = (east - storm.east - velocity.east * seconds) / Length;
      const double y = (north - storm.north - velocity.north * seconds) / Length;
      strongest = std::max(strongest, storm.dbz * std::exp(-x * x - y * y));
    }
    return strongest;
  }
};

/// How a radar scans.
struct ScanPlan
{
  std::vector<double> tilts = {0.5, 1.4, 2.4, 3.4, 4.3, 6.0}; ///< degrees
  double secondsPerSweep = 20.0;
  std::size_t rays = 360;
  std::size_t gates = 140;
  double gateSpacing = 1'000.0; ///< m
  double firstAzimuth = 0.0;    ///< degrees, of each sweep
};

/// A volume that starts `start` seconds after `zero`. The radar stands `east` and `north` m from
/// where the field counts from; the ground is taken as flat between them.
inline PolarVolume ScanEcho(const MovingEcho& field, const Site& site, Time zero, double start,
  const ScanPlan& plan = {}, double east = 0.0, double north = 0.0)
{
  const auto at = [zero](double seconds)
  { return zero + Duration(std::llround(seconds * 1000.0)); };
  const BeamModel beam;
  PolarVolume volume;
  volume.site = site;
  volume.start = at(start);
  for (std::size_t tilt = 0; tilt < plan.tilts.size(); ++tilt)
  {
    NumberSweep sweep;
    sweep.elevationNumber = static_cast<int>(tilt) + 1;
    sweep.firstGate = sweep.gateSpacing = plan.gateSpacing;
    sweep.gates = plan.gates;
    for (std::size_t ray = 0; ray < plan.rays; ++ray)
    {
      const double part = static_cast<double>(ray) / static_cast<double>(plan.rays);
      const double seconds = start + plan.secondsPerSweep * (static_cast<double>(tilt) + part);
      const double azimuth = std::fmod(plan.firstAzimuth + 360.0 * part, 360.0);
      sweep.rays.push_back(
        {static_cast<float>(azimuth), static_cast<float>(plan.tilts[tilt]), 0.0F, at(seconds)});
      volume.end = at(seconds);
      for (std::size_t gate = 0; gate < plan.gates; ++gate)
      {
        const double range = plan.gateSpacing * static_cast<double>(gate + 1);
        const double ground = beam.Locate(range, plan.tilts[tilt]).groundDistance;
        const double dbz = field.At(east + ground * std::sin(azimuth * RadiansPerDegree),
          north + ground * std::cos(azimuth * RadiansPerDegree), seconds);
        const bool echo = dbz >= MovingEcho::Threshold;
        sweep.values.push_back(
          echo ? static_cast<float>(dbz) : std::numeric_limits<float>::quiet_NaN());
        sweep.states.push_back(echo ? GateState::Valid : GateState::BelowThreshold);
      }
    }
    volume.sweeps.push_back(sweep);
  }
  return volume;
}

} // namespace nexrad::testing
