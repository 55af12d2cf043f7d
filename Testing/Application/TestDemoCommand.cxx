// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

TEST(DemoCommand, SimulatesMergesAndDraws)
{
  const TemporaryFolder folder;
  const fs::path output = folder.Path() / "demo";
  const ProgramRun run =
    RunNexrad3d({"demo", output, "--length", "5min", "--dims", "48x48x16", "--size", "320x180"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  for (const char* text :
    {"Level II files", "merged volumes", "storms.png", "storms.ogv", "SYNTHETIC", " s in all"})
  {
    EXPECT_NE(run.output.find(text), std::string::npos) << text << " in: " << run.output;
  }
  for (const char* name : {"storms.png", "storms-from-above.png", "storms.ogv"})
  {
    EXPECT_AT_LEAST(fs::file_size(output / name), 22'000U, "size of a picture or movie, bytes")
      << name;
  }
  const NxvSeries series = ReadNxvSeries(output / "volumes" / "volumes.nxv.series");
  ASSERT_GE(series.size(), 1U);
  for (const auto& [name, seconds] : series)
  {
    const GriddedVolume volume = ReadNxv(output / "volumes" / name);
    EXPECT_TRUE(volume.synthetic) << name;
    EXPECT_EQ(volume.sites, (std::vector<std::string>{"KEAX", "KILX", "KLSX"})) << name;
    EXPECT_EQ(ToSeconds(volume.time), seconds);
  }
}

TEST(DemoCommand, WithoutADisplayItFailsBeforeTheWork)
{
  const char* display = std::getenv("DISPLAY");
  const std::string before = display == nullptr ? "" : display;
  unsetenv("DISPLAY");
  const TemporaryFolder folder;
  const ProgramRun run = RunNexrad3d({"demo", folder.Path() / "demo"});
  setenv("DISPLAY", before.c_str(), 1);
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("xvfb-run"), std::string::npos) << run.errors;
  EXPECT_FALSE(fs::exists(folder.Path() / "demo"));
}
