// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/StormField.h"

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

} // namespace nexrad::testing
