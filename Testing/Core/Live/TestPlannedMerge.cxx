// SPDX-License-Identifier: BSD-3-Clause
// What a sweep that arrives changes of a merge, against the whole merge of all that is there.
#include "nexrad/Live/LiveSeries.h"

#include "Scans/RadarsOfMissouri.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/Simulation/StormField.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

constexpr int pattern = 31; // five tilts in ten minutes

struct Replaced
{
  std::size_t cells = 0;  // of columns that were merged
  std::size_t voxels = 0; // that became others
};

constexpr int cell = 2; // columns along x and y that are replaced together
constexpr std::size_t allCells = 45 * 35;

// Whether a column of a tile becomes another one.
bool IsChanged(const ChangedTile& tile, int x, int y)
{
  const int across = (tile.block.Size(0) - 1) / cell + 1;
  return tile.changed.at(static_cast<std::size_t>(y / cell * across + x / cell)) != 0;
}

template <class Values>
void CopyColumns(const ChangedTile& tile, const Values& from, Values& to, const VoxelBlock& whole)
{
  std::size_t i = 0;
  for (int z = 0; z < tile.block.Size(2) && !from.empty(); ++z)
  {
    for (int y = 0; y < tile.block.Size(1); ++y)
    {
      for (int x = 0; x < tile.block.Size(0); ++x, ++i)
      {
        const int row = z * whole.Size(1) + y + tile.block.begin[1];
        const auto at = static_cast<std::size_t>(row * whole.Size(0) + x + tile.block.begin[0]);
        to[at] = IsChanged(tile, x, y) ? from[i] : to[at];
      }
    }
  }
}

void CopyMoment(const ChangedTile& tile, const GriddedVolume& from, GriddedVolume& to)
{
  const VoxelBlock whole = VoxelBlock::Of(to.grid);
  CopyColumns(tile, from.values, to.values, whole);
  CopyColumns(tile, from.states, to.states, whole);
  CopyColumns(tile, from.ancillary.age, to.ancillary.age, whole);
  CopyColumns(tile, from.ancillary.weight, to.ancillary.weight, whole);
  CopyColumns(tile, from.ancillary.radars, to.ancillary.radars, whole);
  CopyColumns(tile, from.ancillary.nearestSite, to.ancillary.nearestSite, whole);
}

// Two radars (synthetic) that scan a storm, of which sweeps arrive one by one.
class ArrivingSweeps : public ::testing::Test
{
protected:
  ArrivingSweeps()
  {
    options.grid.dimensions = {90, 70, 16};
    options.grid.bounds = GeographicBounds{-96.0, 37.0, -89.0, 41.0};
    options.quality.level = QualityLevel::Off;
  }

  // A volume with its first sweeps alone, or whole.
  static LiveInput Input(const Site& site, Time begin, std::size_t sweeps = 100)
  {
    SimulatorOptions simulator;
    simulator.superResolution = false;
    static std::map<std::pair<std::string, Time>, RadarVolume> scanned;
    const std::pair<std::string, Time> key = {site.name, begin};
    if (scanned.count(key) == 0)
    {
      scanned[key] = ScanVolume(StormField(1), site, pattern, begin, simulator);
    }
    LiveInput input{site.name + FormatIso8601(begin), {}, scanned[key], true};
    if (sweeps < input.volume.sweeps.size())
    {
      input.volume.sweeps.resize(sweeps);
      input.finished = false;
    }
    return input;
  }

  static GriddedVolume MakeWhole(PlannedMerge& merge)
  {
    GriddedVolume whole;
    merge.MergeBands(1000,
      [&whole](GriddedVolume band)
      {
        whole = std::move(band);
        return GriddedVolume();
      },
      {});
    return whole;
  }

  // Takes over what differs, in tiles of 32 columns along x and y.
  static Replaced Replace(const PlannedMerge& before, PlannedMerge& after, GriddedVolume& volume)
  {
    Replaced replaced;
    const std::vector<float> values = volume.values;
    for (const VoxelBlock& block : after.FindTiles(before, 32))
    {
      if (const std::optional<ChangedTile> tile = after.MergeTile(before, block, cell))
      {
        EXPECT_TRUE(tile->volume.grid == PartOf(volume.grid, block));
        CopyMoment(*tile, tile->volume, volume);
        for (std::size_t i = 0; i < volume.further.size(); ++i)
        {
          CopyMoment(*tile, tile->volume.further.at(i), volume.further[i]);
        }
        const auto kept = std::count(tile->changed.begin(), tile->changed.end(), 0);
        replaced.cells += tile->changed.size() - static_cast<std::size_t>(kept);
      }
    }
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      replaced.voxels += values[i] != volume.values[i] ? 1 : 0;
    }
    return replaced;
  }

  static void ExpectSame(const GriddedVolume& made, const GriddedVolume& expected)
  {
    EXPECT_TRUE(made.values == expected.values);
    EXPECT_TRUE(made.states == expected.states);
    EXPECT_TRUE(made.ancillary.age == expected.ancillary.age);
    EXPECT_TRUE(made.ancillary.weight == expected.ancillary.weight);
    EXPECT_TRUE(made.ancillary.radars == expected.ancillary.radars);
    EXPECT_TRUE(made.ancillary.nearestSite == expected.ancillary.nearestSite);
    ASSERT_EQ(made.further.size(), expected.further.size());
    for (std::size_t i = 0; i < made.further.size(); ++i)
    {
      ExpectSame(made.further[i], expected.further[i]);
    }
  }

  // A series with a volume of each radar, and what then arrives: a sweep, further ones, the rest,
  // the first sweep of the other radar.
  void ExpectThatSweepsChangeWhatTheyCross(
    bool notes = true, Duration until = 9min, std::size_t mostCells = 1000)
  {
    const Time time = start + until;
    LiveSeries series(options, {});
    series.Put({Input(keax, start), Input(klsx, start + 1min)});
    series.KeepGrid();
    PlannedMerge before = series.Plan(time);
    notes ? before.NoteEchoes() : void();
    GriddedVolume volume = MakeWhole(before);
    for (const LiveInput& input : {Input(keax, start + 6min, 1), Input(keax, start + 6min, 4),
           Input(keax, start + 6min), Input(klsx, start + 7min, 1)})
    {
      series.Put({input});
      PlannedMerge after = series.PlanAgain(before);
      ASSERT_TRUE(after.KeepsVoxelsOf(before));
      const Replaced replaced = Replace(before, after, volume);
      EXPECT_GT(replaced.voxels, 100U);
      EXPECT_LE(replaced.cells, mostCells);
      PlannedMerge whole = after; // what it notes is its own
      ExpectSame(volume, MakeWhole(whole));
      ExpectSame(volume, *series.Merge(time));
      before = std::move(after);
    }
    PlannedMerge again = series.PlanAgain(before);
    EXPECT_EQ(Replace(before, again, volume).cells, 0U) << "nothing arrived";
  }

  MergeOptions options;
};

} // namespace

TEST_F(ArrivingSweeps, ChangeTheColumnsThatTheyCross)
{
  options.interpolation = TimeInterpolationMethod::Linear;
  this->ExpectThatSweepsChangeWhatTheyCross(true);
  this->ExpectThatSweepsChangeWhatTheyCross(false);
}

TEST_F(ArrivingSweeps, AlongAMotion)
{
  options.motion = Velocity{12.0, 6.0};
  this->ExpectThatSweepsChangeWhatTheyCross();
}

TEST_F(ArrivingSweeps, OfSeveralMomentsWithAncillaryArrays)
{
  options.moments = {MomentName::REF, MomentName::VEL};
  options.motion = Velocity{-3.0, 8.0};
  options.beam.ancillary = true;
  this->ExpectThatSweepsChangeWhatTheyCross(true, 9min, allCells); // the age changes everywhere
}

// What ages counts less from radar to radar; where none holds anything, that changes nothing.
TEST_F(ArrivingSweeps, WhileObservationsAge)
{
  options.interpolation = TimeInterpolationMethod::Linear;
  this->ExpectThatSweepsChangeWhatTheyCross(true, 13min, 1400);
  this->ExpectThatSweepsChangeWhatTheyCross(false, 13min, allCells);
}

TEST_F(ArrivingSweeps, ByEachStrategy)
{
  options.interpolation = TimeInterpolationMethod::Linear;
  for (const OverlapStrategy strategy :
    {OverlapStrategy::Mean, OverlapStrategy::Nearest, OverlapStrategy::Maximum})
  {
    options.beam.strategy = strategy;
    this->ExpectThatSweepsChangeWhatTheyCross();
  }
}

// Motion stays what it was found to be, so the whole merge is that of the plan alone.
TEST_F(ArrivingSweeps, AlongTheMotionThatWasFoundBefore)
{
  LiveSeries series(options, {});
  series.Put({Input(keax, start), Input(klsx, start + 1min), Input(keax, start + 6min, 3)});
  series.KeepGrid();
  PlannedMerge before = series.Plan(start + 12min);
  GriddedVolume volume = MakeWhole(before);
  series.Put({Input(keax, start + 6min)});
  PlannedMerge after = series.PlanAgain(before);
  EXPECT_GT(Replace(before, after, volume).voxels, 100U);
  ExpectSame(volume, MakeWhole(after));
}

// A radar that comes changes what it sees, unless ancillary arrays number the radars.
TEST_F(ArrivingSweeps, OfAFurtherRadar)
{
  options.interpolation = TimeInterpolationMethod::Linear;
  for (const bool ancillary : {false, true})
  {
    options.beam.ancillary = ancillary;
    LiveSeries series(options, {});
    series.Put({Input(klsx, start + 1min)});
    series.KeepGrid();
    PlannedMerge before = series.Plan(start + 12min);
    GriddedVolume volume = MakeWhole(before);
    series.Put({Input(keax, start)});
    PlannedMerge after = series.PlanAgain(before);
    EXPECT_EQ(after.KeepsVoxelsOf(before), !ancillary);
    if (!ancillary)
    {
      EXPECT_GT(Replace(before, after, volume).voxels, 100U);
      ExpectSame(volume, MakeWhole(after));
      EXPECT_EQ(after.Describe().sites, (std::vector<std::string>{"KEAX", "KLSX"}));
    }
  }
}
