// SPDX-License-Identifier: BSD-3-Clause
// `nexrad3d wind`: table, JSON, and what it says of files without velocities.
#include "HandMadeVolume.h"
#include "ProgramRun.h"
#include "TestData.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// 20 m/s from the west at all heights, folded at 15 m/s and rounded to half a metre a second.
HandMadeVolume WestWind()
{
  HandMadeVolume volume;
  volume.start = *ParseIso8601("2006-03-12T18:00Z");
  volume.synthetic = true;
  for (const float elevation : {1.5F, 4.3F})
  {
    HandMadeSweep sweep;
    sweep.elevation = elevation;
    sweep.nyquist = 15.0F;
    HandMadeMoment velocity;
    velocity.name = MomentName::VEL;
    velocity.gates = 200;
    velocity.firstGate = 1000;
    velocity.gateSpacing = 250;
    velocity.word = [elevation](int ray, int)
    {
      constexpr double radians = 3.14159265358979 / 180.0;
      const double radial =
        20.0 * std::sin((ray + 0.5) * radians) * std::cos(double(elevation) * radians);
      return static_cast<std::uint8_t>(std::lround(2.0 * std::remainder(radial, 30.0)) + 66);
    };
    sweep.moments = {velocity};
    volume.sweeps.push_back(sweep);
  }
  return volume;
}

} // namespace

TEST(WindCommand, PrintsJson)
{
  const TemporaryFolder folder;
  const std::string file = WriteLevel2(folder.Path() / "volume", {WestWind()}).string();
  const ProgramRun run = RunNexrad3d({"wind", "--json", file});
  EXPECT_EQ(run.status, 0) << run.errors;
  const auto report = nlohmann::json::parse(run.output);
  ASSERT_EQ(report.size(), 1u);
  EXPECT_EQ(report[0]["file"], file);
  EXPECT_EQ(report[0]["site"], "KEAX");
  EXPECT_EQ(report[0]["synthetic"], true);
  EXPECT_EQ(report[0]["velocities"], 2u * 360u * 200u);
  EXPECT_EQ(report[0]["unknown"], 0u);
  ASSERT_GE(report[0]["levels"].size(), 10u);
  for (const auto& level : report[0]["levels"])
  {
    EXPECT_NEAR(level["speed_m_s"].get<double>(), 20.0, 0.05);
    EXPECT_NEAR(level["direction_deg"].get<double>(), 270.0, 0.1);
    EXPECT_LT(level["rms_m_s"].get<double>(), 0.2);
    EXPECT_NEAR(
      level["height_m"].get<double>() - level["height_above_antenna_m"].get<double>(), 333.0, 1e-6);
  }
}

TEST(WindCommand, PrintsATable)
{
  const TemporaryFolder folder;
  const std::string file = WriteLevel2(folder.Path() / "volume", {WestWind()}).string();
  const ProgramRun run = RunNexrad3d({"wind", file, "--layer", "1000"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.output.find("SYNTHETIC"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("          833  20.0           270"), std::string::npos) << run.output;
}

// A terminal radar sends no Nyquist velocity. A volume of 2 × 360 × 200 velocities is made.
TEST(WindCommand, CountsVelocitiesOfRaysWithoutANyquistVelocity)
{
  const TemporaryFolder folder;
  HandMadeVolume volume = WestWind();
  for (HandMadeSweep& sweep : volume.sweeps)
  {
    sweep.nyquist = 0.0F;
  }
  const std::string file = WriteLevel2(folder.Path() / "volume", {volume}).string();
  const ProgramRun run = RunNexrad3d({"wind", "--json", file});
  const auto report = nlohmann::json::parse(run.output);
  EXPECT_EQ(report[0]["velocities"], 2 * 360 * 200);
  EXPECT_EQ(report[0]["unfolded"], 0);
}

TEST(WindCommand, SaysWhatAFileLacks)
{
  const TemporaryFolder folder;
  const std::string file =
    WriteLevel2(folder.Path() / "volume", {ConstantVolume({"KEAX", Position{38.81, -94.264, 333.0}},
                                            *ParseIso8601("2006-03-12T18:00Z"), 30.0)})
      .string();
  const ProgramRun run = RunNexrad3d({"wind", file});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("needs the moment VEL"), std::string::npos) << run.errors;
  EXPECT_EQ(RunNexrad3d({"wind", (folder.Path() / "none").string()}).status, 1);
  EXPECT_EQ(RunNexrad3d({"wind", file, "--layer", "1"}).status, 2);
}
