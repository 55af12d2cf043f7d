// SPDX-License-Identifier: BSD-3-Clause
// Boxes that follow the echo in them, against the known motion of synthetic storms.
#include "nexrad/Merging/SeriesMerger.h"

#include "Scans/SyntheticScans.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Simulation/StormField.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

namespace nexrad
{
namespace
{

using namespace std::chrono_literals;

const Time evening = *ParseIso8601("2006-03-12T18:00:00Z");

double SecondsOfDay(Time time)
{
  return std::chrono::duration<double>(time - evening).count() + 18.0 * 3600.0;
}

// Where a storm of the synthetic day is, x and y of a grid.
std::array<double, 2> PlaceOf(const StormLife& storm, Time time, const GridSpecification& grid)
{
  constexpr double perDegree = 6'371'000.0 * 3.14159265358979323846 / 180.0; // of StormPlane
  const double seconds = SecondsOfDay(time) - storm.middleTime;
  const double x = storm.x + storm.east * seconds;
  const double y = storm.y + storm.north * seconds;
  const double narrowing = std::cos(39.0 * 3.14159265358979323846 / 180.0);
  return grid.FromGeographic(-91.5 + x / perDegree / narrowing, 39.0 + y / perDegree);
}

// The supercells that live over all of half an hour, within a distance of a grid's centre.
std::vector<StormLife> SupercellsNear(const GridSpecification& grid, double within)
{
  std::vector<StormLife> near;
  for (const StormLife& storm : MakeStormDay(1))
  {
    const double age = SecondsOfDay(evening + 30min) - storm.middleTime;
    const auto [x, y] = PlaceOf(storm, evening + 30min, grid);
    if (storm.kind == StormKind::Supercell && std::abs(age) < 0.5 * storm.lifetime - 2400.0 &&
        std::hypot(x, y) < within)
    {
      near.push_back(storm);
    }
  }
  return near;
}

std::array<double, 2> MiddleOf(const GriddedVolume& box)
{
  std::array<double, 2> middle{};
  for (const int axis : {0, 1})
  {
    middle[axis] =
      box.grid.Coordinate(axis, 0) + 0.5 * box.grid.spacing[axis] * (box.grid.dimensions[axis] - 1);
  }
  return middle;
}

std::unique_ptr<SeriesMerger> Open(const std::filesystem::path& folder, MergeOptions options = {})
{
  options.grid.dimensions = {128, 128, 64};
  MergerSetup setup;
  setup.loop = ThreadLoop(2);
  setup.threads = 2;
  setup.anyOrder = true;
  auto merger =
    std::make_unique<SeriesMerger>(std::vector<std::filesystem::path>{folder}, options, setup);
  merger->Open();
  return merger;
}

// 40 km about a storm, which it follows from 18:10 on.
BoxRequest BoxAbout(const StormLife& storm, const GridSpecification& grid)
{
  const auto [x, y] = PlaceOf(storm, evening + 10min, grid);
  BoxRequest box{{x - 20e3, x + 20e3, y - 20e3, y + 20e3}};
  box.followedFrom = evening + 10min;
  return box;
}

double Distance(const std::array<double, 2>& a, const std::array<double, 2>& b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

// On an hour of one radar of the synthetic day.
class FollowingBoxes : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    folder = std::make_unique<testing::TemporaryFolder>();
    testing::WriteSyntheticScans(folder->Path(), "KEAX", evening, 60min);
  }
  static void TearDownTestSuite() { folder.reset(); }

  static std::unique_ptr<testing::TemporaryFolder> folder;
};
std::unique_ptr<testing::TemporaryFolder> FollowingBoxes::folder;

} // namespace

TEST_F(FollowingBoxes, KeepTheirStormInTheMiddle)
{
  const std::unique_ptr<SeriesMerger> merger = Open(folder->Path());
  const std::vector<StormLife> storms = SupercellsNear(merger->Grid(), 180e3);
  EXPECT_EQ(storms.size(), 3U);
  double farthest = 0.0;
  for (const StormLife& storm : storms)
  {
    const BoxRequest box = BoxAbout(storm, merger->Grid());
    for (const Duration after : {10min, 20min, 30min, 40min})
    {
      const Time time = evening + 10min + after;
      const auto middle = MiddleOf(*merger->MergeBox(time, box));
      farthest = std::max(farthest, Distance(middle, PlaceOf(storm, time, merger->Grid())));
    }
    BoxRequest still = box;
    still.followedFrom.reset();
    const auto middle = MiddleOf(*merger->MergeBox(evening + 50min, still));
    EXPECT_AT_MOST(Distance(middle, PlaceOf(storm, evening + 10min, merger->Grid())), 180.0,
      "distance of a box that follows nothing from where it was made, m");
  }
  EXPECT_AT_MOST(farthest, 2800.0,
    "distance of a following box from its storm, which goes 40 to 49 km in 40 minutes, m");
}

TEST_F(FollowingBoxes, HaveOnePlaceForEachTime)
{
  const auto placeBy = [&](const std::vector<Duration>& times)
  {
    const std::unique_ptr<SeriesMerger> merger = Open(folder->Path());
    const BoxRequest box = BoxAbout(SupercellsNear(merger->Grid(), 180e3).front(), merger->Grid());
    std::array<double, 2> last{};
    for (const Duration time : times)
    {
      merger->Merge(evening + time);
      last = MiddleOf(*merger->MergeBox(evening + time, box));
    }
    return last;
  };
  const auto jumped = placeBy({40min});
  EXPECT_EQ(placeBy({10min, 15min, 20min, 25min, 30min, 35min, 40min}), jumped);
  EXPECT_EQ(placeBy({50min, 45min, 5min, 40min}), jumped);
}

TEST_F(FollowingBoxes, FollowReflectivityWhateverTheirMoment)
{
  MergeOptions velocity;
  velocity.moments = {MomentName::VEL};
  const std::unique_ptr<SeriesMerger> ofVelocity = Open(folder->Path(), velocity);
  const std::unique_ptr<SeriesMerger> merger = Open(folder->Path());
  const BoxRequest box = BoxAbout(SupercellsNear(merger->Grid(), 180e3).front(), merger->Grid());
  const GriddedVolume moved = *ofVelocity->MergeBox(evening + 25min, box);
  EXPECT_EQ(moved.moment, MomentName::VEL);
  EXPECT_EQ(MiddleOf(moved), MiddleOf(*merger->MergeBox(evening + 25min, box)));
}

TEST_F(FollowingBoxes, StopWhenTheyAreAskedTo)
{
  const std::unique_ptr<SeriesMerger> merger = Open(folder->Path());
  const BoxRequest box = BoxAbout(SupercellsNear(merger->Grid(), 180e3).front(), merger->Grid());
  int calls = 0;
  EXPECT_FALSE(merger->MergeBox(evening + 50min, box, [&](double) { return ++calls < 3; }));
  EXPECT_EQ(calls, 3);
}

namespace
{

// The strongest echo of each column, dBZ; 0 without echo.
std::vector<double> ColumnMaxima(const GriddedVolume& volume)
{
  const auto columns = static_cast<std::size_t>(volume.grid.dimensions[0]) *
                       static_cast<std::size_t>(volume.grid.dimensions[1]);
  std::vector<double> maxima(columns, 0.0);
  for (std::size_t voxel = 0; voxel < volume.values.size(); ++voxel)
  {
    if (volume.states[voxel] == VoxelState::Echo)
    {
      double& most = maxima[voxel % columns];
      most = std::max(most, static_cast<double>(volume.values[voxel]));
    }
  }
  return maxima;
}

double Correlation(const std::vector<double>& a, const std::vector<double>& b)
{
  const auto count = static_cast<double>(a.size());
  const double meanA = std::accumulate(a.begin(), a.end(), 0.0) / count;
  const double meanB = std::accumulate(b.begin(), b.end(), 0.0) / count;
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    ab += (a[i] - meanA) * (b[i] - meanB);
    aa += (a[i] - meanA) * (a[i] - meanA);
    bb += (b[i] - meanB) * (b[i] - meanB);
  }
  return ab / std::sqrt(aa * bb);
}

} // namespace

// The storm north of KBGM on 2005-08-21, in 20 minutes.
TEST(MergedBoxes, ThatFollowARealStormHoldTheSameEcho)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::unique_ptr<SeriesMerger> merger = Open(data / "level2/run-kbgm-20050821");
  const Time from = *ParseIso8601("2005-08-21T02:46:00Z");
  const BoxRequest still{{-30e3, 60e3, 90e3, 150e3}};
  BoxRequest followed = still;
  followed.followedFrom = from;
  const std::vector<double> first = ColumnMaxima(*merger->MergeBox(from, still));
  const auto correlation = [&](const BoxRequest& box)
  { return Correlation(first, ColumnMaxima(*merger->MergeBox(from + 20min, box))); };
  EXPECT_AT_LEAST(correlation(followed), 0.7,
    "correlation of the echo of a following box with that of 20 minutes before");
  EXPECT_AT_MOST(correlation(still), 0.4,
    "correlation of the echo of a box on the ground with that of 20 minutes before");
}

namespace
{

GridSpecification Domain()
{
  GridSpecification domain;
  domain.dimensions = {200, 200, 40};
  domain.spacing = {1000.0, 1000.0, 500.0};
  domain.origin = {-99'500.0, -99'500.0, 250.0};
  return domain;
}

std::optional<BeamVolumes> NoEcho(Time, const Progress&)
{
  return BeamVolumes();
}

} // namespace

TEST(BoxFollower, MovesWithAGivenMotionAndStaysInTheDomain)
{
  BoxFollower follower(Domain(), BeamModel(), {}, Velocity{10.0, -5.0}, NoEcho);
  BoxRequest box{{0.0, 40'000.0, -20'000.0, 20'000.0}};
  EXPECT_EQ(follower.WayTo(evening, box), (std::array<double, 2>{0.0, 0.0}));
  box.followedFrom = evening;
  const auto expectNear = [&](Duration after, double east, double north)
  {
    const std::array<double, 2> way = *follower.WayTo(evening + after, box);
    EXPECT_NEAR(way[0], east, 1e-6);
    EXPECT_NEAR(way[1], north, 1e-6);
  };
  expectNear(90s, 900.0, -450.0);
  expectNear(20min, 12'000.0, -6'000.0);
  expectNear(-10min, -6'000.0, 3'000.0);
  expectNear(4h, 60'000.0, -72'000.0);
  expectNear(10h, 60'000.0, -80'000.0);
}

TEST(BoxFollower, MovesOnGeographicAxesInDegrees)
{
  GridSpecification domain = Domain();
  domain.axes = GridAxes::Geographic;
  domain.origin = {-95.0, 35.0, 250.0};
  domain.spacing = {0.02, 0.02, 500.0};
  BoxFollower follower(domain, BeamModel(), {}, Velocity{10.0, 20.0}, NoEcho);
  BoxRequest box{{-94.0, -93.5, 36.0, 36.5}};
  box.followedFrom = evening;
  const std::array<double, 2> way = *follower.WayTo(evening + 1min, box);
  EXPECT_NEAR(way[0], 600.0 / (111'195.0 * std::cos(36.25 * 3.14159265358979323846 / 180.0)), 1e-6);
  EXPECT_NEAR(way[1], 1200.0 / 111'195.0, 1e-6);
}

TEST(BoxFollower, StaysWhereNoMotionIsKnown)
{
  BoxFollower follower(Domain(), BeamModel(), {}, std::nullopt, NoEcho);
  BoxRequest box{{0.0, 40'000.0, -20'000.0, 20'000.0}};
  box.followedFrom = evening;
  EXPECT_EQ(follower.WayTo(evening + 30min, box), (std::array<double, 2>{0.0, 0.0}));
}

} // namespace nexrad
