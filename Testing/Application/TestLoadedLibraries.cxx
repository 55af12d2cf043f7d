// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

using namespace nexrad::testing;

namespace
{

// What the dynamic linker says of the libraries that it brings in while the program runs.
std::string LinkerReport(const std::vector<std::string>& arguments)
{
  setenv("LD_DEBUG", "libs", 1);
  const ProgramRun run = RunNexrad3d(arguments);
  unsetenv("LD_DEBUG");
  return run.errors;
}

bool LoadsRendering(const std::string& report)
{
  return report.find("calling init: ") != std::string::npos &&
         (report.find("libvtkRendering") != std::string::npos ||
           report.find("libGL.") != std::string::npos ||
           report.find("libvtkNexradRendering") != std::string::npos);
}

} // namespace

TEST(LoadedLibraries, NothingLoadsMpiWithoutMpiexec)
{
  const std::string info = LinkerReport({"info", "/dev/null"});
  EXPECT_NE(info.find("calling init: "), std::string::npos) << "the linker reported nothing";
  EXPECT_EQ(info.find("libmpi"), std::string::npos);
  const std::string grid = LinkerReport({"grid", "/nonexistent", "-o", "/nonexistent"});
  EXPECT_EQ(grid.find("libmpi"), std::string::npos);
}

TEST(LoadedLibraries, OnlyMergingLoadsVtkAndOnlyDrawingLoadsRendering)
{
  const std::string info = LinkerReport({"info", "/dev/null"});
  EXPECT_NE(info.find("calling init: "), std::string::npos) << "the linker reported nothing";
  EXPECT_EQ(info.find("libvtk"), std::string::npos);
  const std::string grid = LinkerReport({"grid", "/nonexistent", "-o", "/nonexistent"});
  EXPECT_NE(grid.find("libvtkCommonCore"), std::string::npos);
  EXPECT_FALSE(LoadsRendering(grid));
  // The library is loaded before it looks for its inputs.
  EXPECT_TRUE(LoadsRendering(LinkerReport({"render", "/nonexistent", "-o", "/nonexistent.png"})));
}
