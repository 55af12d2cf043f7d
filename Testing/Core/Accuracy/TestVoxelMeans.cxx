// SPDX-License-Identifier: BSD-3-Clause
// What the means over voxels coarser than gates are worth (Formulas G10), for radars of super
// resolution: on the synthetic storm, whose mean over each voxel is known, and on one real volume,
// against the mean of all gates in each cell.
#include "DirectMerge.h"
#include "ScannedDay.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Beams/SweepMeans.h"
#include "nexrad/Geometry/Angles.h"
#include "nexrad/Gridding/BeamMerge.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Merging/TimeMerge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

TruthScore ScoreOf(const ScannedDay& day, const Truth& truth, bool means)
{
  MergeRequest request;
  request.grid = truth.grid;
  request.time = day.At();
  request.loop = ThreadLoop(2);
  request.beam.means = means;
  const TruthScore score = CompareWithTruth(
    *nexrad::testing::MergeDirectly(day.Volumes(), request), truth.values, truth.counts);
  Print(means ? "means" : "gates", truth, score);
  return score;
}

// Mean and number of the gates with their centres in each square cell about the radar.
class CellMeans
{
public:
  using Cell = std::pair<long, long>;
  struct Sum
  {
    double values = 0.0;
    int gates = 0;

    double Mean() const { return values / gates; }
  };

  CellMeans(const BeamSweep& sweep, double theSide)
    : side(theSide)
  {
    const BeamModel beam;
    const double elevation = static_cast<double>(sweep.elevation);
    for (int gate = 0; gate < sweep.gates; ++gate)
    {
      const double range =
        static_cast<double>(sweep.firstGate) + gate / static_cast<double>(sweep.gatesPerMetre);
      const double ground = beam.Locate(range, elevation).groundDistance;
      for (std::size_t entry = 1; entry + 1 < sweep.azimuths.size(); ++entry)
      {
        const std::uint16_t code = sweep.CodeAt(entry, gate);
        if (code != GateCode::RangeFolded && code != GateCode::NotSampled)
        {
          const double angle = static_cast<double>(sweep.azimuths[entry]) * RadiansPerDegree;
          Sum& sum = sums[{std::lround(ground * std::sin(angle) / side),
            std::lround(ground * std::cos(angle) / side)}];
          ++sum.gates;
          sum.values += code == GateCode::NoEcho
                          ? 0.0
                          : std::max(0.0, static_cast<double>(sweep.scale.ValueOf(code)));
        }
      }
    }
  }

  const std::map<Cell, Sum>& Sums() const { return sums; }
  ColumnDirection Middle(const Cell& cell) const
  {
    const double x = side * static_cast<double>(cell.first);
    const double y = side * static_cast<double>(cell.second);
    const double angle = std::atan2(x, y) / RadiansPerDegree;
    const double halfway = 0.5 * std::hypot(x, y) / BeamModel().EffectiveRadius();
    return {static_cast<float>(angle < 0.0 ? angle + 360.0 : angle),
      static_cast<float>(std::tan(halfway))};
  }
  double Distance(const Cell& cell) const
  {
    return side * std::hypot(static_cast<double>(cell.first), static_cast<double>(cell.second));
  }

private:
  double side;
  std::map<Cell, Sum> sums;
};

struct Scatter
{
  double squares = 0.0;
  double sum = 0.0;
  int cells = 0;

  void Add(double error)
  {
    squares += error * error;
    sum += error;
    ++cells;
  }
  double Rms() const { return std::sqrt(squares / cells); }
  double Bias() const { return sum / cells; }
};

// How far the samples of a sweep at the cells' middles lie from the cells' means, from 20 to 100 km
// away, where the mean is of 5 dBZ or more and of at least eight gates.
Scatter ScatterOf(const BeamSweep& sweep, const CellMeans& cells)
{
  BeamTilt tilt;
  tilt.before.push_back({&sweep, nullptr, 0.0F, -100.0F});
  SamplingContext context;
  context.rule = ValueRule::Of(MomentName::REF, false);
  context.effectiveRadius = static_cast<float>(BeamModel().EffectiveRadius());
  Scatter scatter;
  for (const auto& [cell, sum] : cells.Sums())
  {
    const double distance = cells.Distance(cell);
    if (distance >= 20e3 && distance < 100e3 && sum.gates >= 8 && sum.Mean() >= 5.0)
    {
      TiltSample sample;
      SampleTilt({tilt}, 0, cells.Middle(cell), context, nullptr, false, sample);
      const double value =
        sample.state == VoxelState::Echo ? std::max(0.0, static_cast<double>(sample.value)) : 0.0;
      scatter.Add(value - sum.Mean());
    }
  }
  return scatter;
}

struct RealVolume
{
  const char* file;
  double side;    // m, of the cells
  double largest; // dB, root mean square difference to the cells' means
};

class VoxelMeansOf : public ::testing::TestWithParam<RealVolume>
{
};

} // namespace

TEST(VoxelMeans, OfTheSyntheticStormSeenBySuperResolutionRadars)
{
  SimulatorOptions options;
  options.superResolution = true;
  const ScannedDay day(Evening(), options);
  const Truth truth = TruthOn(day, {128, 128, 64});
  const TruthScore gates = ScoreOf(day, truth, false);
  const TruthScore means = ScoreOf(day, truth, true);
  EXPECT_AT_LEAST(gates.rmse - means.rmse, 0.12, "RMSE of four gates above that of the means, dBZ");
  EXPECT_LT(means.MissedFraction(), gates.MissedFraction());
}

// The lowest cut of a real volume: what is sampled must be the mean of the gates in the cell.
TEST_P(VoxelMeansOf, ARealSweepAreThoseOfItsGates)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto& [file, side, largest] = GetParam();
  const PolarVolume volume =
    MakePolarVolume(ReadLevel2(data / "level2" / "superres" / file), MomentName::REF);
  BeamSweep sweep = PrepareBeamVolume(volume).sweeps.front();
  const CellMeans cells(sweep, side);
  const Scatter gates = ScatterOf(sweep, cells);
  sweep.means = MakeSweepMeans(sweep, ValueRule::Of(MomentName::REF, false), side);
  const Scatter means = ScatterOf(sweep, cells);
  std::printf(
    "%s, %.2f degrees, cells of %.1f km: four gates %.2f dB (%+.2f), means %.2f dB (%+.2f), "
    "%d cells\n",
    file, static_cast<double>(sweep.elevation), side / 1e3, gates.Rms(), gates.Bias(), means.Rms(),
    means.Bias(), means.cells);
  EXPECT_AT_LEAST(means.cells, 500, "cells compared");
  EXPECT_AT_MOST(means.Rms(), largest, "RMS difference to the means of the cells, dB");
  EXPECT_AT_MOST(means.Rms() / gates.Rms(), 0.4,
    "RMS difference to the means of the cells, part of that of four gates");
  EXPECT_AT_MOST(std::abs(means.Bias()), 0.1, "bias to the means of the cells, dB");
}

INSTANTIATE_TEST_SUITE_P(Volumes, VoxelMeansOf,
  ::testing::Values(RealVolume{"KTLX20190715_120037_V06", 1'800.0, 0.8},
    RealVolume{"KTLX20190715_120037_V06", 3'600.0, 0.6},
    RealVolume{"KCRP20170826_044114.bin", 1'800.0, 0.7},
    RealVolume{"KDMX20220305_232324.bin", 1'800.0, 1.5}));
