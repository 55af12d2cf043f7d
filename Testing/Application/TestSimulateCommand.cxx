// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/CommandLine.h"
#include "Commands/SimulatedFiles.h"
#include "TestData.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Simulation/SimulatedDay.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

using namespace nexrad;
using namespace nexrad::application;
using nexrad::testing::NamesIn;

namespace
{

struct Outcome
{
  int status = 0;
  std::string output;
  std::string errors;
};

Outcome Simulate(const std::vector<std::string>& arguments)
{
  std::vector<const char*> argv = {"nexrad3d", "simulate"};
  for (const std::string& argument : arguments)
  {
    argv.push_back(argument.c_str());
  }
  Outcome outcome;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  outcome.status = RunProgram(static_cast<int>(argv.size()), argv.data(), {AddSimulateCommand});
  outcome.output = ::testing::internal::GetCapturedStdout();
  outcome.errors = ::testing::internal::GetCapturedStderr();
  return outcome;
}

} // namespace

TEST(SimulateCommand, WritesTheSameFilesEveryTime)
{
  const nexrad::testing::TemporaryFolder temporary;
  const std::filesystem::path first = temporary.Path() / "first";
  const std::filesystem::path second = temporary.Path() / "deep/second";
  for (const auto& folder : {first, second})
  {
    const Outcome outcome =
      Simulate({folder.string(), "--hours", "0.1", "--sites", "KLSX:32,KILX:21"});
    EXPECT_EQ(outcome.status, Done) << outcome.errors;
    EXPECT_EQ(outcome.errors, "");
    EXPECT_NE(outcome.output.find("SYNTHETIC"), std::string::npos);
  }
  const std::set<std::string> names = NamesIn(first);
  ASSERT_GE(names.size(), 1U);
  EXPECT_EQ(names, NamesIn(second));
  for (const std::string& name : names)
  {
    EXPECT_EQ(name.substr(4, 11), "20060312_18"); // the busy hour, not midnight
    EXPECT_TRUE(
      nexrad::testing::FileContent(first / name) == nexrad::testing::FileContent(second / name))
      << name;
    const RadarVolume volume = ReadLevel2(first / name);
    EXPECT_TRUE(volume.synthetic);
    EXPECT_TRUE(volume.damage.empty());
    EXPECT_EQ(volume.site.name, name.substr(0, 4));
    EXPECT_TRUE(volume.coveragePatternNumber == 32 || volume.coveragePatternNumber == 21);
  }
}

TEST(SimulateCommand, ObeysItsOptions)
{
  const nexrad::testing::TemporaryFolder temporary;
  const Outcome outcome = Simulate({temporary.Path().string(), "--begin", "2006-03-12T06:00",
    "--hours", "0.15", "--sites", "KEAX", "--vcp", "32", "--message-type", "31", "--container",
    "gzip", "--seed", "7", "--refraction", "1.21", "--quiet"});
  EXPECT_EQ(outcome.status, Done) << outcome.errors;
  EXPECT_EQ(outcome.output, "");
  const std::set<std::string> names = NamesIn(temporary.Path());
  ASSERT_EQ(names.size(), 1U);
  EXPECT_EQ(names.begin()->substr(0, 15), "KEAX20060312_06");
  EXPECT_EQ(names.begin()->substr(19), "_V06.gz");
  const RadarVolume volume = ReadLevel2(temporary.Path() / *names.begin());
  EXPECT_EQ(volume.messageType, 31);
  EXPECT_EQ(volume.coveragePatternNumber, 32);
}

TEST(SimulateCommand, NamesTheWrongOption)
{
  const nexrad::testing::TemporaryFolder temporary;
  const std::string folder = temporary.Path().string();
  const std::vector<std::pair<std::string, std::string>> wrong = {{"--hours", "0"},
    {"--hours", "soon"}, {"--begin", "yesterday"}, {"--sites", "KZZZ"}, {"--sites", "KLSX:13"},
    {"--sites", "KLSX,KLSX"}, {"--vcp", "99"}, {"--message-type", "2"}, {"--container", "zip"},
    {"--seed", "-1"}, {"--refraction", "0"}, {"--not-weather", "rain"}, {"--bias", "KLSX"},
    {"--bias", "KLSX:30"}, {"--bias", "KABR:1"}};
  for (const auto& [option, value] : wrong)
  {
    const Outcome outcome = Simulate({folder, option, value});
    EXPECT_EQ(outcome.status, WrongUsage) << option << ' ' << value;
    EXPECT_NE(outcome.errors.find(option), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
  }
  EXPECT_TRUE(NamesIn(folder).empty());
}

TEST(SimulateCommand, AddsWhatIsNotWeather)
{
  const nexrad::testing::TemporaryFolder temporary;
  const Outcome outcome = Simulate(
    {temporary.Path().string(), "--hours", "0.1", "--sites", "KLSX:32", "--message-type", "31",
      "--not-weather", "clutter,sun", "--bias", "KLSX:-1.5", "--dual-polarisation", "--quiet"});
  ASSERT_EQ(outcome.status, Done) << outcome.errors;
  SimulatorOptions options;
  options.superResolution = true;
  options.notWeather = {EchoKind::Clutter, EchoKind::Sun};
  options.bias = -1.5;
  options.dualPolarisation = true;
  const RadarVolume volume = ReadLevel2(temporary.Path() / *NamesIn(temporary.Path()).begin());
  const RadarVolume wanted = ScanVolume(StormField(), volume.site, 32, *volume.headerTime, options);
  ASSERT_EQ(volume.sweeps.size(), wanted.sweeps.size());
  for (const MomentName name : {MomentName::REF, MomentName::ZDR, MomentName::PHI, MomentName::RHO})
  {
    const MomentRow& row = volume.sweeps[0].rays[7].Row(name);
    const MomentRow& other = wanted.sweeps[0].rays[7].Row(name);
    ASSERT_EQ(row.gates, other.gates);
    ASSERT_GT(row.gates, 0);
    EXPECT_TRUE(std::equal(row.words, row.words + row.gates * (row.wordBits / 8), other.words));
  }
}

TEST(SimulateCommand, Message1HasNoDualPolarisation)
{
  const nexrad::testing::TemporaryFolder temporary;
  const Outcome outcome = Simulate({temporary.Path().string(), "--dual-polarisation"});
  EXPECT_EQ(outcome.status, WrongUsage);
  EXPECT_NE(outcome.errors.find("--message-type 31"), std::string::npos) << outcome.errors;
}

TEST(SimulateCommand, SaysThatAFolderCannotBeMade)
{
  const nexrad::testing::TemporaryFolder temporary;
  const std::filesystem::path file = temporary.Path() / "file";
  std::ofstream(file) << "in the way";
  const Outcome outcome = Simulate({file.string(), "--hours", "0.1"});
  EXPECT_EQ(outcome.status, Failed);
  EXPECT_NE(outcome.errors.find(file.string()), std::string::npos);
  EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1);
}

TEST(SimulateCommand, APeriodWithoutAVolumeFails)
{
  SimulatedDayOptions day;
  day.sites = {{"KEAX", 32}};
  const Time justAfter = PlanSimulatedDay(day).front().start + std::chrono::seconds(2);
  const nexrad::testing::TemporaryFolder temporary;
  const Outcome outcome = Simulate({temporary.Path().string(), "--hours", "0.01", "--begin",
    FormatIso8601(justAfter), "--sites", "KEAX:32"});
  EXPECT_EQ(outcome.status, Failed);
  EXPECT_NE(outcome.errors.find("no volume begins"), std::string::npos) << outcome.errors;
}

// A stop leaves whole files and says that they are not all.
TEST(SimulateCommand, AStopIsAFailure)
{
  SimulatedDayOptions day;
  day.length = std::chrono::minutes(30);
  day.sites = {{"KEAX", 32}};
  ASSERT_GT(PlanSimulatedDay(day).size(), 2U);
  const nexrad::testing::TemporaryFolder temporary;
  EXPECT_THROW(WriteSimulatedFiles(day, temporary.Path(), [](double) { return false; }), Error);
  for (const auto& entry : std::filesystem::directory_iterator(temporary.Path()))
  {
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
    EXPECT_TRUE(ReadLevel2(entry.path()).complete) << entry.path();
  }
}
