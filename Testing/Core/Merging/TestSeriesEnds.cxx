// SPDX-License-Identifier: BSD-3-Clause
// Formulas A3a, A2a: in the first and the last minutes of a series, where motion is known on one
// side alone, echo moves as in the others, and its amount does not pulse. A table of the minutes of
// a real run is printed.
#include "DirectMerge.h"
#include "Motion/VolumeMotion.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Series/VolumeSelection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

using namespace nexrad;
using namespace std::chrono_literals;

namespace
{

std::vector<PolarVolume> ReadRun(const std::filesystem::path& folder)
{
  std::vector<PolarVolume> volumes;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
  {
    volumes.push_back(MakePolarVolume(ReadLevel2(entry.path()), MomentName::REF));
  }
  return volumes;
}

std::vector<GriddedVolume> MergeMinutes(const std::vector<PolarVolume>& volumes)
{
  std::vector<const PolarVolume*> pointers;
  Time first = Time::max();
  Time last = Time::min();
  for (const PolarVolume& volume : volumes)
  {
    pointers.push_back(&volume);
    first = std::min(first, volume.start);
    last = std::max(last, volume.end);
  }
  GridRequest grid;
  grid.dimensions = {192, 192, 16};
  MergeRequest request;
  request.grid = MakeGrid(grid, {volumes.front().site.position.value()});
  nexrad::testing::DirectRun run;
  std::vector<GriddedVolume> minutes;
  for (const Time time : TimeSteps(first, last, 1min))
  {
    request.time = time;
    minutes.push_back(nexrad::testing::MergeDirectly(pointers, request, {}, &run).value());
  }
  return minutes;
}

// Voxels of 20 dBZ or more.
double CountEcho(const GriddedVolume& volume)
{
  double count = 0.0;
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const bool echo = volume.states[i] == VoxelState::Echo && volume.values[i] >= 20.0F;
    count += echo ? 1.0 : 0.0;
  }
  return count;
}

// One motion for the whole picture: from the column maxima of two minutes, m/s.
Velocity MotionBetween(const GriddedVolume& before, const GriddedVolume& after)
{
  MotionOptions options;
  options.spacing = 1e6;
  const MotionField motion = EstimateMotion(before, after, options);
  return motion.At(0.5 * before.grid.dimensions[0], 0.5 * before.grid.dimensions[1]);
}

struct Minute
{
  Time time;
  double echo = 0.0;   // voxels of 20 dBZ or more
  double growth = 0.0; // of them, from this minute to the next, as a part
  double along = 0.0;  // m/s, motion to the next minute in the direction of the mean motion
};

std::vector<Minute> Measure(const std::vector<GriddedVolume>& volumes)
{
  const Velocity mean = MotionBetween(volumes.front(), volumes.back());
  const double speed = std::hypot(mean.east, mean.north);
  std::vector<Minute> minutes;
  for (std::size_t i = 0; i + 1 < volumes.size(); ++i)
  {
    const double echo = CountEcho(volumes[i]);
    const Velocity motion = MotionBetween(volumes[i], volumes[i + 1]);
    minutes.push_back({volumes[i].time, echo, CountEcho(volumes[i + 1]) / echo - 1.0,
      (motion.east * mean.east + motion.north * mean.north) / speed});
    std::printf("%s  %8.0f voxels  %+6.2f %%  %5.2f m/s\n",
      FormatIso8601(minutes.back().time).c_str(), echo, 100.0 * minutes.back().growth,
      minutes.back().along);
  }
  std::printf("from the first to the last minute: %.2f m/s\n", speed);
  return minutes;
}

double MedianSpeed(const std::vector<Minute>& minutes)
{
  std::vector<double> speeds;
  for (const Minute& minute : minutes)
  {
    speeds.push_back(minute.along);
  }
  std::sort(speeds.begin(), speeds.end());
  return speeds[speeds.size() / 2];
}

} // namespace

TEST(SeriesEnds, ARealRunMovesInItsFirstAndLastMinutes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const std::vector<PolarVolume> volumes = ReadRun(data / "level2" / "run-kbgm-20050821");
  ASSERT_EQ(volumes.size(), 5u);
  const std::vector<Minute> minutes = Measure(MergeMinutes(volumes));
  ASSERT_EQ(minutes.size(), 28u); // from 02:44 to 03:12
  const double median = MedianSpeed(minutes);
  for (const Minute& minute : minutes)
  {
    EXPECT_WITHIN(minute.along / median, 1.0, 0.1, "speed in a minute, part of the median")
      << FormatIso8601(minute.time);
    EXPECT_AT_MOST(std::abs(minute.growth), 0.03, "growth of the echo in a minute, part of it")
      << FormatIso8601(minute.time);
  }
}
