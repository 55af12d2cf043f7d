// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q1 to Q3 on simulated volumes with all kinds of echo that is not weather, against what
// is true of each gate.
#include "Tolerance.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/Simulation/AddedEcho.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <iostream>
#include <vector>

using namespace nexrad;

namespace
{

struct Share
{
  std::size_t all = 0;
  std::size_t gone = 0;

  void Add(bool isGone)
  {
    ++all;
    gone += isGone ? 1 : 0;
  }
  void Add(const Share& other)
  {
    all += other.all;
    gone += other.gone;
  }
  double Percent() const { return 100.0 * static_cast<double>(gone) / static_cast<double>(all); }
};

struct Score
{
  Share ground; // clutter and anomalous propagation
  Share spikes; // sun, interference, test patterns
  Share speckle;
  Share weather;
  Share cores; // weather from 45 dBZ on

  void Add(const Score& other)
  {
    ground.Add(other.ground);
    spikes.Add(other.spikes);
    speckle.Add(other.speckle);
    weather.Add(other.weather);
    cores.Add(other.cores);
  }
};

void AddGate(EchoKind kind, double value, bool gone, Score& score)
{
  switch (kind)
  {
  case EchoKind::Clutter:
  case EchoKind::AnomalousPropagation:
    score.ground.Add(gone);
    break;
  case EchoKind::Sun:
  case EchoKind::Interference:
  case EchoKind::TestPattern:
    score.spikes.Add(gone);
    break;
  case EchoKind::Speckle:
    score.speckle.Add(gone);
    break;
  case EchoKind::Weather:
    score.weather.Add(gone);
    if (value >= 45.0)
    {
      score.cores.Add(gone);
    }
    break;
  default:
    break;
  }
}

struct Scan
{
  const char* site;
  const char* time;
  int pattern;
};

void Print(const Scan& scan, const Score& score)
{
  std::cout << "  " << scan.site << ' ' << scan.time << " pattern " << scan.pattern << ": gone "
            << score.ground.Percent() << " % of the ground, " << score.spikes.Percent()
            << " % of spikes, " << score.weather.Percent() << " % of the weather, "
            << score.cores.gone << " of " << score.cores.all << " from 45 dBZ on\n";
}

// Scores the gates of one volume.
Score ScoreOf(const Scan& scan, const SimulatorOptions& given)
{
  Score score;
  SimulatorOptions options = given;
  options.notWeather = AddableEchoKinds();
  ScanTruth truth;
  const RadarVolume volume = ScanVolume(StormField(), {scan.site, FindSite(scan.site)->position},
    scan.pattern, *ParseIso8601(scan.time), options, &truth);
  const EchoClassification found = ClassifyEcho(volume);
  std::size_t number = 0;
  for (std::size_t cut = 0; cut < volume.sweeps.size(); ++cut)
  {
    const Sweep& sweep = volume.sweeps[cut];
    if (!sweep.Has(MomentName::REF))
    {
      continue;
    }
    const SweepReasons& reasons = found.sweeps[number++];
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      const MomentRow& row = sweep.rays[ray].Row(MomentName::REF);
      const std::vector<EchoKind>& kinds = truth.sweeps[cut][ray].reflectivityKinds;
      for (std::size_t gate = 0; gate < kinds.size(); ++gate)
      {
        const EchoClass echoClass = ClassOf(reasons.At(ray, gate));
        AddGate(
          kinds[gate], row.Value(gate), RemovesClass(QualityLevel::Standard, echoClass), score);
      }
    }
  }
  Print(scan, score);
  return score;
}

Score ScoreOfAll(const std::vector<Scan>& scans, const SimulatorOptions& options)
{
  Score score;
  for (const Scan& scan : scans)
  {
    score.Add(ScoreOf(scan, options));
  }
  return score;
}

} // namespace

TEST(EchoTruth, OfOnePolarisationEarly)
{
  const Score score = ScoreOfAll(
    {{"KLSX", "2006-03-12T18:03:12.500", 32}, {"KLSX", "2006-03-12T18:03:12.500", 21}}, {});
  EXPECT_AT_LEAST(score.ground.Percent(), 95.0, "ground gone, message 1, early, %");
  EXPECT_AT_LEAST(score.spikes.Percent(), 98.0, "spikes and faults gone, message 1, early, %");
  EXPECT_AT_LEAST(score.speckle.Percent(), 76.0, "speckle gone, message 1, early, %");
  EXPECT_AT_MOST(score.weather.Percent(), 0.5, "weather lost, message 1, early, %");
  EXPECT_AT_MOST(score.cores.Percent(), 0.1, "weather from 45 dBZ on lost, message 1, early, %");
  ASSERT_GT(score.cores.all, 1'000U);
}

TEST(EchoTruth, OfOnePolarisation)
{
  const Score score =
    ScoreOfAll({{"KLSX", "2006-03-12T18:03:12.500", 32}, {"KLSX", "2006-03-12T20:10", 21},
                 {"KSGF", "2006-03-12T22:03", 11}},
      {});
  EXPECT_AT_LEAST(score.ground.Percent(), 95.0, "ground gone, message 1, %");
  EXPECT_AT_LEAST(score.spikes.Percent(), 99.0, "spikes and faults gone, message 1, %");
  EXPECT_AT_LEAST(score.speckle.Percent(), 80.0, "speckle gone, message 1, %");
  EXPECT_AT_MOST(score.weather.Percent(), 0.5, "weather lost, message 1, %");
  EXPECT_AT_MOST(score.cores.Percent(), 0.03, "weather from 45 dBZ on lost, message 1, %");
  ASSERT_GT(score.cores.all, 5'000U);
}

TEST(EchoTruth, OfTwoPolarisations)
{
  SimulatorOptions options;
  options.superResolution = true;
  options.dualPolarisation = true;
  const Score early = ScoreOf({"KLSX", "2006-03-12T18:03:12.500", 212}, options);
  EXPECT_AT_MOST(early.weather.Percent(), 0.4, "weather lost, dual polarisation, early, %");
  Score score = early;
  score.Add(ScoreOf({"KSGF", "2006-03-12T20:40", 215}, options));
  EXPECT_AT_LEAST(score.ground.Percent(), 95.0, "ground gone, dual polarisation, %");
  EXPECT_AT_LEAST(score.spikes.Percent(), 98.5, "spikes and faults gone, dual polarisation, %");
  EXPECT_AT_LEAST(score.speckle.Percent(), 80.0, "speckle gone, dual polarisation, %");
  EXPECT_AT_MOST(score.weather.Percent(), 0.5, "weather lost, dual polarisation, %");
  EXPECT_AT_MOST(score.cores.Percent(), 0.1, "weather from 45 dBZ on lost, dual polarisation, %");
  ASSERT_GT(score.cores.all, 10'000U);
}
