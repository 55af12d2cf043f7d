// SPDX-License-Identifier: BSD-3-Clause
// Dealiased velocities and derived moments through the program.
#include "DirectMerge.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Moments/MomentMaker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

ProgramRun Grid(const fs::path& file, const fs::path& output, std::vector<std::string> options)
{
  std::vector<std::string> arguments = {
    "grid", file, "-o", output, "--dims", "96x96x24", "--quiet"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return RunNexrad3d(arguments);
}

// Least and largest value of the echoes.
struct ValueRange
{
  double least = 1e9;
  double most = -1e9;
  std::size_t echoes = 0;
};

ValueRange RangeOf(const GriddedVolume& volume)
{
  ValueRange range;
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    if (volume.states[i] == VoxelState::Echo)
    {
      range.least = std::min(range.least, static_cast<double>(volume.values[i]));
      range.most = std::max(range.most, static_cast<double>(volume.values[i]));
      ++range.echoes;
    }
  }
  return range;
}

} // namespace

// A file of dual polarisation with storms: each derived moment has values that the atmosphere can
// have.
TEST(DerivedMoments, AreWrittenByGrid)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path file = data / "level2/superres/KTLX20190715_120037_V06";
  const ProgramRun run =
    Grid(file, folder.Path() / "v", {"--moment", "SRV,AZSHEAR,DIV,KDP", "--range", "120km"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto range = [&folder](MomentName moment)
  { return RangeOf(ReadOnlyVolume(folder.Path() / "v", moment)); };
  const ValueRange relative = range(MomentName::SRV);
  EXPECT_GT(relative.echoes, 5'000U);
  EXPECT_LT(relative.least, -10.0);
  EXPECT_GT(relative.most, 10.0);
  EXPECT_LT(std::max(relative.most, -relative.least), 80.0);
  for (const MomentName moment : {MomentName::AZSHEAR, MomentName::DIV})
  {
    const ValueRange derivative = range(moment);
    EXPECT_GT(derivative.echoes, 5'000U);
    EXPECT_LT(derivative.least, -0.002) << ToString(moment);
    EXPECT_GT(derivative.most, 0.002) << ToString(moment);
    EXPECT_LT(std::max(derivative.most, -derivative.least), 0.1) << ToString(moment);
  }
  const ValueRange phase = range(MomentName::KDP);
  EXPECT_AT_LEAST(phase.echoes, 1'100U, "voxels of K_DP");
  EXPECT_GT(phase.most, 0.5);
  EXPECT_AT_MOST(phase.most, 10.0, "largest merged K_DP of KTLX 2019-07-15, degrees/km");
  EXPECT_AT_LEAST(phase.least, -15.0, "least merged K_DP of KTLX 2019-07-15, degrees/km");
}

// Bit for bit what the words of the file give.
TEST(DealiasedGrid, CanBeLeftOut)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path file = data / "level2/legacy/KTLX19990503_235621.gz";
  ASSERT_EQ(Grid(file, folder.Path() / "folded",
              {"--moment", "VEL", "--no-dealiasing", "--code", "exact", "--range", "120km"})
              .status,
    0);
  ASSERT_EQ(Grid(file, folder.Path() / "unfolded",
              {"--moment", "VEL", "--code", "exact", "--range", "120km"})
              .status,
    0);
  const GriddedVolume folded = ReadOnlyVolume(folder.Path() / "folded", MomentName::VEL);
  const GriddedVolume unfolded = ReadOnlyVolume(folder.Path() / "unfolded", MomentName::VEL);

  const RadarVolume volume = ReadLevel2(file);
  const PolarVolume words = MakePolarVolume(volume, MomentName::VEL);
  MergeRequest request;
  request.grid = folded.grid;
  request.time = folded.time;
  const std::optional<GriddedVolume> expected = nexrad::testing::MergeDirectly({&words}, request);
  EXPECT_TRUE(folded.values == expected->values);
  EXPECT_TRUE(folded.states == expected->states);
  EXPECT_LT(RangeOf(folded).most, 33.0); // the largest Nyquist velocity
  EXPECT_AT_LEAST(RangeOf(unfolded).most, 40.0, "fastest merged velocity of 1999-05-03, m/s");
}

TEST(DerivedMoments, SayWhatIsWrongInOneLine)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path file = data / "level2/legacy/KTLX19990503_235621.gz";
  const ProgramRun unknown = Grid(file, folder.Path() / "a", {"--moment", "SHEAR"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.errors.find("SRV, AZSHEAR, DIV or KDP"), std::string::npos) << unknown.errors;
  const ProgramRun lacking = Grid(file, folder.Path() / "b", {"--moment", "KDP"});
  EXPECT_EQ(lacking.status, 1);
  EXPECT_NE(lacking.errors.find("no ray has KDP"), std::string::npos) << lacking.errors;
  const ProgramRun motion =
    Grid(file, folder.Path() / "c", {"--moment", "SRV", "--storm-motion", "fast"});
  EXPECT_EQ(motion.status, 2);
  EXPECT_NE(motion.errors.find("--storm-motion"), std::string::npos) << motion.errors;
  EXPECT_NE(motion.errors.find("east"), std::string::npos) << motion.errors;
  const ProgramRun overlap =
    Grid(file, folder.Path() / "d", {"--moment", "AZSHEAR", "--overlap", "mean"});
  EXPECT_EQ(overlap.status, 2);
  EXPECT_NE(overlap.errors.find("largest value"), std::string::npos) << overlap.errors;
}

// The velocity relative to a motion differs from the velocity by the motion's radial component.
TEST(DerivedMoments, TakeTheMotionThatIsGiven)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path file = data / "level2/legacy/KTLX19990503_235621.gz";
  for (const char* motion : {"0,0", "100,0"})
  {
    ASSERT_EQ(Grid(file, folder.Path() / motion,
                {"--moment", "SRV", "--storm-motion", motion, "--range", "120km"})
                .status,
      0);
  }
  const GriddedVolume still = ReadOnlyVolume(folder.Path() / "0,0", MomentName::SRV);
  const GriddedVolume moving = ReadOnlyVolume(folder.Path() / "100,0", MomentName::SRV);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < still.values.size(); ++i)
  {
    const auto x = static_cast<int>(i % 96);
    const auto y = static_cast<int>(i / 96 % 96);
    const double east = still.grid.Coordinate(0, x); // the grid's centre is the radar
    const double north = still.grid.Coordinate(1, y);
    if (still.states[i] == VoxelState::Echo && std::hypot(east, north) > 60'000.0)
    {
      const double radial = 100.0 * east / std::hypot(east, north);
      EXPECT_NEAR(static_cast<double>(still.values[i] - moving.values[i]), radial, 4.0);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1'000U);
}
