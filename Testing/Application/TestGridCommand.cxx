// SPDX-License-Identifier: BSD-3-Clause
#include "DirectMerge.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Series/InputFiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <sys/resource.h>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

// Three radars of New York at 01:15 UTC, which overlap: the start of a command line.
std::vector<std::string> ThreeRadars(const fs::path& data, const fs::path& output)
{
  std::vector<std::string> arguments = {"grid"};
  for (const char* name :
    {"KBGM20100911_012056_V03.gz", "KENX20100911_011108_V03.gz", "KTYX20100911_012210_V04.gz"})
  {
    arguments.push_back(data / "level2" / "multisite-20100911" / name);
  }
  arguments.insert(
    arguments.end(), {"-o", output, "--begin", "2010-09-11T01:15", "--end", "2010-09-11T01:15",
                       "--bounds", "-77,41,-73,44", "--ancillary", "--quiet"});
  return arguments;
}

// As long as this lives, no file may grow beyond a size: to the program a disk that is full.
class FileSizeLimit
{
public:
  explicit FileSizeLimit(rlim_t bytes)
  {
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit limit = {bytes, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
  rlimit before{};
};

} // namespace

// Five volumes from 02:43:19 to 03:12 UTC; the steps in between are multiples of five minutes.
TEST(GridCommand, OneVolumeForEachStep)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path output = folder.Path() / "made" / "volumes";
  const ProgramRun run = RunNexrad3d(
    {"grid", data / "level2" / "run-kbgm-20050821", "-o", output, "--dims", "64x64x32"});
  EXPECT_EQ(run.status, 0) << run.errors;
  // The antenna settles late in two of the files; that is no damage.
  const std::string input = data / "level2" / "run-kbgm-20050821";
  const char* why = " of 1 sweep, farther from the elevation of the sweep than half a beam width\n";
  EXPECT_EQ(run.errors, input + "/KBGM20050821_024323.gz: the merge leaves out 16 rays" + why +
                          input + "/KBGM20050821_030635.gz: the merge leaves out 10 rays" + why);
  const std::set<std::string> expected = {"20050821T024500Z.nxv", "20050821T025000Z.nxv",
    "20050821T025500Z.nxv", "20050821T030000Z.nxv", "20050821T030500Z.nxv", "20050821T031000Z.nxv",
    "volumes.nxv.series"};
  EXPECT_EQ(NamesIn(output), expected);

  const NxvSeries series = ReadNxvSeries(output / "volumes.nxv.series");
  ASSERT_EQ(series.size(), 6U);
  EXPECT_EQ(series[2].first, "20050821T025500Z.nxv");
  EXPECT_EQ(FromSeconds(series[2].second), *ParseIso8601("2005-08-21T02:55"));

  const GriddedVolume volume = ReadNxv(output / series[2].first);
  EXPECT_EQ(volume.time, *ParseIso8601("2005-08-21T02:55"));
  EXPECT_EQ(volume.grid.dimensions, (std::array<int, 3>{64, 64, 32}));
  EXPECT_EQ(volume.sites, std::vector<std::string>{"KBGM"});
  EXPECT_EQ(volume.method, "beam");
  EXPECT_FALSE(volume.synthetic);
  // The radar stands at 42.20° N, 75.98° W; the box of 460 km lies about it.
  EXPECT_NEAR(volume.grid.centreLatitude, 42.20, 1e-9);
  EXPECT_NEAR(volume.grid.centreLongitude, -75.98, 1e-9);
  EXPECT_WITHIN(volume.grid.spacing[0] * 64, 460e3, 4.0, "width of the grid, m");
  EXPECT_NEAR(volume.grid.spacing[2], 625.0, 1e-9);
}

// A file that is decoded before the grid is known has no other voxels than one decoded after it,
// and both those of a merge that has all files first. 0.25 dBZ is half a step of the code.
TEST(GridCommand, StreamedVolumesAreThoseOfAScannedSeries)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path files = data / "level2" / "run-kbgm-20050821";
  ASSERT_EQ(
    RunNexrad3d({"grid", files, "-o", folder.Path(), "--dims", "64x64x32", "--quiet"}).status, 0);
  MergeOptions options;
  options.grid.dimensions = {64, 64, 32};
  const DirectMerge direct({files}, options);
  for (const auto& [name, time] : ReadNxvSeries(folder.Path() / "volumes.nxv.series"))
  {
    const GriddedVolume streamed = ReadNxv(folder.Path() / name);
    const GriddedVolume scanned = direct.At(streamed.time);
    ASSERT_EQ(streamed.states, scanned.states) << name;
    float farthest = 0.0F;
    for (std::size_t i = 0; i < scanned.values.size(); ++i)
    {
      const bool echo = scanned.states[i] == VoxelState::Echo;
      farthest = std::max(farthest, echo ? std::abs(streamed.values[i] - scanned.values[i]) : 0.0F);
    }
    EXPECT_LT(farthest, 0.2501F) << name;
  }
}

TEST(GridCommand, OptionsReachTheVolumes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run = RunNexrad3d({"grid", data / "level2" / "run-kbgm-20050821", "-o",
    folder.Path(), "--dims", "20x10x5", "--bounds", "-77,41,-75,43", "--height", "1,11km",
    "--begin", "2005-08-21T02:55", "--end", "2005-08-21T02:57", "--step", "60s", "--quiet"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output, "");
  const std::set<std::string> expected = {
    "20050821T025500Z.nxv", "20050821T025600Z.nxv", "20050821T025700Z.nxv", "volumes.nxv.series"};
  EXPECT_EQ(NamesIn(folder.Path()), expected);
  const GriddedVolume volume = ReadNxv(folder.Path() / "20050821T025600Z.nxv");
  EXPECT_EQ(volume.grid.dimensions, (std::array<int, 3>{20, 10, 5}));
  EXPECT_NEAR(volume.grid.spacing[2], 2'000.0, 1e-9);
  EXPECT_NEAR(volume.grid.origin[2], 2'000.0, 1e-9);
  EXPECT_NEAR(volume.grid.centreLongitude, -76.0, 1e-9);
}

// Voxels of a tenth of a degree, whose faces are whole tenths; echo stands where it does in metres.
TEST(GridCommand, VoxelsOfLongitudeAndLatitude)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto grid = [&](const std::string& axes)
  {
    const ProgramRun run = RunNexrad3d({"grid", data / "level2" / "run-kbgm-20050821", "-o",
      folder.Path() / axes, "--axes", axes, "--dims", "60x40x10", "--bounds", "-79,40,-73,44",
      "--begin", "2005-08-21T02:55", "--end", "2005-08-21T02:55", "--quiet"});
    EXPECT_EQ(run.status, 0) << run.errors;
    return ReadNxv(folder.Path() / axes / "20050821T025500Z.nxv");
  };
  const GriddedVolume degrees = grid("geographic");
  EXPECT_EQ(degrees.grid.axes, GridAxes::Geographic);
  EXPECT_NEAR(degrees.grid.origin[0], -78.95, 1e-9);
  EXPECT_NEAR(degrees.grid.origin[1], 40.05, 1e-9);
  EXPECT_NEAR(degrees.grid.spacing[0], 0.1, 1e-9);
  EXPECT_NEAR(degrees.grid.spacing[1], 0.1, 1e-9);
  const auto middle = [](const GriddedVolume& volume)
  {
    std::array<double, 2> sum = {0.0, 0.0};
    double echoes = 0.0;
    for (std::size_t i = 0; i < volume.states.size(); ++i)
    {
      if (volume.states[i] == VoxelState::Echo)
      {
        const int x = static_cast<int>(i % 60);
        const int y = static_cast<int>(i / 60 % 40);
        const auto place =
          volume.grid.ToGeographic(volume.grid.Coordinate(0, x), volume.grid.Coordinate(1, y));
        sum = {sum[0] + place[0], sum[1] + place[1]};
        ++echoes;
      }
    }
    return std::array{sum[0] / echoes, sum[1] / echoes};
  };
  const auto expected = middle(grid("projected"));
  const auto found = middle(degrees);
  EXPECT_WITHIN(found[0], expected[0], 0.03, "longitude of the echo's middle, degrees");
  EXPECT_WITHIN(found[1], expected[1], 0.03, "latitude of the echo's middle, degrees");
}

TEST(GridCommand, AncillaryArraysOnRequest)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto grid = [&](const std::string& name, const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments = {"grid", data / "level2" / "run-kbgm-20050821", "-o",
      folder.Path() / name, "--dims", "32x32x16", "--begin", "2005-08-21T02:55", "--end",
      "2005-08-21T02:55", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return ReadNxv(folder.Path() / name / "20050821T025500Z.nxv");
  };
  EXPECT_TRUE(grid("plain", {}).ancillary.age.empty());
  const GriddedVolume volume = grid("ancillary", {"--ancillary"});
  const AncillaryArrays& ancillary = volume.ancillary;
  ASSERT_EQ(ancillary.age.size(), volume.values.size());
  std::size_t scanned = 0;
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const bool seen =
      volume.states[i] == VoxelState::Echo || volume.states[i] == VoxelState::NoEcho;
    ASSERT_EQ(ancillary.radars[i], seen ? 1 : 0);
    ASSERT_EQ(ancillary.nearestSite[i], seen ? 0 : AncillaryArrays::NoSite);
    ASSERT_TRUE(seen || ancillary.weight[i] == 0.0F);
    ASSERT_AT_MOST(ancillary.age[i], 300.0F, "largest age, s"); // a volume every 350 s
    scanned += seen;
  }
  EXPECT_AT_LEAST(scanned, 8'000u, "voxels scanned");
}

// One radar has no overlap; that the strategies tell radars apart is BeamNetwork's subject.
TEST(GridCommand, OptionsOfTheOverlapReachTheVolumes)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto grid = [&](const std::string& name, const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments = ThreeRadars(data, folder.Path() / name);
    arguments.insert(arguments.end(), {"--dims", "48x48x16"});
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return ReadNxv(folder.Path() / name / "20100911T011500Z.nxv");
  };
  const GriddedVolume distance = grid("distance", {});
  const GriddedVolume mean = grid("mean", {"--overlap", "mean"});
  const GriddedVolume nearest = grid("nearest", {"--overlap", "nearest"});
  const GriddedVolume maximum = grid("maximum", {"--overlap", "maximum"});
  const GriddedVolume shorter = grid("shorter", {"--overlap-length", "50km"});
  const GriddedVolume filled = grid("filled", {"--fill-columns"});
  const GriddedVolume linear = grid("linear", {"--linear-reflectivity"});
  const GriddedVolume measured = grid("measured", {"--no-sharpening"});
  std::size_t different = 0;
  std::size_t addedByFilling = 0;
  for (std::size_t i = 0; i < distance.values.size(); ++i)
  {
    const auto radars = static_cast<float>(distance.ancillary.radars[i]);
    constexpr float rounding = 0.01F; // of both
    ASSERT_LE(mean.ancillary.weight[i], radars + rounding);
    ASSERT_LE(nearest.ancillary.weight[i], 1.0F);
    ASSERT_LE(shorter.ancillary.weight[i], distance.ancillary.weight[i] + rounding);
    const bool echo =
      maximum.states[i] == VoxelState::Echo && nearest.states[i] == VoxelState::Echo;
    ASSERT_TRUE(!echo || maximum.values[i] >= nearest.values[i]);
    different += mean.values[i] != nearest.values[i];
    addedByFilling +=
      distance.states[i] == VoxelState::NotScanned && filled.states[i] != VoxelState::NotScanned;
  }
  EXPECT_AT_LEAST(different, 1'200u, "voxels that the strategy changes");
  EXPECT_AT_LEAST(addedByFilling, 1'200u, "voxels that filling adds");
  EXPECT_NE(linear.values, distance.values);
  EXPECT_NE(measured.values, distance.values);
  EXPECT_EQ(measured.ancillary.weight, distance.ancillary.weight) << "values alone are sharpened";
}

// VTK takes its way of threading from the environment, and no more threads than there are cores.
TEST(GridCommand, TheFilesDoNotDependOnTheNumberOfThreads)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  std::string first;
  const std::vector<std::pair<const char*, const char*>> ways = {
    {"Sequential", "1"}, {"STDThread", "2"}, {"TBB", "2"}, {"TBB", "7"}};
  for (const auto& [backend, threads] : ways)
  {
    setenv("VTK_SMP_BACKEND_IN_USE", backend, 1);
    setenv("VTK_SMP_MAX_THREADS", threads, 1);
    std::vector<std::string> arguments = ThreeRadars(data, folder.Path() / "v");
    arguments.insert(arguments.end(), {"--dims", "64x64x32"});
    const ProgramRun run = RunNexrad3d(arguments);
    unsetenv("VTK_SMP_BACKEND_IN_USE");
    unsetenv("VTK_SMP_MAX_THREADS");
    ASSERT_EQ(run.status, 0) << run.errors;
    const std::string content = FileContent(folder.Path() / "v" / "20100911T011500Z.nxv");
    first = first.empty() ? content : first;
    EXPECT_TRUE(content == first) << backend << ", " << threads << " threads";
  }
}

TEST(GridCommand, DamageIsNamedAndTheDayStillMade)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run =
    RunNexrad3d({"grid", data / "level2" / "damaged" / "KILN20080107_173809.gz", "-o",
      folder.Path() / "v", "--dims", "16x16x8", "--step", "5s"});
  EXPECT_EQ(run.status, 3) << run.errors;
  EXPECT_NE(run.errors.find("KILN20080107_173809.gz: offset "), std::string::npos) << run.errors;
  EXPECT_TRUE(fs::exists(folder.Path() / "v" / "volumes.nxv.series"));
}

TEST(GridCommand, NoRayAtAllIsAFailureThatSaysWhy)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run = RunNexrad3d({"grid", data / "level2" / "damaged" / "KJKL_20240227_102059",
    "-o", folder.Path() / "v", "--dims", "16x16x8"});
  EXPECT_EQ(run.status, 1) << run.errors;
  EXPECT_NE(run.errors.find("KJKL_20240227_102059: metadata alone"), std::string::npos)
    << run.errors;
  EXPECT_FALSE(fs::exists(folder.Path() / "v"));
}

// Winter clear air, most of it below 0 dBZ.
TEST(GridCommand, VolumesKeepWhatTheRadarMeasured)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto volumeIn = [&](const std::vector<std::string>& code)
  {
    const fs::path output = folder.Path() / (code.empty() ? "default" : code.back());
    std::vector<std::string> arguments = {"grid",
      data / "level2" / "superres" / "KDMX20250101_225441_V06", "-o", output, "--dims", "96x96x32",
      "--end", "2025-01-01T22:55", "--quiet"};
    arguments.insert(arguments.end(), code.begin(), code.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return ReadNxv(output / "20250101T225500Z.nxv");
  };
  const auto echoes = [](const GriddedVolume& volume)
  { return std::count(volume.states.begin(), volume.states.end(), VoxelState::Echo); };
  const GriddedVolume exact = volumeIn({"--code", "exact"});
  const GriddedVolume steps = volumeIn({});
  ASSERT_AT_LEAST(echoes(exact), 400, "voxels of echo");
  EXPECT_EQ(steps.states, exact.states);
  for (std::size_t i = 0; i < exact.values.size(); ++i)
  {
    ASSERT_NEAR(steps.values[i], exact.values[i], 0.2501F) << i;
  }
}

TEST(GridCommand, TimesWithoutAnyRadarAreAFailure)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run = RunNexrad3d({"grid", data / "level2" / "run-kbgm-20050821", "-o",
    folder.Path() / "v", "--dims", "16x16x8", "--begin", "2006-01-01", "--end", "2006-01-01"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("--max-gap"), std::string::npos) << run.errors;
  EXPECT_TRUE(NamesIn(folder.Path() / "v").empty());
}

TEST(GridCommand, AFullDiskLeavesNothingHalfWritten)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* format : {"nxv", "nc"})
  {
    const TemporaryFolder folder;
    const FileSizeLimit limit(2'000);
    const ProgramRun run = RunNexrad3d({"grid", data / "level2" / "run-kbgm-20050821", "-o",
      folder.Path() / "v", "--dims", "64x64x32", "--format", format, "--end", "2005-08-21T02:46"});
    EXPECT_EQ(run.status, 1);
    EXPECT_NE(run.errors.find("cannot be written"), std::string::npos) << run.errors;
    EXPECT_TRUE(NamesIn(folder.Path() / "v").empty()) << format;
  }
}

TEST(GridCommand, AFileInTheWayOfTheFolder)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const ProgramRun run = RunNexrad3d({"grid", data / "level2" / "run-kbgm-20050821", "-o",
    "/dev/null", "--dims", "16x16x8", "--end", "2005-08-21T02:46"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("/dev/null"), std::string::npos) << run.errors;
}

// Each file is decoded once; a volume of several moments holds what a run for each of them writes.
TEST(GridCommand, SeveralMomentsInOneRun)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto merge = [&](const std::string& moments)
  {
    const ProgramRun run =
      RunNexrad3d({"grid", data / "level2" / "run-kbgm-20050821", "-o", folder.Path() / moments,
        "--moment", moments, "--dims", "48x48x24", "--ancillary", "--quiet"});
    EXPECT_EQ(run.status, 0) << run.errors;
  };
  merge("REF,VEL,SW");
  for (const char* moment : {"REF", "VEL", "SW"})
  {
    merge(moment);
    NxvReadOptions one;
    one.moments = {*ParseMomentName(moment)};
    std::size_t count = 0;
    for (const std::string& name : NamesIn(folder.Path() / moment))
    {
      if (fs::path(name).extension() == ".nxv")
      {
        const GriddedVolume alone = ReadNxv(folder.Path() / moment / name);
        const GriddedVolume read = ReadNxv(folder.Path() / "REF,VEL,SW" / name, one);
        EXPECT_EQ(read.moment, alone.moment);
        EXPECT_TRUE(read.values == alone.values && read.states == alone.states) << name;
        EXPECT_TRUE(read.ancillary.age == alone.ancillary.age) << name;
        ++count;
      }
    }
    EXPECT_GE(count, 5U);
    EXPECT_EQ(NamesIn(folder.Path() / moment), NamesIn(folder.Path() / "REF,VEL,SW"));
  }
  for (const char* wrong : {"REF,REF", "REF,", "REF,speed"})
  {
    EXPECT_EQ(
      RunNexrad3d({"grid", folder.Path(), "-o", folder.Path() / "x", "--moment", wrong}).status, 2);
  }
}
