// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/StormField.h"

#include <cmath>
#include <vector>

namespace nexrad::testing
{

inline const Time start = *ParseIso8601("2006-03-12T18:03:12.500");

inline Site TestSite()
{
  return {"KLSX", FindSite("KLSX")->position};
}

/// A simulated volume, with what is true of each gate.
struct TruthfulScan
{
  ScanTruth truth;
  RadarVolume volume;
};

/// The storms as KLSX sees them in a scan of the pattern; 32 has the fewest cuts.
inline TruthfulScan Scan(const SimulatorOptions& options, int pattern = 32, Time time = start)
{
  TruthfulScan scan;
  scan.volume = ScanVolume(StormField(), TestSite(), pattern, time, options, &scan.truth);
  return scan;
}

/// The storms alone, scanned once for all tests of a program.
inline const TruthfulScan& PlainScan()
{
  static const TruthfulScan scan = Scan({});
  return scan;
}

/// The radial velocity in m/s, positive away from the radar, that one gate's beam meets at a time,
/// weighted with Z, without noise and folding: what RayTruth::velocity has. The mean wind's and the
/// storms' parts where the beam meets no echo, too. `azimuth` and `elevation` in degrees, `range`
/// and `gateSpacing` in m, above 0.
inline double TrueRadialVelocity(const StormField& field, const Position& site, Time time,
  double azimuth, double elevation, double range, double gateSpacing)
{
  const auto first = static_cast<int>(std::lround(range));
  const auto spacing = static_cast<int>(std::lround(gateSpacing));
  BeamSampler beam(site, elevation, range + 2.0 * gateSpacing, {});
  const StormSnapshot snapshot = field.At(time);
  std::vector<double> reflectivity;
  beam.Point(azimuth, elevation);
  beam.Sample(snapshot, {1, first, spacing}, reflectivity);
  return VelocitySampler(beam.Trace(), snapshot).Sample(range, beam.Spreads()[0]).mean;
}

} // namespace nexrad::testing
