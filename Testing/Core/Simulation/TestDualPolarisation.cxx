// SPDX-License-Identifier: BSD-3-Clause
// Differential reflectivity, differential phase and correlation of simulated gates.
#include "ScannedStorm.h"
#include "Tolerance.h"
#include "nexrad/Level2/Encoding/Level2Encoder.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/DualPolarisation.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

SimulatorOptions Options()
{
  SimulatorOptions options;
  options.superResolution = true;
  options.dualPolarisation = true;
  options.notWeather = {EchoKind::Clutter, EchoKind::Biological};
  return options;
}

const TruthfulScan& DualScan()
{
  static const TruthfulScan scan = Scan(Options());
  return scan;
}

// A beam at the ground of a plane site, pointed up by so much.
BeamTrace Beam(double elevation)
{
  BeamTrace beam({39.0, -91.5, 100.0}, elevation, 100'000.0, {});
  beam.Point(0.0, elevation);
  return beam;
}

// One ray of weather, all of one reflectivity.
std::vector<PolarimetricGate> Uniform(double reflectivity, double elevation, int gates)
{
  const auto count = static_cast<std::size_t>(gates);
  return MeasurePolarisation(Beam(elevation), {gates, 2'125, 250},
    std::vector<double>(count, reflectivity), std::vector<EchoKind>(count, EchoKind::Weather), 5);
}

double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

struct Samples
{
  std::vector<double> differential;
  std::vector<double> correlation;
};
std::map<EchoKind, Samples> SamplesOfKinds()
{
  const TruthfulScan& scan = DualScan();
  std::map<EchoKind, Samples> samples;
  for (std::size_t cut = 0; cut < scan.volume.sweeps.size(); ++cut)
  {
    const Sweep& sweep = scan.volume.sweeps[cut];
    for (std::size_t index = 0; index < sweep.rays.size(); ++index)
    {
      const MomentRow& differential = sweep.rays[index].Row(MomentName::ZDR);
      const MomentRow& correlation = sweep.rays[index].Row(MomentName::RHO);
      for (std::size_t gate = 0; gate < differential.gates; ++gate)
      {
        if (differential.State(gate) == GateState::Valid)
        {
          Samples& kind = samples[scan.truth.sweeps[cut][index].reflectivityKinds[gate]];
          kind.differential.push_back(differential.Value(gate));
          kind.correlation.push_back(correlation.Value(gate));
        }
      }
    }
  }
  return samples;
}

} // namespace

// Values computed by hand from the formulas.
TEST(DualPolarisation, RainHasItsPhaseAndItsDifferentialReflectivity)
{
  // Z = 300·R^1.4: 40 dBZ is 12.24 mm/h, 50 dBZ 63.40; K = (R/44)^(1/0.822).
  EXPECT_NEAR(SpecificPhaseOfRain(40.0), 0.2109, 0.0005);
  EXPECT_NEAR(SpecificPhaseOfRain(50.0), 1.559, 0.002);
  EXPECT_EQ(SpecificPhaseOfRain(60.0), SpecificPhaseOfRain(53.0));
  // f1 = −0.5 + 0.0025·30 + 0.00075·900 = 0.25; f2 = 0.68 − 0.0481·30 + 0.00292·900 = 1.865.
  EXPECT_NEAR(DifferentialReflectivityOfRain(30.0), 1.0575, 1e-9);
  EXPECT_EQ(DifferentialReflectivityOfRain(60.0), 3.5);
  EXPECT_EQ(DifferentialReflectivityOfRain(-5.0), DifferentialReflectivityOfRain(0.0));
}

TEST(DualPolarisation, PhaseGrowsAlongRainByTwiceItsSpecificPhase)
{
  const int gates = 160; // 40 km at 0.5 degrees: below the melting level
  const std::vector<PolarimetricGate> rain = Uniform(45.0, 0.5, gates);
  double before = 0.0;
  for (std::size_t first = 0; first + 20 <= rain.size(); first += 20)
  {
    std::vector<double> phases;
    for (std::size_t gate = first; gate < first + 20; ++gate)
    {
      phases.push_back(rain[gate].phase);
    }
    const double here = Median(phases);
    EXPECT_GT(here, before);
    before = here;
  }
  const double growth = 2.0 * SpecificPhaseOfRain(45.0) * 0.25 * gates;
  EXPECT_WITHIN((rain.back().phase - SystemPhase) / growth, 1.0, 0.11,
    "growth of the phase, part of the integral's");
}

TEST(DualPolarisation, LayersDifferInCorrelation)
{
  std::vector<double> rain;
  std::vector<double> melting;
  std::vector<double> ice;
  // 2.8 km above the antenna at 10 degrees is 16.1 km away.
  const std::vector<PolarimetricGate> gates = Uniform(30.0, 10.0, 200);
  for (std::size_t gate = 0; gate < gates.size(); ++gate)
  {
    const double height = (2'125.0 + 250.0 * static_cast<double>(gate)) * 0.17365 + 100.0;
    (std::abs(height - MeltingLevel) < 150.0 ? melting
      : height < 2'000.0                     ? rain
                                             : ice)
      .push_back(gates[gate].correlation);
  }
  EXPECT_WITHIN(Median(rain), 0.992, 0.0024, "correlation of rain");
  EXPECT_WITHIN(Median(melting), 0.92, 0.0075, "correlation of the melting layer");
  EXPECT_WITHIN(Median(ice), 0.985, 0.0003, "correlation of ice");
}

TEST(DualPolarisation, HailIsRoundAndLessAlike)
{
  const std::vector<PolarimetricGate> hail = Uniform(58.0, 0.5, 100);
  std::vector<double> differential;
  std::vector<double> correlation;
  for (const PolarimetricGate& gate : hail)
  {
    differential.push_back(gate.differentialReflectivity);
    correlation.push_back(gate.correlation);
    EXPECT_LE(gate.correlation, 1.0);
    EXPECT_GE(gate.phase, 0.0);
    EXPECT_LT(gate.phase, 360.0);
  }
  EXPECT_WITHIN(Median(differential), 0.3, 0.013, "differential reflectivity of hail, dB");
  EXPECT_WITHIN(Median(correlation), 0.94, 0.002, "correlation of hail");
}

TEST(DualPolarisation, KindsOfAScanDiffer)
{
  std::map<EchoKind, Samples> samples = SamplesOfKinds();
  ASSERT_AT_LEAST(samples[EchoKind::Weather].correlation.size(), 200'000U, "gates of weather");
  ASSERT_AT_LEAST(samples[EchoKind::Clutter].correlation.size(), 20'000U, "gates of clutter");
  ASSERT_AT_LEAST(samples[EchoKind::Biological].correlation.size(), 300'000U, "gates of insects");
  EXPECT_AT_LEAST(Median(samples[EchoKind::Weather].correlation), 0.97, "correlation of weather");
  EXPECT_WITHIN(
    Median(samples[EchoKind::Clutter].correlation), 0.65, 0.0033, "correlation of clutter");
  EXPECT_WITHIN(
    Median(samples[EchoKind::Biological].correlation), 0.55, 0.0033, "correlation of insects");
  EXPECT_NEAR(Median(samples[EchoKind::Biological].differential), 4.0, 0.07); // one word
}

TEST(DualPolarisation, AFileHasTheMomentsAsRealFilesDo)
{
  const RadarVolume& volume = DualScan().volume;
  const RadarVolume decoded =
    DecodeLevel2(EncodeLevel2(volume, {31, Level2Container::Bare, 1}), "KLSX20060312_180312_V06");
  EXPECT_TRUE(decoded.damage.empty());
  ASSERT_EQ(decoded.sweeps.size(), volume.sweeps.size());
  for (std::size_t cut = 0; cut < volume.sweeps.size(); ++cut)
  {
    const bool isDopplerHalf = cut == 1 || cut == 3;
    EXPECT_EQ(decoded.sweeps[cut].Has(MomentName::ZDR), !isDopplerHalf) << cut;
    for (std::size_t index = 0; index < volume.sweeps[cut].rays.size(); ++index)
    {
      for (const MomentName name :
        {MomentName::REF, MomentName::VEL, MomentName::ZDR, MomentName::PHI, MomentName::RHO})
      {
        const MomentRow& truth = volume.sweeps[cut].rays[index].Row(name);
        const MomentRow& row = decoded.sweeps[cut].rays[index].Row(name);
        ASSERT_EQ(row.gates, truth.gates);
        ASSERT_TRUE(std::equal(row.words, row.words + row.gates * (row.wordBits / 8), truth.words));
      }
    }
  }
  for (const Ray& each : decoded.sweeps.front().rays)
  {
    const MomentRow& phase = each.Row(MomentName::PHI);
    for (std::size_t gate = 0; gate < phase.gates; ++gate)
    {
      ASSERT_LE(phase.Raw(gate), 1'022U); // 359.6 degrees, as in real files
    }
  }
  const Ray& ray = decoded.sweeps.front().rays.front();
  EXPECT_EQ(ray.Row(MomentName::ZDR).scale, 16.0F);
  EXPECT_EQ(ray.Row(MomentName::ZDR).offset, 128.0F);
  EXPECT_EQ(ray.Row(MomentName::PHI).wordBits, 16);
  EXPECT_EQ(ray.Row(MomentName::PHI).scale, 2.8361F);
  EXPECT_EQ(ray.Row(MomentName::PHI).offset, 2.0F);
  EXPECT_EQ(ray.Row(MomentName::RHO).scale, 300.0F);
  EXPECT_EQ(ray.Row(MomentName::RHO).offset, -60.5F);
  EXPECT_EQ(ray.Row(MomentName::ZDR).gates, 1'192);
}

TEST(DualPolarisation, LeavesTheOtherMomentsAsTheyAre)
{
  SimulatorOptions options = Options();
  options.dualPolarisation = false;
  const RadarVolume without =
    ScanVolume(StormField(), {"KLSX", FindSite("KLSX")->position}, 32, start, options);
  const RadarVolume& with = DualScan().volume;
  for (std::size_t cut = 0; cut < with.sweeps.size(); ++cut)
  {
    for (std::size_t index = 0; index < with.sweeps[cut].rays.size(); index += 17)
    {
      for (const MomentName name : {MomentName::REF, MomentName::VEL, MomentName::SW})
      {
        const MomentRow& row = with.sweeps[cut].rays[index].Row(name);
        const MomentRow& other = without.sweeps[cut].rays[index].Row(name);
        ASSERT_EQ(row.gates, other.gates);
        ASSERT_TRUE(std::equal(row.words, row.words + row.gates, other.words));
      }
    }
  }
}

TEST(DualPolarisation, NeedsMessage31)
{
  SimulatorOptions options = Options();
  options.superResolution = false;
  EXPECT_THROW(
    ScanVolume(StormField(), {"KLSX", FindSite("KLSX")->position}, 32, start, options), Error);
}
