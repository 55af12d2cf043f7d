// SPDX-License-Identifier: BSD-3-Clause
// Biases of radars through the program: what it reports, and what it takes off (Formulas Q6).
#include "ProgramRun.h"
#include "Scans/TwoRadars.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

// KONE measures 30 dBZ where KTWO measures 34.
class RadarBias : public ::testing::Test
{
protected:
  ProgramRun Grid(const std::string& output, const std::vector<std::string>& options = {})
  {
    std::vector<std::string> arguments = {"grid", folder.Path() / "radars", "-o",
      folder.Path() / output, "--dims", "48x24x12", "--height", "0,6km", "--code", "exact",
      "--no-sharpening"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return RunNexrad3d(arguments);
  }

  // The only volume of a run.
  GriddedVolume Volume(const std::string& output) const
  {
    return ReadOnlyVolume(folder.Path() / output);
  }

  void SetUp() override
  {
    fs::create_directories(folder.Path() / "radars");
    files = WriteTwoRadars(folder.Path() / "radars", 30.0, 34.0);
  }

  TemporaryFolder folder;
  std::vector<fs::path> files;
};

// Least and largest echo.
std::pair<double, double> EchoRange(const GriddedVolume& volume)
{
  std::pair<double, double> range = {1e9, -1e9};
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    if (volume.states[i] == VoxelState::Echo)
    {
      range.first = std::min(range.first, static_cast<double>(volume.values[i]));
      range.second = std::max(range.second, static_cast<double>(volume.values[i]));
    }
  }
  return range;
}

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

} // namespace

TEST_F(RadarBias, IsReportedAndNotTakenOff)
{
  const ProgramRun run = this->Grid("v");
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(Has(run.output, "KONE - KTWO: median -4.00 dB, quartiles -4.00 and -4.00 dB, "))
    << run.output;
  EXPECT_TRUE(Has(run.output, "KONE: bias -2.00 dB")) << run.output;
  EXPECT_TRUE(Has(run.output, "KTWO: bias +2.00 dB")) << run.output;
  EXPECT_FALSE(Has(run.output, "taken off")) << run.output;
  const auto [least, most] = EchoRange(this->Volume("v"));
  EXPECT_FLOAT_EQ(least, 29.0) << "1 dB less far from the radars";
  EXPECT_FLOAT_EQ(most, 34.0);
}

TEST_F(RadarBias, ThatIsFoundIsTakenOff)
{
  const ProgramRun run = this->Grid("v", {"--bias", "auto"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(Has(run.output, "KTWO: +2.00 dB taken off")) << run.output;
  const auto [least, most] = EchoRange(this->Volume("v"));
  EXPECT_NEAR(least, 31.0, 1e-4);
  EXPECT_NEAR(most, 32.0, 1e-4);
}

TEST_F(RadarBias, ThatIsGivenIsTakenOff)
{
  const ProgramRun run = this->Grid("v", {"--bias", "KONE:-1.5,KTWO=+4.5", "--quiet"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_TRUE(run.output.empty()) << run.output;
  const auto [least, most] = EchoRange(this->Volume("v"));
  EXPECT_NEAR(least, 28.5, 1e-4);
  EXPECT_NEAR(most, 31.5, 1e-4);
}

TEST_F(RadarBias, OffIsAsWithoutTheOption)
{
  EXPECT_EQ(this->Grid("v").status, 0);
  EXPECT_EQ(this->Grid("off", {"--bias", "off"}).status, 0);
  for (const auto& entry : fs::directory_iterator(folder.Path() / "v"))
  {
    EXPECT_EQ(
      FileContent(entry.path()), FileContent(folder.Path() / "off" / entry.path().filename()));
  }
}

TEST_F(RadarBias, IsInTheJsonOfGrid)
{
  const ProgramRun run = this->Grid("v", {"--bias", "KTWO:4", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  const nlohmann::json json = nlohmann::json::parse(run.output);
  EXPECT_EQ(json["index"], (folder.Path() / "v" / "volumes.nxv.series").string());
  EXPECT_EQ(json["volumes"].size(), 1U);
  EXPECT_TRUE(json["problems"].empty());
  EXPECT_TRUE(json["notes"].empty());
  const nlohmann::json& pair = json["radars"]["pairs"].at(0);
  EXPECT_EQ(pair["first"], "KONE");
  EXPECT_EQ(pair["second"], "KTWO");
  EXPECT_EQ(pair["pairs_of_volumes"], 1);
  EXPECT_DOUBLE_EQ(pair["median_db"], -4.0);
  EXPECT_DOUBLE_EQ(json["radars"]["biases_db"]["KTWO"], 2.0);
  EXPECT_EQ(json["radars"]["taken_off_db"], nlohmann::json({{"KTWO", 4.0}}));
  EXPECT_TRUE(json["radars"]["alone"].empty());
}

TEST_F(RadarBias, IsReportedByInfoOfSeveralFiles)
{
  const ProgramRun text = RunNexrad3d({"info", files[0], files[1]});
  EXPECT_EQ(text.status, 0) << text.errors;
  EXPECT_TRUE(Has(text.output, "KONE - KTWO: median -4.00 dB")) << text.output;
  EXPECT_FALSE(Has(RunNexrad3d({"info", files[0]}).output, "bias"));
  const ProgramRun run = RunNexrad3d({"info", files[0], files[1], "--json"});
  const nlohmann::json json = nlohmann::json::parse(run.output);
  EXPECT_DOUBLE_EQ(json.at(0)["bias_db"], -2.0);
  EXPECT_DOUBLE_EQ(json.at(1)["bias_db"], 2.0);
  EXPECT_EQ(json.at(1)["neighbours"].at(0)["site"], "KONE");
  EXPECT_DOUBLE_EQ(json.at(1)["neighbours"].at(0)["median_db"], 4.0);
  const ProgramRun alone = RunNexrad3d({"info", files[0], "--json"});
  EXPECT_FALSE(nlohmann::json::parse(alone.output).at(0).contains("bias_db"));
}

TEST_F(RadarBias, SaysWhatIsWrongInOneLine)
{
  const ProgramRun unknown = this->Grid("v", {"--bias", "KABR:1"});
  EXPECT_EQ(unknown.status, 1);
  EXPECT_TRUE(Has(unknown.errors,
    "a bias is given for KABR, which none of the inputs is of; they are of KONE, KTWO"))
    << unknown.errors;
  const ProgramRun text = this->Grid("v", {"--bias", "much"});
  EXPECT_EQ(text.status, 2);
  EXPECT_TRUE(Has(text.errors, "write auto, off, or radars")) << text.errors;
  const ProgramRun large = this->Grid("v", {"--bias", "KONE:21"});
  EXPECT_EQ(large.status, 2);
  EXPECT_TRUE(Has(large.errors, "-20 to 20 dB")) << large.errors;
  const ProgramRun moment =
    RunNexrad3d({"grid", files[0], "-o", folder.Path() / "m", "--moment", "VEL", "--bias", "auto"});
  EXPECT_EQ(moment.status, 2);
  EXPECT_TRUE(Has(moment.errors, "is of --moment REF alone")) << moment.errors;
  const ProgramRun thesis = RunNexrad3d(
    {"grid", files[0], "-o", folder.Path() / "t", "--method", "thesis", "--bias", "auto"});
  EXPECT_EQ(thesis.status, 2);
  EXPECT_TRUE(Has(thesis.errors, "is of the method 'beam'")) << thesis.errors;
}

// KBGM and KTYX scanned the same evening rain within a minute. No radar of the network is wrong by
// more than some dB.
TEST(RadarBiasOfRealFiles, IsBelievable)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const ProgramRun run = RunNexrad3d({"info", data / "level2/multisite-20100911", "--json"});
  ASSERT_EQ(run.status, 0) << run.errors;
  std::size_t stated = 0;
  for (const nlohmann::json& file : nlohmann::json::parse(run.output))
  {
    if (!file["bias_db"].is_null())
    {
      ++stated;
      EXPECT_WITHIN(
        file["bias_db"].get<double>(), 0.0, 2.0, "bias of a real radar against its neighbour, dB");
    }
  }
  EXPECT_EQ(stated, 2U);
}
