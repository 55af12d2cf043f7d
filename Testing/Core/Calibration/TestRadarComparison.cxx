// SPDX-License-Identifier: BSD-3-Clause
// Two radars of the SYNTHETIC storm day of which one is wrong: how wrong, and the seam between them
// (Formulas Q6).
#include "nexrad/Calibration/RadarBiases.h"

#include "PolarMerge.h"
#include "Tolerance.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Series/ScanInputs.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

const Time evening = *ParseIso8601("2006-03-12T18:00:00Z");

// An hour of a radar that measures so many dB too high. KILX and KLSX are 190 km apart.
std::vector<PolarVolume> Scan(const std::string& name, double bias)
{
  const StormField field(1);
  SimulatorOptions options;
  options.bias = bias;
  std::vector<PolarVolume> volumes;
  for (int i = 0; i < 6; ++i)
  {
    const Site site{name, FindSite(name)->position};
    volumes.push_back(
      MakePolarVolume(ScanVolume(field, site, 21, evening + i * 10min, options), MomentName::REF));
  }
  return volumes;
}

// The same, scanned once for all tests of the program.
const std::vector<PolarVolume>& Scanned(const std::string& name, double bias)
{
  static std::map<std::pair<std::string, double>, std::vector<PolarVolume>> known;
  const auto found = known.find({name, bias});
  return found != known.end() ? found->second : known[{name, bias}] = Scan(name, bias);
}

BiasReport Compare(const std::vector<const std::vector<PolarVolume>*>& radars)
{
  LowEchoes echoes;
  for (const std::vector<PolarVolume>* volumes : radars)
  {
    std::transform(volumes->begin(), volumes->end(), std::back_inserter(echoes),
      [](const PolarVolume& volume) { return std::make_shared<const LowEcho>(volume); });
  }
  return CompareRadars(echoes);
}

// Mean of the difference of neighbouring voxels, of which one is nearest to the second site of the
// volume and the other to the first, dB. Their mean is 10 dBZ or more: at the edge of an echo a
// value is interpolated with gates without one, which a bias does not change.
double StepAtSeam(const GriddedVolume& volume)
{
  double sum = 0.0;
  std::size_t pairs = 0;
  const auto [nx, ny, nz] = volume.grid.dimensions;
  const auto visit = [&](std::size_t a, std::size_t b)
  {
    const int towards = volume.ancillary.nearestSite[b] - volume.ancillary.nearestSite[a];
    if (volume.states[a] == VoxelState::Echo && volume.states[b] == VoxelState::Echo &&
        towards != 0 && volume.values[a] + volume.values[b] >= 20.0F)
    {
      sum += towards * static_cast<double>(volume.values[b] - volume.values[a]);
      ++pairs;
    }
  };
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const auto x = static_cast<int>(i % static_cast<std::size_t>(nx));
    const auto y =
      static_cast<int>(i / static_cast<std::size_t>(nx) % static_cast<std::size_t>(ny));
    if (x + 1 < nx)
    {
      visit(i, i + 1);
    }
    if (y + 1 < ny)
    {
      visit(i, i + static_cast<std::size_t>(nx));
    }
  }
  EXPECT_AT_LEAST(pairs, 1'200U, "pairs of voxels at the seam");
  return sum / static_cast<double>(pairs);
}

// The step when a part of the reflectivity of each radar is taken off, of the nearest radar alone.
double StepWith(
  const RadarBiases& biases, const std::vector<const std::vector<PolarVolume>*>& radars)
{
  GridRequest request;
  request.dimensions = {256, 256, 40};
  request.bottom = 0.0;
  request.top = 10'000.0;
  std::vector<const PolarVolume*> volumes;
  std::vector<Position> positions;
  for (const std::vector<PolarVolume>* radar : radars)
  {
    positions.push_back(*radar->front().site.position);
    volumes.push_back(&(*radar)[2]);
    volumes.push_back(&(*radar)[3]);
  }
  BeamMergeOptions options;
  options.strategy = OverlapStrategy::Nearest;
  options.ancillary = true;
  options.biases = biases;
  BeamMerger merger(MakeGrid(request, positions), options);
  const auto merged = MergePolar(merger, volumes, evening + 30min);
  EXPECT_EQ(merged->sites, (std::vector<std::string>{"KILX", "KLSX"}));
  return StepAtSeam(*merged);
}

} // namespace

TEST(RadarComparison, FindsTheBiasOfASimulatedRadar)
{
  for (const double bias : {2.0, -2.0})
  {
    const BiasReport report = Compare({&Scanned("KILX", 0.0), &Scanned("KLSX", bias)});
    ASSERT_EQ(report.pairs.size(), 1U);
    EXPECT_EQ(report.pairs[0].volumes, 6U);
    EXPECT_AT_LEAST(report.pairs[0].cells, 180U, "places that two radars see");
    EXPECT_WITHIN(report.pairs[0].median, -bias, 0.1, "bias between two radars, dB") << bias;
    // Two radars do not tell which of them is wrong.
    EXPECT_DOUBLE_EQ(report.biases.at("KLSX"), -report.biases.at("KILX"));
    EXPECT_TRUE(report.alone.empty());
  }
}

// What the biases of the comparison do to the border of the two radars' parts of a merged volume.
TEST(RadarComparison, TakesTheStepFromTheSeam)
{
  const std::vector<const std::vector<PolarVolume>*> right = {
    &Scanned("KILX", 0.0), &Scanned("KLSX", 0.0)};
  const std::vector<const std::vector<PolarVolume>*> wrong = {
    &Scanned("KILX", 0.0), &Scanned("KLSX", 2.0)};
  const double natural = StepWith({}, right);
  EXPECT_WITHIN(
    StepWith({}, wrong), natural + 2.0, 0.055, "step at the seam with a bias of 2 dB, dB");
  EXPECT_WITHIN(StepWith(Compare(wrong).biases, wrong), natural, 0.005,
    "step at the seam when the bias that was found is taken off, dB");
}

TEST(RadarComparison, OfOneRadarIsEmpty)
{
  EXPECT_TRUE(Compare({&Scanned("KILX", 0.0)}).IsEmpty());
  EXPECT_TRUE(CompareRadars({}).IsEmpty());
}

// The order of the volumes makes no difference, and radars that are far apart in space or in time
// tell nothing of each other.
TEST(RadarComparison, NeedsNeighbours)
{
  std::vector<PolarVolume> far = Scanned("KLSX", 2.0);
  for (PolarVolume& volume : far)
  {
    volume.site = {"KABR", FindSite("KABR")->position};
  }
  std::vector<PolarVolume> late = Scanned("KLSX", 2.0);
  for (PolarVolume& volume : late)
  {
    for (PolarSweep& sweep : volume.sweeps)
    {
      for (PolarRay& ray : sweep.rays)
      {
        ray.time += 2h;
      }
    }
  }
  for (const std::vector<PolarVolume>* other : {&far, &late})
  {
    const BiasReport report = Compare({&Scanned("KILX", 0.0), other});
    EXPECT_TRUE(report.pairs.empty());
    EXPECT_TRUE(report.biases.empty());
    EXPECT_EQ(report.alone.size(), 2U);
  }
  EXPECT_EQ(Compare({&Scanned("KILX", 0.0), &Scanned("KLSX", 2.0)}).Lines(),
    Compare({&Scanned("KLSX", 2.0), &Scanned("KILX", 0.0)}).Lines());
}

TEST(LowEcho, ComesBackFromAnotherProcess)
{
  SeriesVolume volume;
  volume.lowEcho = std::make_shared<const LowEcho>(Scanned("KILX", 0.0).front());
  ScannedFile file;
  file.volumes.emplace_back(volume.lowEcho->site, volume);
  const std::vector<ScannedFile> back = UnpackScannedFiles(PackScannedFiles({file}));
  const LowEcho& echo = *volume.lowEcho;
  const LowEcho& copy = *back.at(0).volumes.at(0).second.lowEcho;
  EXPECT_FALSE(echo.cells.empty());
  EXPECT_EQ(copy.cells, echo.cells);
  EXPECT_EQ(copy.site.name, "KILX");
  EXPECT_EQ(copy.site.position, echo.site.position);
  EXPECT_EQ(copy.start, echo.start);
  EXPECT_EQ(copy.time, echo.time);
  EXPECT_EQ(copy.firstLayer, echo.firstLayer);
  EXPECT_EQ(copy.layers, echo.layers);
  EXPECT_THROW(UnpackScannedFiles("no bytes of it"), Error);
}

TEST(LowEcho, RefusesOtherMoments)
{
  PolarVolume volume = Scanned("KILX", 0.0).front();
  volume.moment = MomentName::VEL;
  EXPECT_THROW(LowEcho{volume}, Error);
}
