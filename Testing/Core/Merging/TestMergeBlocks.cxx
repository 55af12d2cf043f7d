// SPDX-License-Identifier: BSD-3-Clause
// Parts of a merged volume, made one by one: together they are, bit by bit, the volume made at
// once.
#include "DirectMerge.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Merging/SeriesMerger.h"

#include "HandMadeVolume.h"
#include "MovingEcho.h"
#include "Scans/RadarsOfMissouri.h"
#include "SweepMaker.h"
#include "TestData.h"
#include "ThreadProcesses.h"
#include "Tolerance.h"
#include "VolumePart.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;
using namespace nexrad::testing;

const Position middle = {38.7, -92.0, 200.0};

// Two radars 90 km apart and a third 330 km from the first, each with a volume before noon and one
// after it; storms between them that move.
const std::vector<PolarVolume>& ThreeRadars()
{
  static const std::vector<PolarVolume> volumes = []
  {
    MovingEcho field;
    field.storms = {{-40e3, 10e3, 55.0}, {20e3, -30e3, 45.0}, {70e3, 40e3, 50.0},
      {130e3, -10e3, 40.0}, {260e3, 20e3, 52.0}};
    field.velocity = {17.0, -6.0};
    ScanPlan plan;
    plan.rays = 180;
    std::vector<PolarVolume> scanned;
    const double eastOf[] = {0.0, 90e3, 330e3};
    const char* names[] = {"KAAA", "KBBB", "KCCC"};
    for (int i = 0; i < 3; ++i)
    {
      GridSpecification flat;
      flat.centreLatitude = middle.latitude;
      flat.centreLongitude = middle.longitude;
      const auto place = flat.ToGeographic(eastOf[i], 0.0);
      const Site site = {names[i], Position{place[1], place[0], 200.0 + 40.0 * i}};
      for (const double seconds : {-310.0 + 20.0 * i, -10.0 + 20.0 * i})
      {
        scanned.push_back(ScanEcho(field, site, noon, seconds, plan, eastOf[i]));
      }
    }
    return scanned;
  }();
  return volumes;
}

// The same radars, of which the second has echo on its two lowest tilts alone, the third lacks a
// sector, and the lowest sweeps of the first end before the others: beyond, the second tilt is the
// lowest that scans.
std::vector<PolarVolume> RadarsWithGaps()
{
  std::vector<PolarVolume> volumes = ThreeRadars();
  for (PolarVolume& volume : volumes)
  {
    for (std::size_t i = 0; i < volume.sweeps.size(); ++i)
    {
      PolarSweep& sweep = volume.sweeps[i];
      if (volume.site.name == "KAAA" && i == 0)
      {
        sweep.gates = 60;
      }
      if (volume.site.name == "KBBB" && i > 1)
      {
        const std::size_t gates = sweep.rays.size() * sweep.gates;
        SetGates(sweep, std::vector<float>(gates, 0.0F),
          std::vector<GateState>(gates, GateState::BelowThreshold));
      }
      if (volume.site.name == "KCCC")
      {
        sweep.rays.resize(sweep.rays.size() - 20 - i);
      }
    }
  }
  return volumes;
}

// Odd in every direction, and wider than what the radars see.
GridSpecification OddGrid(GridAxes axes = GridAxes::Projected)
{
  GridSpecification grid;
  grid.dimensions = {117, 41, 13};
  grid.axes = axes;
  grid.centreLatitude = middle.latitude;
  grid.centreLongitude = middle.longitude;
  const bool projected = axes == GridAxes::Projected;
  grid.origin = {projected ? -200e3 : -94.3, projected ? -120e3 : 37.6, 300.0};
  grid.spacing = {projected ? 6.1e3 : 0.07, projected ? 6.3e3 : 0.06, 710.0};
  return grid;
}

MergeRequest Request(const GridSpecification& grid = OddGrid())
{
  MergeRequest request;
  request.grid = grid;
  request.time = noon;
  return request;
}

// The grid in `parts` along an axis, as even as it goes.
std::vector<VoxelBlock> SplitAlong(const GridSpecification& grid, std::size_t axis, int parts)
{
  std::vector<VoxelBlock> blocks;
  for (int part = 0; part < parts; ++part)
  {
    VoxelBlock block = VoxelBlock::Of(grid);
    block.begin[axis] = grid.dimensions[axis] * part / parts;
    block.end[axis] = grid.dimensions[axis] * (part + 1) / parts;
    blocks.push_back(block);
  }
  return blocks;
}

// Blocks inside the grid, a single voxel, and one that no radar sees.
std::vector<VoxelBlock> OddBlocks()
{
  return {{{3, 5, 2}, {18, 20, 9}}, {{17, 0, 0}, {33, 41, 13}}, {{60, 20, 6}, {61, 21, 7}},
    {{116, 0, 0}, {117, 3, 13}}};
}

void ExpectSame(const GriddedVolume& part, const GriddedVolume& expected)
{
  EXPECT_EQ(part.grid.dimensions, expected.grid.dimensions);
  EXPECT_EQ(part.grid.origin, expected.grid.origin);
  EXPECT_TRUE(part.values == expected.values);
  EXPECT_TRUE(part.states == expected.states);
  EXPECT_TRUE(part.ancillary.age == expected.ancillary.age);
  EXPECT_TRUE(part.ancillary.radars == expected.ancillary.radars);
  EXPECT_TRUE(part.ancillary.weight == expected.ancillary.weight);
  EXPECT_TRUE(part.ancillary.nearestSite == expected.ancillary.nearestSite);
  EXPECT_EQ(part.sites, expected.sites);
  EXPECT_EQ(part.fill, expected.fill);
}

// Makes the blocks one by one, in one run and each in a run of its own.
void ExpectBlocksOfTheWhole(MergeRequest request, const std::vector<VoxelBlock>& blocks)
{
  const std::vector<const PolarVolume*> volumes = PointersTo(ThreeRadars());
  request.block.reset();
  const GriddedVolume whole = *testing::MergeDirectly(volumes, request);
  ASSERT_AT_LEAST(
    std::count(whole.states.begin(), whole.states.end(), VoxelState::Echo), 700, "voxels of echo");
  testing::DirectRun run;
  for (const VoxelBlock& block : blocks)
  {
    SCOPED_TRACE(std::to_string(block.begin[0]) + "," + std::to_string(block.begin[1]) + "," +
                 std::to_string(block.begin[2]));
    request.block = block;
    const GriddedVolume expected = TakePart(whole, block);
    ExpectSame(*testing::MergeDirectly(volumes, request, {}, &run), expected);
    ExpectSame(*testing::MergeDirectly(volumes, request), expected);
  }
}

TEST(MergeBlocks, PiecesOfAnyNumberMakeTheWhole)
{
  const MergeRequest request = Request();
  for (const int parts : {2, 3, 4, 7})
  {
    ExpectBlocksOfTheWhole(request, SplitAlong(request.grid, 0, parts));
  }
  ExpectBlocksOfTheWhole(request, SplitAlong(request.grid, 1, 3));
  ExpectBlocksOfTheWhole(request, SplitAlong(request.grid, 2, 3));
  ExpectBlocksOfTheWhole(request, OddBlocks());
}

// A column that no echo is near is not looked up tilt by tilt, unless the ages of its rays are
// wanted. Before, within and after the volumes, where tilts lack one side or are in progress.
TEST(MergeBlocks, ColumnsWithoutEchoAreThoseOfATiltByTiltMerge)
{
  const std::vector<PolarVolume> gaps = RadarsWithGaps();
  for (const Duration after : {Duration(-500s), Duration(-250s), Duration(-130s), Duration(-7s),
         Duration(2s), Duration(33s), Duration(180s), Duration(265s)})
  {
    MergeRequest request = Request();
    request.time = noon + after;
    request.beam.beamWidth = 2.5; // so that neighbouring beams overlap
    request.maximumGap = 6min;    // so that some rays count in part
    for (const std::vector<PolarVolume>* radars : {&ThreeRadars(), &gaps})
    {
      for (const double length : {100'000.0, 8'000.0}) // of the second, weights become 0
      {
        request.beam.overlapLength = length;
        request.beam.ancillary = true;
        const GriddedVolume expected = *testing::MergeDirectly(PointersTo(*radars), request);
        request.beam.ancillary = false;
        const GriddedVolume merged = *testing::MergeDirectly(PointersTo(*radars), request);
        EXPECT_TRUE(merged.values == expected.values) << after.count();
        EXPECT_TRUE(merged.states == expected.states) << after.count();
      }
    }
  }
}

// The first volumes begin five minutes before noon, the last end two minutes after it.
TEST(MergeBlocks, InTheFirstAndTheLastMinutes)
{
  for (const Duration after : {Duration(-290s), Duration(-200s), Duration(80s), Duration(4min)})
  {
    MergeRequest request = Request();
    request.time = noon + after;
    ExpectBlocksOfTheWhole(request, SplitAlong(request.grid, 0, 3));
    ExpectBlocksOfTheWhole(request, OddBlocks());
  }
}

TEST(MergeBlocks, WhateverTheMethodAsks)
{
  const std::vector<VoxelBlock> blocks = OddBlocks();
  for (const OverlapStrategy strategy : {OverlapStrategy::Mean, OverlapStrategy::Nearest,
         OverlapStrategy::Maximum, OverlapStrategy::Distance})
  {
    MergeRequest request = Request();
    request.beam.strategy = strategy;
    request.beam.ancillary = true;
    ExpectBlocksOfTheWhole(request, blocks);
  }
  MergeRequest filled = Request();
  filled.beam.fillColumns = true;
  ExpectBlocksOfTheWhole(filled, blocks);
  MergeRequest measured = Request();
  measured.beam.sharpen = false;
  measured.beam.linearReflectivity = true;
  ExpectBlocksOfTheWhole(measured, blocks);
  MergeRequest linear = Request();
  linear.interpolation = TimeInterpolationMethod::Linear;
  ExpectBlocksOfTheWhole(linear, blocks);
  MergeRequest given = Request();
  given.motion = Velocity{12.0, 3.0};
  ExpectBlocksOfTheWhole(given, blocks);
  ExpectBlocksOfTheWhole(Request(OddGrid(GridAxes::Geographic)), blocks);
  MergeRequest thesis = Request();
  thesis.method = MergeMethod::Thesis;
  ExpectBlocksOfTheWhole(thesis, blocks);
  ExpectBlocksOfTheWhole(thesis, SplitAlong(thesis.grid, 2, 3));
}

TEST(MergeBlocks, ABlockMustLieInTheGrid)
{
  for (const VoxelBlock& wrong : {VoxelBlock{{0, 0, 0}, {118, 41, 13}},
         VoxelBlock{{-1, 0, 0}, {10, 10, 10}}, VoxelBlock{{5, 5, 5}, {5, 10, 10}}})
  {
    for (const MergeMethod method : {MergeMethod::Beam, MergeMethod::Thesis})
    {
      MergeRequest request = Request();
      request.method = method;
      request.block = wrong;
      EXPECT_THROW(testing::MergeDirectly(PointersTo(ThreeRadars()), request), Error);
    }
  }
}

void ExpectSame(const VolumeComposite& found, const VolumeComposite& expected)
{
  ASSERT_EQ(found.cells.size(), expected.cells.size());
  EXPECT_EQ(found.rings, expected.rings);
  EXPECT_EQ(found.values, expected.values);
  EXPECT_EQ(found.echo, expected.echo);
  EXPECT_EQ(found.echoTime, expected.echoTime);
  for (std::size_t i = 0; i < found.cells.size(); ++i)
  {
    const auto none = VolumeComposite::Cell::NotScanned;
    ASSERT_EQ(found.cells[i] == none, expected.cells[i] == none);
  }
  ASSERT_EQ(found.tilts.size(), expected.tilts.size());
  for (std::size_t i = 0; i < found.tilts.size(); ++i)
  {
    EXPECT_EQ(found.tilts[i].elevation, expected.tilts[i].elevation);
    EXPECT_EQ(found.tilts[i].echo, expected.tilts[i].echo);
  }
}

TEST(MergeBlocks, ASummaryKeepsWhatTheSearchForMotionLooksAt)
{
  for (const PolarVolume& volume : ThreeRadars())
  {
    const VolumeSummary summary = MakeSummary(volume);
    EXPECT_EQ(summary.reach, 141'000.0);
    EXPECT_AT_MOST(summary.MemoryBytes(), 19'000u, "memory of a summary, bytes");
    const BeamVolume expected = PrepareBeamVolume(volume);
    ExpectSame(CompositeOf(summary.composite), expected.composite);
    ExpectSame(CompositeOf(summary.lowest), expected.lowest);
  }
  PackedComposite torn = MakeSummary(ThreeRadars().front()).composite;
  torn.rings -= 1;
  EXPECT_THROW(CompositeOf(torn), Error);
  torn.rings += 2;
  EXPECT_THROW(CompositeOf(torn), Error);
}

// Radars in a row, 400 km between neighbours, each with volumes before and after the time: what a
// block needs is told by circles about them of 101 km.
class RowOfRadars : public ::testing::Test
{
protected:
  RowOfRadars()
  {
    for (int i = 0; i < 4; ++i)
    {
      const Site site = {std::string("K") + std::string(3, static_cast<char>('A' + i)),
        Position{38.7, -100.0 + 4.6 * i, 300.0}};
      HandMadeVolume before = ConstantVolume(site, noon - 4min, 20.0);
      HandMadeVolume after = ConstantVolume(site, noon + 1min, 20.0);
      // A sector of stronger echo that turns by 9° between the two.
      const auto sector = [](int from)
      {
        return [from](int ray, int gate)
        {
          return ReflectivityWord(
            ray >= from && ray < from + 40 && gate > 30 && gate < 70 ? 45.0 : 10.0);
        };
      };
      before.sweeps[0].moments[0].word = sector(100);
      after.sweeps[0].moments[0].word = sector(109);
      WriteLevel2(folder.Path() / (site.name + "1"), {before});
      WriteLevel2(folder.Path() / (site.name + "2"), {after});
    }
    options.grid.dimensions = {123, 21, 7};
    options.grid.range = 120'000.0;
    options.grid.top = 7'000.0;
    options.memory = 0;
    options.quality.level =
      QualityLevel::Off; // rays that hold one value are a fault of the receiver
  }

  // How the pieces of a pipeline are merged: all files are scanned first.
  std::unique_ptr<SeriesMerger> Open(bool scanFirst = true)
  {
    MergerSetup setup;
    setup.anyOrder = true;
    setup.scanFirst = scanFirst;
    auto merger =
      std::make_unique<SeriesMerger>(std::vector{folder.Path()}, options, std::move(setup));
    EXPECT_TRUE(merger->Open());
    merger->EndAt(noon); // nothing is decoded ahead
    return merger;
  }

  static GriddedVolume Make(
    SeriesMerger& merger, std::optional<VoxelBlock> block, std::size_t files)
  {
    const std::size_t before = merger.DecodedFiles();
    const GriddedVolume made = *merger.Merge(noon, {}, block);
    EXPECT_EQ(merger.DecodedFiles() - before, files);
    return made;
  }

  const TemporaryFolder folder;
  MergeOptions options;
};

TEST_F(RowOfRadars, ABlockIsMadeFromTheFilesOfTheRadarsThatReachIt)
{
  options.beam.ancillary = true;
  for (const MergeMethod method : {MergeMethod::Beam, MergeMethod::Thesis})
  {
    options.method = method;
    const GriddedVolume whole = Make(*this->Open(), std::nullopt, 8);
    EXPECT_EQ(whole.sites.size(), 4u);
    const auto merger = this->Open();
    for (const VoxelBlock& block : SplitAlong(merger->Grid(), 0, 4))
    {
      ExpectSame(Make(*merger, block, 2), TakePart(whole, block));
    }
    // Between two radars nothing is seen, and no file is needed.
    const int gap = merger->Grid().dimensions[0] / 3;
    const VoxelBlock nothing = {{gap - 10, 0, 0}, {gap - 8, 21, 7}};
    const GriddedVolume empty = Make(*merger, nothing, 0);
    ExpectSame(empty, TakePart(whole, nothing));
    EXPECT_EQ(std::count(empty.states.begin(), empty.states.end(), VoxelState::NotScanned), 294);
  }
}

TEST_F(RowOfRadars, BandsAreMadeOfTheSameVolumes)
{
  options.moments = {MomentName::REF, MomentName::VEL};
  for (const bool ancillary : {false, true})
  {
    options.beam.ancillary = ancillary;
    const GriddedVolume whole = Make(*this->Open(false), std::nullopt, 0);
    const auto merger = this->Open(false);
    int row = 0;
    const auto take = [&](GriddedVolume band)
    {
      VoxelBlock block = VoxelBlock::Of(whole.grid);
      block.begin[1] = row;
      block.end[1] = row += band.grid.dimensions[1];
      const GriddedVolume expected = TakePart(whole, block);
      ExpectSame(band, expected);
      ExpectSame(band.further.at(0), expected.further.at(0));
      return band;
    };
    EXPECT_TRUE(merger->MergeInBands(noon, 8, take));
    EXPECT_EQ(row, 21);
    EXPECT_FALSE(merger->MergeInBands(
      noon, 8, [](GriddedVolume band) { return band; },
      [](double fraction) { return fraction < 0.6; }));
  }
}

// Two processes decode four of the eight files each, tell each other what these hold, and merge a
// half of the grid from what they decoded.
TEST_F(RowOfRadars, ProcessesDecodeForEachOtherAndMergeBlocks)
{
  const GriddedVolume whole = Make(*this->Open(false), std::nullopt, 0);
  options.begin = noon;
  options.end = noon;
  const auto merge = [&](const Processes& processes)
  {
    MergerSetup setup;
    setup.processes = processes;
    setup.sharesBlocks = true;
    setup.order = ScanOrder::ByLongitude;
    SeriesMerger merger({folder.Path()}, options, setup);
    EXPECT_TRUE(merger.Open());
    merger.EndAt(noon);
    EXPECT_TRUE(merger.KnowTogether(noon));
    const VoxelBlock block = SplitAlong(merger.Grid(), 0, 2)[processes.Rank()];
    GriddedVolume expected = TakePart(whole, block);
    int row = 0;
    const auto take = [&](GriddedVolume band)
    {
      VoxelBlock rows = VoxelBlock::Of(expected.grid);
      rows.begin[1] = row;
      rows.end[1] = row += band.grid.dimensions[1];
      ExpectSame(band, TakePart(expected, rows));
      return band;
    };
    EXPECT_TRUE(merger.MergeInBands(noon, 8, take, {}, block));
    EXPECT_EQ(row, 21);
    EXPECT_TRUE(merger.Settle());
    return merger.DecodedFiles();
  };
  EXPECT_EQ(AsProcesses(2, merge), (std::vector<std::size_t>{4, 4}));
}

// The motion over a block is found from all radars: where the others are left out, it is another.
TEST_F(RowOfRadars, TheMotionIsThatOfAllRadars)
{
  const auto merger = this->Open();
  const VoxelBlock block = SplitAlong(merger->Grid(), 0, 4).front();
  const GriddedVolume right = Make(*merger, block, 2);
  MergeRequest request = MergeRequestOf(options, {});
  request.grid = merger->Grid();
  request.time = noon;
  request.block = block;
  const PolarVolume before = MakePolarVolume(ReadLevel2(folder.Path() / "KAAA1"), MomentName::REF);
  const PolarVolume after = MakePolarVolume(ReadLevel2(folder.Path() / "KAAA2"), MomentName::REF);
  EXPECT_TRUE(testing::MergeDirectly({&before, &after}, request)->values != right.values);
}

// Without a scan it is not known how far the radars see.
TEST_F(RowOfRadars, WithoutAScanEveryRadarIsAsked)
{
  const auto merger = this->Open();
  const VoxelBlock block = SplitAlong(merger->Grid(), 0, 4).front();
  const auto byHeaders = this->Open(false);
  EXPECT_FALSE(byHeaders->IsScanned());
  EXPECT_EQ(byHeaders->Grid(), merger->Grid());
  ExpectSame(*byHeaders->Merge(noon, {}, block), *merger->Merge(noon, {}, block));
  EXPECT_EQ(byHeaders->DecodedFiles(), 8u);
}

} // namespace
} // namespace nexrad
