// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/SiteTable.h"

#include "HandMadeVolume.h"
#include "Level2Bytes.h"
#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

fs::path WriteFile(const TemporaryFolder& folder, const std::string& name, const Bytes& bytes)
{
  std::ofstream(folder.Path() / name, std::ios::binary)
    .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return folder.Path() / name;
}

std::vector<fs::path> FilesBelow(const fs::path& folder)
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

} // namespace

TEST(Info, PrintsTheSchema)
{
  const TemporaryFolder folder;
  const fs::path file = WriteFile(folder, "KTLX20050821_024319", MakeSmallVolume(31));
  const ProgramRun run =
    RunNexrad3d({"info", "--json", file, "--gate", "1,0,3", "--gate", "0,11,0"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.errors, "");
  const Json info = Json::parse(run.output).at(0);
  EXPECT_EQ(info["file"], file.string());
  EXPECT_EQ(info["site"], "KTLX");
  EXPECT_NEAR(info["latitude"], 35.33, 1e-5);
  EXPECT_NEAR(info["longitude"], -97.28, 1e-5);
  EXPECT_EQ(info["altitude_m"], 390.0);
  EXPECT_EQ(info["vcp"], 21);
  EXPECT_EQ(info["message_type"], 31);
  EXPECT_EQ(info["start"], "2005-08-21T02:43:19.671Z");
  EXPECT_EQ(info["end"], "2005-08-21T02:43:21.221Z");
  EXPECT_EQ(info["complete"], true);
  EXPECT_EQ(info["damage"], Json::array());
  ASSERT_EQ(info["sweeps"].size(), 2U);
  EXPECT_EQ(info["sweeps"][1], Json::parse(R"({"index": 1, "elevation_number": 2,
    "elevation_deg": 1.5, "elevation_mean_deg": 1.5, "waveform": "contiguous surveillance",
    "rays": 12, "stray_rays": 0, "first_azimuth_deg": 45.0,
    "start": "2005-08-21T02:43:20.671Z", "nyquist_m_s": 26.1200008392334,
    "unambiguous_range_m": 148000.0,
    "moments": {"REF": {"gates": 5, "first_gate_m": 2125, "gate_spacing_m": 250, "valid": 36,
      "below_threshold": 12, "range_folded": 12, "min": -32.0, "max": 94.5,
      "mean": 20.833333333333332}}})"));
  EXPECT_EQ(info["gates"], Json::parse(R"([
    {"sweep": 1, "ray": 0, "gate": 3, "moments": {"REF": {"raw": 66, "value": 0.0}}},
    {"sweep": 0, "ray": 11, "gate": 0, "moments": {"REF": {"raw": 0, "value": null}}}])"));
}

TEST(Info, UnknownIsNull)
{
  const TemporaryFolder folder;
  const ProgramRun run = RunNexrad3d({"info", "--json", WriteFile(folder, "empty", {})});
  EXPECT_EQ(run.status, 1);
  const Json info = Json::parse(run.output).at(0);
  for (const char* key :
    {"site", "latitude", "longitude", "altitude_m", "vcp", "message_type", "start", "end"})
  {
    EXPECT_TRUE(info.at(key).is_null()) << key;
  }
  EXPECT_EQ(info["sweeps"], Json::array());
  EXPECT_EQ(info["complete"], false);
}

TEST(Info, CountsTheClutterFiltersCodesAsStatus)
{
  RayPlan ray;
  ray.moments[0].name = "CFP";
  ray.moments[0].words = {0, 1, 7, 8, 20};
  ray.moments[0].scale = 1.0F;
  ray.moments[0].offset = 8.0F;
  const TemporaryFolder folder;
  const fs::path file = WriteFile(folder, "file", Join({MakeVolumeHeader(), MakeMessage31(ray)}));
  const Json moment =
    Json::parse(RunNexrad3d({"info", "--json", file}).output)[0]["sweeps"][0]["moments"]["CFP"];
  EXPECT_EQ(moment["status"], 3);
  EXPECT_EQ(moment["valid"], 2);
  EXPECT_EQ(moment["below_threshold"], 0);
  EXPECT_EQ(moment["range_folded"], 0);
  EXPECT_EQ(moment["max"], 12.0);
}

TEST(Info, ExitStatusSaysWhatHappened)
{
  const TemporaryFolder folder;
  const Bytes whole = MakeSmallVolume(1);
  const fs::path good = WriteFile(folder, "good", whole);
  const fs::path cut = WriteFile(folder, "cut", {whole.begin(), whole.end() - 2432});
  const fs::path none = WriteFile(folder, "none", {whole.begin(), whole.begin() + 24});
  EXPECT_EQ(RunNexrad3d({"info", good}).status, 0);
  EXPECT_EQ(RunNexrad3d({"info", good, cut}).status, 3);
  EXPECT_EQ(RunNexrad3d({"info", good, none}).status, 3);
  EXPECT_EQ(RunNexrad3d({"info", none}).status, 1);
  const ProgramRun absent = RunNexrad3d({"info", "--json", folder.Path() / "absent", good});
  EXPECT_EQ(absent.status, 3);
  EXPECT_NE(absent.errors.find("absent: cannot read: No such file"), std::string::npos);
  EXPECT_EQ(Json::parse(absent.output).size(), 2U);
}

TEST(Info, NamesDamageWithFileAndOffset)
{
  const TemporaryFolder folder;
  const Bytes whole = MakeSmallVolume(1);
  const fs::path cut = WriteFile(folder, "cut", {whole.begin(), whole.end() - 2432});
  const ProgramRun run = RunNexrad3d({"info", cut});
  EXPECT_EQ(run.errors, cut.string() + ": offset " + std::to_string(whole.size() - 2432) +
                          ": no end of volume: its last rays are missing\n");
}

TEST(Info, ARestartInTheNextFileIsNoDamage)
{
  const TemporaryFolder folder;
  HandMadeVolume half;
  half.start = *ParseIso8601("2006-03-12T18:00:00Z");
  half.sweeps.push_back({0.5F, 180, 0.5, 180.0, 25.0F, {{MomentName::REF, 10, 1000, 1000}}});
  half.complete = false;
  const fs::path file = WriteLevel2(folder.Path() / "a", {half});
  EXPECT_EQ(RunNexrad3d({"info", file}).status, 3);
  WriteLevel2(folder.Path() / "b",
    {ConstantVolume(half.site, half.start + std::chrono::milliseconds(5000), 20.0)});
  const ProgramRun run = RunNexrad3d({"info", folder.Path()});
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(run.errors, "");
  const ProgramRun json = RunNexrad3d({"info", "--json", folder.Path()});
  EXPECT_EQ(Json::parse(json.output).at(0).at("cuts").at(0).at("end"), "new volume");
}

TEST(Info, WrongUsageNamesTheOption)
{
  const TemporaryFolder folder;
  const std::string good = WriteFile(folder, "good", MakeSmallVolume(1));
  for (const std::vector<std::string>& arguments :
    {std::vector<std::string>{"--gate", "1,2"}, {"--gate", "1,2,x"}, {"--gate", "-1,2,3"},
      {"--gate", "7,0,0"}, {"--site", "ZZZZ"}, {"--position", "95,0,0"}, {"--position", "1,2"}})
  {
    std::vector<std::string> words = {"info", good};
    words.insert(words.end(), arguments.begin(), arguments.end());
    const ProgramRun run = RunNexrad3d(words);
    EXPECT_EQ(run.status, 2) << arguments[0] << ' ' << arguments[1];
    EXPECT_NE(run.errors.find(arguments[0]), std::string::npos) << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
  }
  EXPECT_EQ(RunNexrad3d({"info"}).status, 2);
}

TEST(Info, TakesSiteAndPositionFromTheOptions)
{
  const TemporaryFolder folder;
  const std::string good = WriteFile(folder, "good", MakeSmallVolume(1));
  const Json byName =
    Json::parse(RunNexrad3d({"info", "--json", "--site", "KLSX", good}).output)[0];
  EXPECT_EQ(byName["site"], "KLSX");
  EXPECT_EQ(byName["latitude"], FindSite("KLSX")->position.latitude);
  const Json byPlace = Json::parse(
    RunNexrad3d({"info", "--json", "--site", "ABCD", "--position=-1.5,2,30", good}).output)[0];
  EXPECT_EQ(byPlace["site"], "ABCD");
  EXPECT_EQ(byPlace["latitude"], -1.5);
  EXPECT_EQ(byPlace["altitude_m"], 30.0);
}

TEST(Info, PrintsATableForPeople)
{
  const TemporaryFolder folder;
  const std::string good = WriteFile(folder, "good", MakeSmallVolume(1));
  const std::string output = RunNexrad3d({"info", good, "--gate", "0,0,4"}).output;
  for (const char* part : {"KTLX", "VCP 21", "2 sweeps, 24 rays, complete", "REF 5x1000m",
         "VEL 6x250m", "gate 0,0,4: REF 94.5 (raw 255)", "note: the site's position is from the"})
  {
    EXPECT_NE(output.find(part), std::string::npos) << part << " is not in\n" << output;
  }
}

// A folder of files is a line for each, in the order of their names; JSON has them all.
TEST(Info, ListsTheFilesOfAFolder)
{
  const TemporaryFolder folder;
  const std::string first = WriteFile(folder, "a", MakeSmallVolume(1));
  const std::string second = WriteFile(folder, "b", MakeSmallVolume(31));
  const ProgramRun run = RunNexrad3d({"info", folder.Path()});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 2) << run.output;
  EXPECT_EQ(run.output.rfind(first + ": KTLX, 2005-08-21T", 0), 0u) << run.output;
  EXPECT_NE(run.output.find("\n" + second + ": KTLX"), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("VCP 21, 2 sweeps, 24 rays, complete\n"), std::string::npos);
  const Json json = Json::parse(RunNexrad3d({"info", "--json", folder.Path()}).output);
  ASSERT_EQ(json.size(), 2u);
  EXPECT_EQ(json[1]["file"], second);
  std::ofstream(folder.Path() / "notes.txt") << "no radar file\n";
  const ProgramRun withNotes = RunNexrad3d({"info", folder.Path()});
  EXPECT_EQ(withNotes.status, 3);
  EXPECT_NE(withNotes.errors.find("notes.txt"), std::string::npos) << withNotes.errors;
  const TemporaryFolder empty;
  EXPECT_EQ(RunNexrad3d({"info", empty.Path()}).status, 1);
}

// One sweep of one ray; a file that has no Nyquist velocity does not have one of 0.
TEST(Info, CountsOneAsOneAndKnowsWhatItDoesNotKnow)
{
  const TemporaryFolder folder;
  HandMadeVolume volume = ConstantVolume(
    {"KEAX", Position{38.81, -94.264, 333.0}}, *ParseIso8601("2006-03-12T18:00"), 20.0);
  volume.sweeps[0].rays = 1;
  volume.sweeps[0].turn = 1.0;
  volume.sweeps[0].nyquist = 0.0F;
  const std::string file = WriteLevel2(folder.Path() / "one", {volume});
  const std::string table = RunNexrad3d({"info", file}).output;
  EXPECT_NE(table.find("1 sweep, 1 ray, "), std::string::npos) << table;
  EXPECT_NE(table.find("18:00:00.000        -  "), std::string::npos) << table;
  const Json info = Json::parse(RunNexrad3d({"info", "--json", file}).output)[0];
  EXPECT_TRUE(info["sweeps"][0]["nyquist_m_s"].is_null());
}

TEST(Info, NamesTheDamageOfEveryDamagedFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto files = FilesBelow(data / "level2/damaged");
  EXPECT_AT_LEAST(files.size(), 12U, "damaged files");
  int withoutRays = 0; // three of them hold metadata alone
  for (const fs::path& file : files)
  {
    const ProgramRun run = RunNexrad3d({"info", "--json", file});
    const Json info = Json::parse(run.output).at(0);
    const bool holdsRays = !info["sweeps"].empty();
    const bool holdsMetadata = !holdsRays && info["damage"].empty();
    EXPECT_EQ(run.status, holdsRays ? 3 : holdsMetadata ? 0 : 1) << file << '\n' << run.errors;
    withoutRays += holdsMetadata ? 1 : 0;
    std::istringstream lines(run.errors);
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count)
    {
      EXPECT_EQ(line.rfind(file.string() + ": offset ", 0), 0U) << line;
    }
    EXPECT_EQ(count, info["damage"].size()) << file;
  }
  EXPECT_EQ(withoutRays, 3);
}
