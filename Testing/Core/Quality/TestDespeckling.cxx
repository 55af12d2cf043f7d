// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q3, Q5: which gates despeckling takes out of hand-made sweeps and of a real file.
#include "PolarMerge.h"
#include "SweepMaker.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Quality/Despeckling.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

const Position position = {38.7, -92.0, 200.0};

PolarVolume VolumeOf(const std::vector<NumberSweep>& sweeps)
{
  return MakeVolume(position, 0.0, sweeps);
}

std::vector<NumberSweep> ThreeTilts()
{
  return {MakeSweep(1, 0.5, 360, 100), MakeSweep(2, 1.5, 360, 100), MakeSweep(3, 2.4, 360, 100)};
}

using Counts = std::vector<std::size_t>;

std::size_t Count(const PolarSweep& sweep, GateState state)
{
  const std::vector<GateState> states = NumbersOf(sweep).states;
  return static_cast<std::size_t>(std::count(states.begin(), states.end(), state));
}

// Despeckles a volume, and counts the gates that were taken out of each sweep.
Counts Despeckled(PolarVolume& volume, int neighbours)
{
  Despeckle(volume, neighbours);
  Counts removed;
  for (const PolarSweep& sweep : volume.sweeps)
  {
    std::vector<std::uint16_t> codes(sweep.gates);
    std::size_t count = 0;
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      sweep.Read(ray, codes.data());
      count += static_cast<std::size_t>(std::count(codes.begin(), codes.end(), GateCode::Filtered));
    }
    removed.push_back(count);
  }
  return removed;
}

} // namespace

TEST(Despeckling, TakesOutAGateAlone)
{
  std::vector<NumberSweep> sweeps = ThreeTilts();
  SetGate(sweeps[1], 40, 50, 30.0F);
  PolarVolume volume = VolumeOf(sweeps);
  EXPECT_EQ(Despeckled(volume, 1), (Counts{0, 1, 0}));
  const NumberSweep clean = NumbersOf(volume.sweeps[1]);
  EXPECT_EQ(clean.states[clean.Index(40, 50)], GateState::NotSampled);
  EXPECT_EQ(Count(volume.sweeps[1], GateState::BelowThreshold), 35'999u);
}

TEST(Despeckling, CountsRaysGatesAndTilts)
{
  // A gate with a neighbour in each direction, and how far off the neighbour no longer counts.
  struct Neighbour
  {
    std::size_t sweep, ray, gate;
    bool counts;
  };
  for (const Neighbour& other :
    {Neighbour{1, 41, 51, true}, Neighbour{1, 39, 50, true}, Neighbour{1, 40, 49, true},
      Neighbour{1, 42, 50, false}, Neighbour{1, 40, 52, false}, Neighbour{0, 41, 49, true},
      Neighbour{2, 40, 50, true}, Neighbour{2, 42, 50, false}, Neighbour{0, 40, 48, false}})
  {
    std::vector<NumberSweep> sweeps = ThreeTilts();
    SetGate(sweeps[1], 40, 50, 30.0F);
    SetGate(sweeps[other.sweep], other.ray, other.gate, 30.0F);
    PolarVolume volume = VolumeOf(sweeps);
    const Counts removed = Despeckled(volume, 1);
    EXPECT_EQ(
      std::accumulate(removed.begin(), removed.end(), std::size_t(0)), other.counts ? 0u : 2u)
      << other.sweep << ' ' << other.ray << ' ' << other.gate;
  }
}

// Tilts two apart are no neighbours.
TEST(Despeckling, LooksAtTheNextTiltAlone)
{
  std::vector<NumberSweep> sweeps = ThreeTilts();
  SetGate(sweeps[0], 40, 50, 30.0F);
  SetGate(sweeps[2], 40, 50, 30.0F);
  PolarVolume volume = VolumeOf(sweeps);
  EXPECT_EQ(Despeckled(volume, 1), (Counts{1, 0, 1}));
}

TEST(Despeckling, GoesRoundTheCircleAndNotAcrossGaps)
{
  std::vector<NumberSweep> sweeps = ThreeTilts();
  SetGate(sweeps[0], 0, 50, 30.0F);
  SetGate(sweeps[0], 359, 50, 30.0F);
  PolarVolume volume = VolumeOf(sweeps);
  EXPECT_EQ(Despeckled(volume, 1), (Counts{0, 0, 0}));
  NumberSweep torn = MakeSweep(1, 0.5, 360, 100);
  SetGate(torn, 100, 50, 30.0F);
  SetGate(torn, 103, 50, 30.0F);
  torn.rays.erase(torn.rays.begin() + 101, torn.rays.begin() + 103);
  const auto from = static_cast<std::ptrdiff_t>(torn.Index(101, 0));
  const auto to = static_cast<std::ptrdiff_t>(torn.Index(103, 0));
  torn.values.erase(torn.values.begin() + from, torn.values.begin() + to);
  torn.states.erase(torn.states.begin() + from, torn.states.begin() + to);
  volume = VolumeOf({torn});
  EXPECT_EQ(Despeckled(volume, 1), Counts{2});
}

// 3 × 3 gates in one sweep: the corners have 3 neighbours, the edges 5, the middle 8. What goes is
// judged by the volume as it was, so that the middle stays.
TEST(Despeckling, JudgesAllGatesByTheVolumeAsItWas)
{
  std::vector<NumberSweep> sweeps = ThreeTilts();
  for (std::size_t ray = 200; ray < 203; ++ray)
  {
    for (std::size_t gate = 60; gate < 63; ++gate)
    {
      SetGate(sweeps[1], ray, gate, 30.0F);
    }
  }
  for (const auto& [neighbours, removed] :
    {std::pair(0, 0u), std::pair(3, 0u), std::pair(4, 4u), std::pair(6, 8u), std::pair(9, 9u)})
  {
    PolarVolume volume = VolumeOf(sweeps);
    EXPECT_EQ(Despeckled(volume, neighbours)[1], removed) << neighbours;
  }
}

// Rays of half a degree and gates of 250 m below rays of one degree and gates of 1 km; a cut that
// is repeated, in which the echo is not.
TEST(Despeckling, FindsTheNeighboursOfOtherResolutionsAndRepeatedCuts)
{
  NumberSweep fine = MakeSweep(1, 0.5, 720, 400, 250.0);
  const NumberSweep again = MakeSweep(3, 0.52, 720, 400, 250.0);
  NumberSweep coarse = MakeSweep(2, 1.5, 360, 100);
  SetGate(fine, 300, 199, 30.0F); // 150°, 50 km
  SetGate(coarse, 150, 49, 30.0F);
  for (const std::vector<NumberSweep>& sweeps :
    {std::vector<NumberSweep>{fine, coarse}, std::vector<NumberSweep>{fine, again, coarse},
      std::vector<NumberSweep>{again, fine, coarse}})
  {
    PolarVolume volume = VolumeOf(sweeps);
    const Counts removed = Despeckled(volume, 1);
    EXPECT_EQ(std::accumulate(removed.begin(), removed.end(), std::size_t(0)), 0u);
  }
}

TEST(Despeckling, RefusesNumbersThatNoGateHas)
{
  PolarVolume volume = VolumeOf(ThreeTilts());
  EXPECT_THROW(Despeckle(volume, -1), Error);
  EXPECT_THROW(Despeckle(volume, 27), Error);
  EXPECT_EQ(Despeckled(volume, 26), (Counts{0, 0, 0}));
}

TEST(Despeckling, TakesSweepsWithoutRaysOrGatesAsTheyAre)
{
  NumberSweep one = MakeSweep(1, 0.5, 1, 10);
  SetGate(one, 0, 5, 20.0F);
  PolarVolume volume = VolumeOf({NumberSweep{}, one, MakeSweep(2, 1.5, 2, 0)});
  EXPECT_EQ(Despeckled(volume, 1), (Counts{0, 1, 0}));
}

// What is taken out is no statement that there is nothing: echo of another radar keeps its value.
TEST(Despeckling, LeavesThePlaceToAnotherRadar)
{
  std::vector<NumberSweep> echo = {MakeSweep(1, 0.5, 360, 100), MakeSweep(2, 1.5, 360, 100)};
  SetAll(echo[0], 40.0F);
  SetAll(echo[1], 40.0F);
  for (NumberSweep& sweep : echo)
  {
    for (PolarRay& ray : sweep.rays)
    {
      ray.time = *ParseIso8601("2006-03-12T18:00Z");
    }
  }
  const PolarVolume full = VolumeOf(echo);
  for (NumberSweep& sweep : echo)
  {
    SetAll(sweep, GateState::NotSampled);
    SetGate(sweep, 90, 50, 10.0F);
  }
  PolarVolume speckled = VolumeOf(echo);
  speckled.site.name = "KTWO";
  PolarVolume clean = speckled;
  Despeckle(clean, 12);
  GridSpecification grid;
  grid.dimensions = {41, 41, 6};
  grid.spacing = {1'000.0, 1'000.0, 250.0};
  grid.origin = {30'000.0, -20'000.0, 500.0};
  grid.centreLatitude = position.latitude;
  grid.centreLongitude = position.longitude;
  BeamMerger merger(grid);
  const auto alone = MergePolar(merger, {&full}, full.start);
  const auto cleaned = MergePolar(merger, {&full, &clean}, full.start);
  const auto spoilt = MergePolar(merger, {&full, &speckled}, full.start);
  EXPECT_EQ(cleaned->values, alone->values);
  EXPECT_NE(spoilt->values, alone->values);
}

// How much of the echo stands alone, by tilt, is printed: of a storm next to nothing, of the clear
// air and snow of a super-resolution radar much.
TEST(Despeckling, OfRealFilesTakesLittleOfStormsAndMuchOfSpeckle)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto shareOf = [&data](const char* file, int neighbours)
  {
    PolarVolume volume = MakePolarVolume(ReadLevel2(data / "level2" / file), MomentName::REF);
    Counts echo;
    for (const PolarSweep& sweep : volume.sweeps)
    {
      echo.push_back(Count(sweep, GateState::Valid));
    }
    const Counts removed = Despeckled(volume, neighbours);
    std::printf("%s, fewer than %d neighbours\n", file, neighbours);
    for (std::size_t i = 0; i < removed.size(); ++i)
    {
      std::printf("  %5.2f deg  %8zu of %8zu gates\n",
        static_cast<double>(volume.sweeps[i].rays.front().elevation), removed[i], echo[i]);
    }
    const auto sum = [](const Counts& counts)
    { return static_cast<double>(std::accumulate(counts.begin(), counts.end(), std::size_t(0))); };
    std::printf("  all        %.2f %%\n", 100.0 * sum(removed) / sum(echo));
    return sum(removed) / sum(echo);
  };
  EXPECT_AT_MOST(shareOf("legacy/KTLX19990503_235621.gz", 4), 0.007,
    "echo of storms removed below 4 neighbours, part");
  EXPECT_AT_MOST(shareOf("legacy/KTLX19990503_235621.gz", 8), 0.025,
    "echo of storms removed below 8 neighbours, part");
  EXPECT_AT_LEAST(shareOf("superres/KDMX20250101_225441_V06", 4), 0.05,
    "speckle removed below 4 neighbours, part");
  EXPECT_AT_LEAST(shareOf("superres/KDMX20250101_225441_V06", 8), 0.15,
    "speckle removed below 8 neighbours, part");
}
