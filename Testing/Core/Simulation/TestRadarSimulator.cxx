// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "ScannedStorm.h"
#include "Tolerance.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/BeamSampler.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/ScanStrategy.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

bool SameWords(const RadarVolume& first, const RadarVolume& second)
{
  return first.buffers.size() == second.buffers.size() &&
         std::equal(first.buffers.begin(), first.buffers.end(), second.buffers.begin(),
           [](const auto& one, const auto& other) { return *one == *other; });
}

std::string ScanError(const Site& site, int pattern, const SimulatorOptions& options = {})
{
  return MessageOf([&] { ScanVolume(StormField(), site, pattern, start, options); });
}

} // namespace

TEST(RadarSimulator, IsDeterministic)
{
  SimulatorOptions otherSeed;
  otherSeed.seed = 2;
  EXPECT_TRUE(SameWords(PlainScan().volume, ScanVolume(StormField(), TestSite(), 32, start)));
  EXPECT_FALSE(
    SameWords(PlainScan().volume, ScanVolume(StormField(), TestSite(), 32, start, otherSeed)));
}

TEST(RadarSimulator, MarksTheVolumeAndItsRays)
{
  const RadarVolume& volume = PlainScan().volume;
  EXPECT_TRUE(volume.synthetic);
  EXPECT_TRUE(volume.complete);
  EXPECT_EQ(volume.coveragePatternNumber, 32);
  ASSERT_EQ(volume.sweeps.size(), 7U);
  EXPECT_EQ(volume.sweeps.front().rays.front().radialStatus, 3);
  EXPECT_EQ(volume.sweeps.back().rays.back().radialStatus, 4);
  Time before = start;
  for (std::size_t cut = 0; cut < volume.sweeps.size(); ++cut)
  {
    const Sweep& sweep = volume.sweeps[cut];
    EXPECT_WITHIN(sweep.MeanElevation(), volume.coveragePattern->cuts[cut].elevation, 0.009,
      "mean elevation of a cut, degrees");
    for (const Ray& ray : sweep.rays)
    {
      EXPECT_GT(ray.time, before);
      EXPECT_EQ(ray.elevationNumber, cut + 1);
      EXPECT_GE(ray.azimuth, 0.0F);
      EXPECT_LT(ray.azimuth, 360.0F);
      before = ray.time;
    }
  }
  EXPECT_LT(before, start + VolumePeriod(32));
}

TEST(RadarSimulator, SplitCutsShareTheMomentsAsMessage1Does)
{
  const RadarVolume& volume = PlainScan().volume;
  EXPECT_TRUE(volume.sweeps[0].Has(MomentName::REF));
  EXPECT_FALSE(volume.sweeps[0].Has(MomentName::VEL));
  EXPECT_FALSE(volume.sweeps[1].Has(MomentName::REF));
  EXPECT_TRUE(volume.sweeps[1].Has(MomentName::VEL));
  EXPECT_TRUE(volume.sweeps[1].Has(MomentName::SW));
  EXPECT_TRUE(volume.sweeps[4].Has(MomentName::REF));
  EXPECT_TRUE(volume.sweeps[4].Has(MomentName::VEL));
}

// The words are the mean over the beam at the ray's own time, with 1 dB of noise.
TEST(RadarSimulator, GatesAreTheFieldWithNoise)
{
  const StormField field;
  const RadarVolume& volume = PlainScan().volume;
  const std::vector<ScanCut>& cuts = *FindScanStrategy(32);
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (const std::size_t cut : {0U, 2U, 4U, 6U})
  {
    const CutLayout layout = LayOut(cuts[cut], false);
    BeamSampler beam(*TestSite().position, cuts[cut].cut.elevation, 461'000.0, {});
    std::vector<double> truth;
    for (std::size_t index = 0; index < volume.sweeps[cut].rays.size(); index += 7)
    {
      const Ray& ray = volume.sweeps[cut].rays[index];
      const MomentRow& row = ray.Row(MomentName::REF);
      beam.Point(ray.azimuth, ray.elevation);
      beam.Sample(field.At(ray.time), layout.reflectivity, truth);
      for (int gate = 1; gate < row.gates; ++gate)
      {
        const auto place = static_cast<std::size_t>(gate);
        const double limit = SensitivityAt(layout.reflectivity.Range(gate), {});
        if (row.State(place) == GateState::Valid && truth[place] > limit + 4.0)
        {
          const double error = row.Value(place) - truth[place];
          EXPECT_AT_MOST(std::abs(error), 3.75,
            "largest noise of a gate, dB"); // the noise has bounds, the word half a quantum
          sum += error;
          squares += error * error;
          ++count;
        }
        EXPECT_TRUE(row.State(place) == GateState::Valid || truth[place] < limit + 3.5);
      }
    }
  }
  ASSERT_AT_LEAST(count, 8'000, "gates compared");
  const double mean = sum / count;
  EXPECT_WITHIN(mean, 0.0, 0.015, "mean of the noise, dB");
  EXPECT_WITHIN(std::sqrt(squares / count - mean * mean), 1.01, 0.0045,
    "standard deviation of the noise, dB"); // with the quantum's 0.14
}

TEST(RadarSimulator, NothingIsWeakerThanTheSensitivity)
{
  EXPECT_NEAR(SensitivityAt(50'000.0, {}), -7.5, 1e-9);
  EXPECT_NEAR(SensitivityAt(100'000.0, {}), -7.5 + 6.02, 0.01);
  std::size_t valid = 0;
  for (const Ray& ray : PlainScan().volume.sweeps[0].rays)
  {
    const MomentRow& row = ray.Row(MomentName::REF);
    for (std::size_t gate = 1; gate < row.gates; ++gate)
    {
      if (row.State(gate) == GateState::Valid)
      {
        ++valid;
        const double range = row.firstGate + 1000.0 * static_cast<double>(gate);
        EXPECT_GE(row.Value(gate), SensitivityAt(range, {}) - 0.25);
      }
    }
  }
  EXPECT_AT_LEAST(valid, 25'000U, "gates with echo");
}

// Beside the edge of an echo 2 % of the gates had a width of -63.5 m/s and a velocity of no echo:
// their power was interpolated from a gate without echo.
TEST(RadarSimulator, NoWordStandsForWhatCannotBe)
{
  const StormField field;
  std::size_t valid = 0;
  for (int minute = 0; minute < 60; minute += 20)
  {
    const Time time = *ParseIso8601("2006-03-12T18:00:00") + std::chrono::minutes(minute);
    for (const Sweep& sweep : ScanVolume(field, TestSite(), 21, time).sweeps)
    {
      for (const Ray& ray : sweep.rays)
      {
        const MomentRow& velocity = ray.Row(MomentName::VEL);
        const MomentRow& width = ray.Row(MomentName::SW);
        for (std::size_t gate = 0; gate < width.gates; ++gate)
        {
          ASSERT_EQ(velocity.State(gate), width.State(gate));
          if (width.State(gate) == GateState::Valid)
          {
            ++valid;
            ASSERT_GE(width.Value(gate), 0.0F);
            ASSERT_LT(width.Value(gate), 15.0F);
            ASSERT_LE(std::abs(velocity.Value(gate)), ray.nyquist + 0.5F);
          }
        }
      }
    }
  }
  EXPECT_AT_LEAST(valid, 1'000'000U, "gates with echo");
}

// Velocities beside gates without echo are those of the wind, and stand where the beam meets echo.
TEST(RadarSimulator, VelocitiesAtTheEdgesOfEchoAreRight)
{
  const StormField field;
  const ScanCut& cut = (*FindScanStrategy(32))[1];
  const CutLayout layout = LayOut(cut, false);
  BeamSampler beam(*TestSite().position, cut.cut.elevation, 461'000.0, {});
  std::vector<double> reflectivity;
  std::size_t edges = 0;
  for (const Ray& ray : PlainScan().volume.sweeps[1].rays)
  {
    const MomentRow& row = ray.Row(MomentName::VEL);
    const StormSnapshot snapshot = field.At(ray.time);
    beam.Point(ray.azimuth, ray.elevation);
    beam.Sample(snapshot, layout.echo, reflectivity);
    VelocitySampler wind(beam.Trace(), snapshot);
    for (std::size_t gate = 1; gate + 1 < row.gates; ++gate)
    {
      const bool isEdge = row.State(gate - 1) == GateState::BelowThreshold ||
                          row.State(gate + 1) == GateState::BelowThreshold;
      if (row.State(gate) != GateState::Valid || !isEdge)
      {
        continue;
      }
      ++edges;
      const double range = row.firstGate + double(row.gateSpacing) * static_cast<double>(gate);
      const auto nearest = static_cast<std::size_t>(
        std::floor((range - layout.echo.firstGate) / layout.echo.gateSpacing + 0.5));
      ASSERT_TRUE(std::isfinite(reflectivity[nearest])) << range;
      const double radial = wind.Sample(range, beam.Spreads()[nearest]).mean;
      // The noise has bounds of 3.5 standard deviations of 1.2 m/s.
      EXPECT_AT_MOST(std::abs(std::remainder(row.Value(gate) - radial, 2.0 * ray.nyquist)), 4.5,
        "largest noise of velocities at edges, m/s");
    }
  }
  EXPECT_AT_LEAST(edges, 800U, "gates at edges");
}

TEST(RadarSimulator, EchoesOfTwoPulsesAreRangeFolded)
{
  std::size_t folded = 0;
  for (const Ray& ray : PlainScan().volume.sweeps[1].rays)
  {
    const MomentRow& velocity = ray.Row(MomentName::VEL);
    const MomentRow& width = ray.Row(MomentName::SW);
    for (std::size_t gate = 0; gate < velocity.gates; ++gate)
    {
      EXPECT_EQ(velocity.State(gate), width.State(gate));
      folded += velocity.State(gate) == GateState::RangeFolded ? 1 : 0;
    }
  }
  EXPECT_AT_LEAST(folded, 25'000U, "range-folded gates");
}

TEST(RadarSimulator, WeakerRefractionMovesWhatIsSeen)
{
  SimulatorOptions quiet;
  quiet.noise = 0.0;
  SimulatorOptions weaker = quiet;
  weaker.effectiveRadiusFactor = 1.0;
  const RadarVolume standard = ScanVolume(StormField(), TestSite(), 32, start, quiet);
  const RadarVolume higher = ScanVolume(StormField(), TestSite(), 32, start, weaker);
  // Near the radar both beams are together, far away they are a kilometre and more apart.
  std::size_t nearDifferences = 0;
  std::size_t farDifferences = 0;
  for (std::size_t index = 0; index < standard.sweeps[0].rays.size(); ++index)
  {
    const MomentRow& first = standard.sweeps[0].rays[index].Row(MomentName::REF);
    const MomentRow& second = higher.sweeps[0].rays[index].Row(MomentName::REF);
    for (std::size_t gate = 0; gate < first.gates; ++gate)
    {
      const int difference = static_cast<int>(first.Raw(gate)) - static_cast<int>(second.Raw(gate));
      (gate < 20 ? nearDifferences : farDifferences) += std::abs(difference) > 2 ? 1 : 0;
    }
  }
  EXPECT_EQ(nearDifferences, 0U);
  EXPECT_AT_LEAST(farDifferences, 5'000U, "gates far from the radar that differ");
}

TEST(RadarSimulator, SaysWhatItCannotScan)
{
  EXPECT_NE(ScanError(TestSite(), 99).find("known are 11, 12, 21"), std::string::npos);
  EXPECT_NE(ScanError({"KXXX", {}}, 21).find("KXXX"), std::string::npos);
  SimulatorOptions options;
  options.beamWidth = 0.0;
  EXPECT_NE(ScanError(TestSite(), 21, options).find("beam width"), std::string::npos);
}
