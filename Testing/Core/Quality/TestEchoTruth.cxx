// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q1 to Q3 on simulated volumes with all kinds of echo that is not weather, against what
// is true of each gate.
#include "Tolerance.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/Quality/SweepJudgement.h"
#include "nexrad/Simulation/Echo/AddedEcho.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <gtest/gtest.h>

#include <map>

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
  double Percent() const { return 100.0 * static_cast<double>(gone) / static_cast<double>(all); }
};

struct Score
{
  Share ground;     // clutter and anomalous propagation, lower beam edge below 5 km
  Share highGround; // above: side lobes that are 45 dB down at all angles
  Share spikes;     // sun, interference, test patterns
  Share speckle;
  Share weather;
  Share cores; // weather from 45 dBZ on
};

void AddGate(EchoKind kind, double value, bool low, bool gone, Score& score)
{
  switch (kind)
  {
  case EchoKind::Clutter:
  case EchoKind::AnomalousPropagation:
    (low ? score.ground : score.highGround).Add(gone);
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

// Adds the gates of one volume to a score.
void AddVolume(const SimulatorOptions& given, int pattern, Score& score)
{
  SimulatorOptions options = given;
  options.notWeather = AddableEchoKinds();
  ScanTruth truth;
  const RadarVolume volume = ScanVolume(StormField(), {"KLSX", FindSite("KLSX")->position}, pattern,
    *ParseIso8601("2006-03-12T18:03:12.500"), options, &truth);
  const EchoClassification found = ClassifyEcho(volume);
  std::size_t number = 0;
  for (std::size_t cut = 0; cut < volume.sweeps.size(); ++cut)
  {
    const Sweep& sweep = volume.sweeps[cut];
    if (!sweep.Has(MomentName::REF))
    {
      continue;
    }
    const std::vector<EchoReason>& reasons = found.sweeps[number++];
    const std::size_t gates = reasons.size() / sweep.rays.size();
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      const MomentRow& row = sweep.rays[ray].Row(MomentName::REF);
      const std::vector<EchoKind>& kinds = truth.sweeps[cut][ray].reflectivityKinds;
      for (std::size_t gate = 0; gate < kinds.size(); ++gate)
      {
        const double range = row.firstGate + double(row.gateSpacing) * static_cast<double>(gate);
        const bool low =
          range < 20'000.0 || BeamHeight(range, sweep.MedianElevation() - 0.5) < 5'000.0;
        const EchoClass echoClass = ClassOf(reasons[ray * gates + gate]);
        AddGate(kinds[gate], row.Value(gate), low, RemovesClass(QualityLevel::Standard, echoClass),
          score);
      }
    }
  }
}

} // namespace

TEST(EchoTruth, OfOnePolarisation)
{
  Score score;
  for (const int pattern : {32, 21})
  {
    AddVolume({}, pattern, score);
  }
  EXPECT_AT_LEAST(score.ground.Percent(), 95.0, "ground gone below 5 km, message 1, %");
  EXPECT_AT_LEAST(score.spikes.Percent(), 98.0, "spikes and faults gone, message 1, %");
  EXPECT_AT_LEAST(score.speckle.Percent(), 76.0, "speckle gone, message 1, %");
  EXPECT_AT_MOST(score.weather.Percent(), 0.5, "weather lost, message 1, %");
  EXPECT_AT_MOST(score.cores.Percent(), 0.1, "weather from 45 dBZ on lost, message 1, %");
  ASSERT_GT(score.cores.all, 1'000U);
}

TEST(EchoTruth, OfTwoPolarisations)
{
  SimulatorOptions options;
  options.superResolution = true;
  options.dualPolarisation = true;
  Score score;
  AddVolume(options, 212, score);
  EXPECT_AT_LEAST(score.ground.Percent(), 95.0, "ground gone below 5 km, dual polarisation, %");
  EXPECT_AT_LEAST(score.spikes.Percent(), 98.5, "spikes and faults gone, dual polarisation, %");
  EXPECT_AT_LEAST(score.speckle.Percent(), 74.0, "speckle gone, dual polarisation, %");
  EXPECT_AT_MOST(score.weather.Percent(), 0.4, "weather lost, dual polarisation, %");
  EXPECT_AT_MOST(score.cores.Percent(), 0.1, "weather from 45 dBZ on lost, dual polarisation, %");
  ASSERT_GT(score.cores.all, 5'000U);
}
