// SPDX-License-Identifier: BSD-3-Clause
// Files in which the antenna was not at its cut, scanned a sector, or scanned in elevation, from
// their bytes to the merged volume (Formulas Q7).
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Encoding/Level2Encoder.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Merging/SeriesMerger.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/RadarSimulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr std::size_t sixth = 5; // index of a sweep of pattern 21, at 3.3 degrees

// A SYNTHETIC volume of KLSX, scanned once for all tests of the program.
const RadarVolume& Scanned()
{
  static const RadarVolume volume = ScanVolume(StormField(1),
    Site{"KLSX", FindSite("KLSX")->position}, 21, *ParseIso8601("2006-03-12T18:00:00Z"));
  return volume;
}

// What a merge makes of a file, and what it says of it.
struct Outcome
{
  GriddedVolume merged;
  std::vector<InputProblem> problems;
  std::vector<std::string> notes;
};

Outcome MergeFile(const std::filesystem::path& path)
{
  MergeOptions options;
  options.grid.dimensions = {60, 60, 20};
  options.grid.range = 150'000.0;
  options.quality.level = QualityLevel::Off; // it judges echo by what is connected with it
  SeriesMerger merger({path}, options);
  merger.Open();
  Outcome outcome;
  outcome.merged = *merger.Merge(merger.Times().front());
  outcome.problems = merger.Problems();
  outcome.notes = merger.Notes();
  return outcome;
}

Outcome MergeAsFile(const RadarVolume& volume)
{
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.Path() / "KLSX20060312_180000";
  const std::vector<std::uint8_t> bytes = EncodeLevel2(volume);
  std::ofstream(path, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return MergeFile(path);
}

// The one note on a file in which nothing is wrong, without the file's name.
std::string NoteOf(const Outcome& outcome)
{
  EXPECT_TRUE(outcome.problems.empty());
  EXPECT_EQ(outcome.notes.size(), 1U);
  const std::string note = outcome.notes.empty() ? "" : outcome.notes.front();
  return note.substr(std::min(note.size(), note.find(": ") + 2));
}

void ExpectSame(const GriddedVolume& merged, const GriddedVolume& expected)
{
  EXPECT_TRUE(merged.states == expected.states);
  EXPECT_TRUE(merged.values == expected.values);
  EXPECT_GT(std::count(merged.states.begin(), merged.states.end(), VoxelState::Echo), 500);
}

// Azimuth of a column of a grid about its centre, degrees, and the angle of a voxel's diagonal
// there.
struct Direction
{
  double azimuth;
  double width;
};

Direction DirectionOf(const GriddedVolume& volume, std::size_t index)
{
  const double x = volume.grid.Coordinate(0, static_cast<int>(index % 60));
  const double y = volume.grid.Coordinate(1, static_cast<int>(index / 60 % 60));
  const double degrees = 180.0 / 3.14159265358979323846;
  const double diagonal = std::hypot(volume.grid.spacing[0], volume.grid.spacing[1]);
  return {std::fmod(degrees * std::atan2(x, y) + 360.0, 360.0),
    degrees * std::atan(diagonal / std::hypot(x, y))};
}

// Degrees from a direction to a sector that goes clockwise from one azimuth to another.
double DistanceFrom(double azimuth, double first, double last)
{
  const auto clockwise = [](double from, double to) { return std::fmod(to - from + 720.0, 360.0); };
  return clockwise(first, azimuth) <= clockwise(first, last)
           ? 0.0
           : std::min(clockwise(azimuth, first), clockwise(last, azimuth));
}

// Expects that nothing that was scanned is hidden in a volume, and that it differs from another one
// in a sector, clockwise from `first` to `last`. Elsewhere at most `most` percent may differ:
// layers of echo (G12) are looked for in echo that is connected.
void ExpectSameOutside(
  const GriddedVolume& merged, const GriddedVolume& expected, float first, float last, double most)
{
  std::size_t inside = 0;
  std::size_t outside = 0;
  for (std::size_t i = 0; i < expected.states.size(); ++i)
  {
    EXPECT_TRUE(
      merged.states[i] != VoxelState::NotScanned || expected.states[i] == VoxelState::NotScanned);
    if (merged.states[i] != expected.states[i] || merged.values[i] != expected.values[i])
    {
      const Direction direction = DirectionOf(expected, i);
      const double distance =
        DistanceFrom(direction.azimuth, static_cast<double>(first), static_cast<double>(last));
      (distance < 2.0 + direction.width ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 0U);
  const std::size_t echoes = static_cast<std::size_t>(
    std::count(expected.states.begin(), expected.states.end(), VoxelState::Echo));
  EXPECT_AT_MOST(100.0 * static_cast<double>(outside) / static_cast<double>(echoes), most,
    "voxels that differ where no ray strays, percent of those with echo");
}

std::size_t CountScanned(const GriddedVolume& volume)
{
  return volume.states.size() - static_cast<std::size_t>(std::count(volume.states.begin(),
                                  volume.states.end(), VoxelState::NotScanned));
}

} // namespace

TEST(StrayScans, OfNoneNothingIsSaid)
{
  const Outcome outcome = MergeAsFile(Scanned());
  EXPECT_TRUE(outcome.problems.empty());
  EXPECT_TRUE(outcome.notes.empty());
}

TEST(StrayScans, ARayAtAWrongElevationIsLeftOut)
{
  RadarVolume volume = Scanned();
  volume.sweeps[sixth].rays[100].elevation = 11.0F;
  const Outcome outcome = MergeAsFile(volume);
  EXPECT_EQ(NoteOf(outcome), "the merge leaves out 1 ray of 1 sweep, farther from the elevation of "
                             "the sweep than half a beam width");
  const float azimuth = volume.sweeps[sixth].rays[100].azimuth;
  ExpectSameOutside(outcome.merged, MergeAsFile(Scanned()).merged, azimuth, azimuth, 0.7);
}

// The antenna rises while it turns: the last 40 rays of the cut come out too high.
TEST(StrayScans, OfADriftingCutTheRaysOfTheCutStay)
{
  RadarVolume volume = Scanned();
  std::vector<Ray>& rays = volume.sweeps[sixth].rays;
  const std::size_t first = rays.size() - 40;
  for (std::size_t ray = first; ray < rays.size(); ++ray)
  {
    rays[ray].elevation += 0.55F + 0.05F * static_cast<float>(ray - first);
  }
  const Outcome outcome = MergeAsFile(volume);
  EXPECT_EQ(NoteOf(outcome), "the merge leaves out 40 rays of 1 sweep, farther from the elevation "
                             "of the sweep than half a beam width");
  ExpectSameOutside(
    outcome.merged, MergeAsFile(Scanned()).merged, rays[first].azimuth, rays.back().azimuth, 2.4);
}

// From 3 to 10 degrees over the whole turn: the cut has no elevation.
TEST(StrayScans, ACutThatDriftsThroughoutIsLeftOut)
{
  RadarVolume volume = Scanned();
  std::vector<Ray>& rays = volume.sweeps[sixth].rays;
  for (std::size_t ray = 0; ray < rays.size(); ++ray)
  {
    rays[ray].elevation = 3.0F + 7.0F * static_cast<float>(ray) / static_cast<float>(rays.size());
  }
  const Outcome outcome = MergeAsFile(volume);
  EXPECT_EQ(NoteOf(outcome), "the merge leaves out 1 sweep without an elevation, because most rays "
                             "are that far from their median");
  RadarVolume without = Scanned();
  without.sweeps.erase(without.sweeps.begin() + sixth);
  ExpectSame(outcome.merged, MergeAsFile(without).merged);
}

// A scan up and down at one azimuth (range-height indicator) in place of a cut.
TEST(StrayScans, AScanInElevationIsLeftOut)
{
  RadarVolume volume = Scanned();
  std::vector<Ray>& rays = volume.sweeps[sixth].rays;
  for (std::size_t ray = 0; ray < rays.size(); ++ray)
  {
    rays[ray].azimuth = 90.0F;
    rays[ray].elevation = 0.5F + 40.0F * static_cast<float>(ray) / static_cast<float>(rays.size());
  }
  const Outcome outcome = MergeAsFile(volume);
  ASSERT_EQ(outcome.notes.size(), 1U);
  EXPECT_NE(outcome.notes.front().find("1 sweep without an elevation"), std::string::npos)
    << outcome.notes.front();
  RadarVolume without = Scanned();
  without.sweeps.erase(without.sweeps.begin() + sixth);
  ExpectSame(outcome.merged, MergeAsFile(without).merged);
}

// A quarter of every cut: merged as what it is, and what lies beside it is not scanned.
TEST(StrayScans, ASectorIsMergedAsItIs)
{
  RadarVolume volume = Scanned();
  for (Sweep& sweep : volume.sweeps)
  {
    std::vector<Ray>& rays = sweep.rays;
    rays.erase(std::remove_if(rays.begin(), rays.end(),
                 [](const Ray& ray) { return ray.azimuth < 90.0F || ray.azimuth > 180.0F; }),
      rays.end());
  }
  const GriddedVolume whole = MergeAsFile(Scanned()).merged;
  const Outcome outcome = MergeAsFile(volume);
  EXPECT_TRUE(outcome.notes.empty());
  const GriddedVolume& sector = outcome.merged;
  EXPECT_WITHIN(
    static_cast<double>(CountScanned(sector)) / static_cast<double>(CountScanned(whole)), 0.25,
    0.0005, "share of the scanned voxels that a quarter of the turn scans");
  for (std::size_t i = 0; i < sector.states.size(); ++i)
  {
    const double x = sector.grid.Coordinate(0, static_cast<int>(i % 60));
    const double y = sector.grid.Coordinate(1, static_cast<int>(i / 60 % 60));
    const bool outside = x < -6'000.0 || y > 6'000.0; // a voxel beside the sector
    EXPECT_TRUE(!outside || sector.states[i] == VoxelState::NotScanned) << i;
  }
}

// A chunk of the real-time feed without those before and after it: a third of one turn.
TEST(StrayScans, ThePiecesOfACutAreMergedAsASector)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::filesystem::path file = data / "level2/chunks/KABR-20240328-stray";
  const Outcome outcome = MergeFile(file);
  EXPECT_TRUE(std::none_of(outcome.problems.begin(), outcome.problems.end(),
    [](const InputProblem& problem) { return problem.leftOut; }));
  EXPECT_TRUE(outcome.notes.empty());
  const RadarVolume volume = ReadLevel2(file);
  ASSERT_EQ(volume.sweeps.size(), 1U);
  const std::vector<Ray>& rays = volume.sweeps[0].rays;
  std::size_t scanned = 0;
  for (std::size_t i = 0; i < outcome.merged.states.size(); ++i)
  {
    const Direction direction = DirectionOf(outcome.merged, i);
    const double distance = DistanceFrom(direction.azimuth,
      static_cast<double>(rays.front().azimuth), static_cast<double>(rays.back().azimuth));
    const bool isScanned = outcome.merged.states[i] != VoxelState::NotScanned;
    EXPECT_TRUE(!isScanned || distance < 1.0 + direction.width) << direction.azimuth;
    scanned += isScanned ? 1 : 0;
  }
  EXPECT_AT_LEAST(scanned, 1'300U, "voxels that 120 rays of one cut scan");
}
