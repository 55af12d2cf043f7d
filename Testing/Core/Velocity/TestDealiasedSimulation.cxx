// SPDX-License-Identifier: BSD-3-Clause
// Formulas V4 against the SYNTHETIC storm day: mean wind, mesocyclones, convergence and divergence,
// scanned by patterns of a low and of a high Nyquist velocity.
#include "FoldScore.h"
#include "Scans/SimulatedVelocities.h"
#include "Tolerance.h"
#include "nexrad/System/RangeLoop.h"
#include "nexrad/Velocity/Dealiasing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// The largest difference between two gates within 8 km of each other across the azimuth at one
// range: the peak difference of the strongest vortex of a sweep, m/s, and where it is.
struct PeakDifference
{
  double difference = 0.0;
  std::size_t ray = 0;
  std::size_t other = 0;
  std::size_t gate = 0;
};

PeakDifference FindVortex(const VelocitySweep& sweep)
{
  constexpr double widest = 8'000.0; // m
  constexpr std::size_t nearestGate = 80;
  PeakDifference peak;
  for (std::size_t gate = nearestGate; gate < sweep.gates; ++gate)
  {
    const double step = sweep.RangeOf(gate) * 2.0 * 3.14159 / double(sweep.rays.size());
    const auto reach = std::size_t(widest / step);
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      for (std::size_t away = 1; away <= reach; ++away)
      {
        const std::size_t other = (ray + away) % sweep.rays.size();
        const auto difference = static_cast<double>(
          sweep.values[sweep.Index(other, gate)] - sweep.values[sweep.Index(ray, gate)]);
        if (difference > peak.difference)
        {
          peak = {difference, ray, other, gate};
        }
      }
    }
  }
  return peak;
}

} // namespace

struct SimulatedCase
{
  const char* site;
  int pattern;
  bool superResolution;
  double right;   // at least, % of the folds that are known
  double unknown; // at most, %
};

// In the names of the tests.
void PrintTo(const SimulatedCase& each, std::ostream* stream)
{
  *stream << each.site << each.pattern << (each.superResolution ? "SuperResolution" : "");
}

class SimulatedDealiasing : public ::testing::TestWithParam<SimulatedCase>
{
};

TEST_P(SimulatedDealiasing, FindsTheTrueFolds)
{
  const SimulatedCase& each = GetParam();
  SimulatedVelocities volume = SimulateVelocities(each.site, each.pattern, each.superResolution);
  DealiasOptions options;
  options.loop = ThreadLoop(CoreCount());
  Dealias(volume.folded, options);
  const FoldScore score = CompareFolds(volume.truth, volume.folded);
  const std::string name = std::string(each.site) + ", pattern " + std::to_string(each.pattern) +
                           (each.superResolution ? ", super-resolution" : "");
  EXPECT_AT_LEAST(score.RightShare(), each.right, name + ": right folds of those known, %");
  EXPECT_AT_MOST(score.UnknownShare(), each.unknown, name + ": gates without a fold, %");
  EXPECT_AT_MOST(
    score.largestPatch, 99u, name + ": largest patch of wrong folds, gates", "the bound asked for");
  for (std::size_t sweep = 0; sweep < volume.truth.sweeps.size(); ++sweep)
  {
    const VelocitySweep& found = volume.folded.sweeps[sweep];
    const PeakDifference peak = FindVortex(volume.truth.sweeps[sweep]);
    if (peak.difference == 0.0)
    {
      continue; // no gate so far out
    }
    const auto difference = static_cast<double>(found.values[found.Index(peak.other, peak.gate)] -
                                                found.values[found.Index(peak.ray, peak.gate)]);
    EXPECT_NEAR(difference, peak.difference, 2.0) << "sweep " << sweep;
  }
}

INSTANTIATE_TEST_SUITE_P(Patterns, SimulatedDealiasing,
  ::testing::Values(SimulatedCase{"KLSX", 31, false, 99.91, 0.05},
    SimulatedCase{"KLSX", 31, true, 99.98, 0.04}, SimulatedCase{"KLSX", 212, true, 99.99, 0.003},
    SimulatedCase{"KEAX", 21, false, 99.99, 0.003},
    SimulatedCase{"KILX", 12, false, 99.99, 0.003}));
