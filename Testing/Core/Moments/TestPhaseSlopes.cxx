// SPDX-License-Identifier: BSD-3-Clause
// K_DP of a SYNTHETIC volume whose rain has a known one (SpecificPhaseOfRain).
#include "nexrad/Moments/MomentMaker.h"

#include "SweepMaker.h"
#include "Tolerance.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Moments/PhaseSlopes.h"
#include "nexrad/Simulation/DualPolarisation.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nexrad
{
namespace
{

using testing::NumbersOf;
using testing::NumberSweep;

RadarVolume Simulate()
{
  SimulatorOptions options;
  options.superResolution = true;
  options.dualPolarisation = true;
  return ScanVolume(StormField(), {"KLSX", FindSite("KLSX")->position}, 212,
    *ParseIso8601("2006-03-12T18:30Z"), options);
}

// Errors of K_DP of a sweep, and how many gates are farther off than 2 degrees/km.
struct PhaseScore
{
  std::size_t gates = 0;
  std::size_t spikes = 0;
  double squares = 0.0;
  double sum = 0.0;

  double Rmse() const { return std::sqrt(squares / static_cast<double>(gates)); }
  double Bias() const { return sum / static_cast<double>(gates); }
  double SpikeShare() const { return 100.0 * static_cast<double>(spikes) / double(gates); }
};

// The truth of a gate is the mean over the window of 25 gates that K_DP is fitted to.
double TruthAt(const NumberSweep& reflectivity, std::size_t ray, std::size_t gate)
{
  double sum = 0.0;
  int count = 0;
  const std::size_t end = std::min(gate + 13, reflectivity.gates);
  for (std::size_t place = gate < 12 ? 0 : gate - 12; place < end; ++place)
  {
    const std::size_t index = reflectivity.Index(ray, place);
    const bool valid = reflectivity.states[index] == GateState::Valid;
    sum += valid ? SpecificPhaseOfRain(static_cast<double>(reflectivity.values[index])) : 0.0;
    ++count;
  }
  return sum / count;
}

// Whether K_DP is at an end of its stretch: fewer than 12 gates from one without a value.
bool IsAtEnd(const NumberSweep& slopes, std::size_t ray, std::size_t gate)
{
  const std::size_t end = std::min(gate + 13, slopes.gates);
  for (std::size_t place = gate < 12 ? 0 : gate - 12; place < end; ++place)
  {
    if (slopes.states[slopes.Index(ray, place)] != GateState::Valid)
    {
      return true;
    }
  }
  return false;
}

PhaseScore ScoreOf(const NumberSweep& slopes, const NumberSweep& reflectivity, bool ends)
{
  PhaseScore score;
  for (std::size_t ray = 0; ray < slopes.rays.size(); ++ray)
  {
    for (std::size_t gate = 0; gate < slopes.gates; ++gate)
    {
      const std::size_t index = slopes.Index(ray, gate);
      if (slopes.states[index] == GateState::Valid && IsAtEnd(slopes, ray, gate) == ends)
      {
        const double error =
          static_cast<double>(slopes.values[index]) - TruthAt(reflectivity, ray, gate);
        ++score.gates;
        score.sum += error;
        score.squares += error * error;
        score.spikes += std::abs(error) > 2.0 ? 1 : 0;
      }
    }
  }
  return score;
}

} // namespace

// The lowest tilt, which is below the melting level out to 160 km.
TEST(PhaseSlopes, AreThoseOfTheRain)
{
  const RadarVolume volume = Simulate();
  const PolarVolume made = MomentMaker(volume, {}).Make(MomentName::KDP);
  EXPECT_EQ(made.moment, MomentName::KDP);
  const NumberSweep slopes = NumbersOf(made.sweeps[0]);
  const NumberSweep reflectivity = NumbersOf(MakePolarVolume(volume, MomentName::REF).sweeps[0]);
  ASSERT_EQ(slopes.rays.size(), reflectivity.rays.size());
  const PhaseScore within = ScoreOf(slopes, reflectivity, false);
  const PhaseScore ends = ScoreOf(slopes, reflectivity, true);
  EXPECT_GT(within.gates, 1'000U);
  EXPECT_GT(ends.gates, 1'000U);
  EXPECT_AT_MOST(within.Rmse(), 0.3, "K_DP within stretches, RMSE in degrees/km");
  EXPECT_AT_MOST(ends.Rmse(), 0.3, "K_DP at ends of stretches, RMSE in degrees/km");
  EXPECT_AT_MOST(within.SpikeShare(), 0.3, "K_DP within stretches off by 2 degrees/km, %");
  EXPECT_AT_MOST(ends.SpikeShare(), 0.0, "K_DP at ends of stretches off by 2 degrees/km, %");
  EXPECT_AT_MOST(std::abs(within.Bias()), 0.04, "K_DP within stretches, bias in degrees/km");
  EXPECT_AT_MOST(std::abs(ends.Bias()), 0.004, "K_DP at ends of stretches, bias in degrees/km");
}

TEST(PhaseSlopes, LeaveOutPhasesOfLowCorrelation)
{
  NumberSweep phase = testing::MakeSweep(1, 0.5, 4, 100, 250.0);
  testing::SetAll(phase, 60.0F);
  NumberSweep correlation = phase;
  testing::SetAll(correlation, 0.98F);
  for (std::size_t gate = 50; gate < 100; ++gate)
  {
    testing::SetGate(correlation, 1, gate, 0.6F);
  }
  const Position site = {38.7, -90.7, 200.0};
  const PolarVolume made = MakePhaseSlopes(
    testing::MakeVolume(site, 0.0, {phase}), {}, testing::MakeVolume(site, 0.0, {correlation}));
  const NumberSweep slopes = NumbersOf(made.sweeps[0]);
  EXPECT_EQ(slopes.states[slopes.Index(1, 49)], GateState::Valid);
  EXPECT_NEAR(slopes.values[slopes.Index(1, 49)], 0.0F, 1e-4F);
  EXPECT_EQ(slopes.states[slopes.Index(1, 60)], GateState::NotSampled);
  EXPECT_EQ(slopes.states[slopes.Index(0, 60)], GateState::Valid);
}

} // namespace nexrad
