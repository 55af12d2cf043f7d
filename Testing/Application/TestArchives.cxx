// SPDX-License-Identifier: BSD-3-Clause
// Commands take tar archives as folders. The archives are SYNTHETIC.
#include "Feed/TarMaker.h"
#include "HandMadeVolume.h"
#include "ProgramRun.h"
#include "TestData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

// A folder of two volumes, and a tar of it.
struct Day
{
  Day()
  {
    fs::create_directory(folder.Path() / "day");
    std::vector<TarEntry> entries;
    for (const int minutes : {0, 5})
    {
      const Time start(std::chrono::hours(24 * 15000) + std::chrono::minutes(minutes));
      const std::string name = "KEAX_" + std::to_string(minutes);
      HandMadeVolume volume =
        ConstantVolume({"KEAX", Position{38.81, -94.264, 333.0}}, start, 20.0);
      volume.sweeps[0].moments.push_back(volume.sweeps[0].moments[0]);
      volume.sweeps[0].moments[1].name = MomentName::VEL;
      const std::string content = FileContent(WriteLevel2(folder.Path() / "day" / name, {volume}));
      entries.push_back({name, Bytes(content.begin(), content.end())});
    }
    tar = WriteBytes(folder.Path() / "day.tar", MakeTar(entries));
    gzip = WriteBytes(folder.Path() / "day.tar.gz", Gzip(MakeTar(entries)));
  }

  const TemporaryFolder folder;
  fs::path tar;
  fs::path gzip;
};

std::vector<std::string> VolumesIn(const fs::path& folder)
{
  std::vector<std::string> contents;
  for (const auto& entry : fs::directory_iterator(folder))
  {
    if (entry.path().extension() == ".nxv")
    {
      contents.push_back(entry.path().filename().string() + FileContent(entry.path()));
    }
  }
  std::sort(contents.begin(), contents.end());
  return contents;
}

} // namespace

TEST(Archives, InfoHasALineForEachMember)
{
  const Day day;
  for (const fs::path& tar : {day.tar, day.gzip})
  {
    const ProgramRun run = RunNexrad3d({"info", tar});
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
    EXPECT_EQ(run.output.rfind((tar / "KEAX_0").string() + ": KEAX, ", 0), 0U) << run.output;
    EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 2);
    const auto json = nlohmann::json::parse(RunNexrad3d({"info", tar, "--json"}).output);
    EXPECT_EQ(json.at(1).at("file"), (tar / "KEAX_5").string());
  }
  EXPECT_EQ(RunNexrad3d({"info", day.tar / "KEAX_5"}).status, 0);
  EXPECT_EQ(RunNexrad3d({"info", day.tar / "KEAX_9"}).status, 1);
}

TEST(Archives, WindTakesTheMembers)
{
  const Day day;
  const ProgramRun whole = RunNexrad3d({"wind", day.tar, "--json"});
  EXPECT_EQ(whole.status, 0) << whole.errors;
  EXPECT_EQ(nlohmann::json::parse(whole.output).size(), 2U);
}

TEST(Archives, GridGivesTheBytesThatTheFolderGives)
{
  const Day day;
  const auto grid = [&](const fs::path& input, const std::string& name)
  {
    const ProgramRun run =
      RunNexrad3d({"grid", input, "-o", day.folder.Path() / name, "--dims", "32x32x8", "--quiet"});
    EXPECT_EQ(run.status, 0) << run.errors;
    return VolumesIn(day.folder.Path() / name);
  };
  const std::vector<std::string> wanted = grid(day.folder.Path() / "day", "a");
  EXPECT_EQ(wanted.size(), 2U);
  EXPECT_EQ(grid(day.tar, "b"), wanted);
  EXPECT_EQ(grid(day.gzip, "c"), wanted);
}
