// SPDX-License-Identifier: BSD-3-Clause
#include "NoDisplay.h"
#include "PageParts.h"
#include "ProgramRun.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Codec/NxvHeader.h"
#include "nexrad/Model/SiteTable.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

nlohmann::json SceneOf(const std::string& page)
{
  const auto scene = ReadPagePart(page, "scene");
  return scene ? nlohmann::json::parse(scene->begin(), scene->end()) : nlohmann::json();
}

// Makes a page, without a display, and returns its text.
std::string MakePage(const TemporaryFolder& folder, std::vector<std::string> arguments)
{
  const NoDisplay none;
  const fs::path page = folder.Path() / "page.html";
  arguments.insert(arguments.begin(), "web");
  arguments.insert(arguments.end(), {"-o", page.string(), "--quiet"});
  const ProgramRun run = RunNexrad3d(arguments);
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output, "");
  return FileContent(page);
}

// Values of the voxels of one time of a page.
std::vector<double> ValuesOf(const std::string& page, const nlohmann::json& scene, std::size_t time)
{
  const auto ends = ReadPagePart(page, "ends-" + std::to_string(time));
  const auto codes = ReadPagePart(page, "codes-" + std::to_string(time));
  std::vector<double> values;
  if (ends && codes)
  {
    for (const auto code : UnpackColumns(scene["size"].get<std::array<int, 3>>(), *ends, *codes))
    {
      const double byte = scene["codes"][code];
      values.push_back(
        scene["scale"]["first"].get<double>() + scene["scale"]["step"].get<double>() * byte);
    }
  }
  return values;
}

std::string Message(const std::vector<std::string>& arguments, int status)
{
  const ProgramRun run = RunNexrad3d(arguments);
  EXPECT_EQ(run.status, status) << run.errors;
  return run.errors;
}

} // namespace

TEST(WebCommand, APageHoldsTheVolumesWithinAStep)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 3);
  const std::string page = MakePage(folder, {series});
  const nlohmann::json scene = SceneOf(page);
  const NxvSeries index = ReadNxvSeries(series);
  ASSERT_EQ(scene["times"].size(), 3U);
  double worst = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto& [name, seconds] = index[i];
    EXPECT_EQ(scene["times"][i].get<double>(), 1000.0 * seconds);
    const GriddedVolume volume = ReadNxv(folder.Path() / name);
    const std::vector<double> values = ValuesOf(page, scene, i);
    ASSERT_EQ(values.size(), volume.values.size());
    for (std::size_t voxel = 0; voxel < values.size(); ++voxel)
    {
      const auto truth = static_cast<double>(volume.values[voxel]);
      const bool visible = volume.states[voxel] == VoxelState::Echo && truth >= 5.0;
      EXPECT_EQ(values[voxel] >= 5.0, visible);
      worst = visible ? std::max(worst, std::abs(values[voxel] - truth)) : worst;
    }
  }
  EXPECT_AT_MOST(
    worst, 1.0, "greatest error of reflectivity that the command puts into a page, dBZ");
}

TEST(WebCommand, APageSaysWhatItShows)
{
  const TemporaryFolder folder;
  const std::string page = MakePage(folder, {WriteStormFiles(folder.Path(), 2)});
  EXPECT_NE(
    page.find("<title>SYNTHETIC: Reflectivity KLSX KILX, 2006-03-12</title>"), std::string::npos);
  const nlohmann::json scene = SceneOf(page);
  EXPECT_EQ(scene["synthetic"], true);
  EXPECT_EQ(scene["unit"], "dBZ");
  EXPECT_EQ(scene["series"], nullptr);
  EXPECT_EQ(scene["size"], nlohmann::json({48, 48, 16}));
  EXPECT_EQ(scene["box"], nlohmann::json({-240.0, 240.0, -240.0, 240.0, 0.0, 20.0}));
  EXPECT_EQ(scene["presets"][0]["name"], "all echo");
  EXPECT_EQ(scene["presets"][0]["samples"].size(), 4U * 511U);
  ASSERT_EQ(scene["radars"].size(), 2U);
  EXPECT_EQ(scene["radars"][0]["name"], "KLSX");
  // KLSX: 38.699 N, 90.683 W; the centre is 39 N, 90 W.
  EXPECT_NEAR(scene["radars"][0]["place"][0], -59.4, 0.5);
  EXPECT_NEAR(scene["radars"][0]["place"][1], -33.2, 0.5);
  EXPECT_GT(scene["map"]["state"].size(), 5U);
  EXPECT_TRUE(scene["map"]["county"].empty()) << "the domain is 480 km wide";
  EXPECT_EQ(scene["ground"], nlohmann::json({512, 512}));
  EXPECT_EQ(ReadPagePart(page, "ground").value_or(Bytes()).size(), 3U * 512U * 512U);
}

// The page leaves out names of radars that would stand closer than the letters of the picture need.
TEST(WebCommand, APageSaysHowFarApartManyRadarsAre)
{
  const TemporaryFolder folder;
  GriddedVolume volume =
    ReadNxv(folder.Path() / ReadNxvSeries(WriteStormFiles(folder.Path(), 1)).front().first);
  volume.sites.clear();
  volume.sitePositions.clear();
  for (const char* site : {"KLSX", "KILX", "KEAX", "KDVN", "KPAH", "KSGF", "KLOT", "KVWX", "KIND",
         "KDMX", "KARX", "KMKX", "KIWX", "KLVX", "KHPX", "KOHX", "KNQA", "KLZK"})
  {
    volume.sites.emplace_back(site);
    volume.sitePositions.push_back(FindSite(site)->position);
  }
  const fs::path file = folder.Path() / "many.nxv";
  WriteNxv(file, volume);
  std::size_t always = 0;
  const nlohmann::json radars = SceneOf(MakePage(folder, {file}))["radars"];
  ASSERT_GE(radars.size(), 2U); // in the domain
  for (const auto& radar : radars)
  {
    EXPECT_GT(radar["spread"].get<double>(), 0.0) << radar["name"];
    always += radar["spread"].get<double>() > 1e6 ? 1 : 0;
  }
  EXPECT_EQ(always, 1U);
}

// The storm moves 60 km to the east.
TEST(WebCommand, TheFrameHoldsAllTimes)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 4);
  const nlohmann::json all = SceneOf(MakePage(folder, {series}))["framed"];
  const auto framedAt = [&](const std::string& time) {
    return SceneOf(MakePage(folder, {series, "--time", time}))["framed"];
  };
  EXPECT_LE(all[0], framedAt("2006-03-12T18:30")[0]);
  EXPECT_GE(all[1], framedAt("2006-03-12T18:45")[1]);
}

// Whatever a page needs is in it.
TEST(WebCommand, APageNamesNoOtherFile)
{
  const TemporaryFolder folder;
  const std::string page = MakePage(folder, {WriteStormFiles(folder.Path(), 1)});
  EXPECT_EQ(page.find("@"), page.find("@media")) << "a mark was not filled in";
  for (const char* word :
    {" src=", "@import", "url(", "href=\"http", "//cdn", "\nimport ", "\nexport "})
  {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
  for (const char* id : {"letters", "bold-letters"})
  {
    EXPECT_TRUE(ReadPagePart(page, id)) << id;
  }
  EXPECT_EQ(page.find("SPDX-License-Identifier"), std::string::npos);
  EXPECT_NE(page.find("BSD-3-Clause"), std::string::npos);
}

TEST(WebCommand, CameraAndLooks)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 1);
  const nlohmann::json scene =
    SceneOf(MakePage(folder, {series, "--azimuth", "90", "--parallel", "--exaggeration", "2",
                               "--look-at", "39,-90,4km", "--preset", "hail", "--theme", "light"}));
  EXPECT_EQ(scene["camera"]["azimuth"], 90.0);
  EXPECT_EQ(scene["camera"]["parallel"], true);
  EXPECT_EQ(scene["stretch"], 2.0);
  EXPECT_NEAR(scene["camera"]["lookAt"][0], 0.0, 1e-6);
  EXPECT_NEAR(scene["camera"]["lookAt"][2], 4.0, 1e-6);
  EXPECT_EQ(scene["presets"][scene["preset"].get<std::size_t>()]["name"], "hail");
  EXPECT_GT(scene["theme"]["skyTop"][0], 0.9);

  const nlohmann::json own = SceneOf(MakePage(folder, {series, "--iso-values", "30:0.5,45"}));
  EXPECT_EQ(own["presets"][0]["name"], "own");
  EXPECT_EQ(own["preset"], 0);
  EXPECT_EQ(own["presets"][0]["surfaces"], nlohmann::json({{30.0, 0.5}, {45.0, 0.95}}));
}

// Weak echo is kept where the page shows it.
TEST(WebCommand, TheFloorFollowsThePreset)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 1);
  const nlohmann::json usual = SceneOf(MakePage(folder, {series}));
  const nlohmann::json weak = SceneOf(MakePage(folder, {series, "--preset", "clear air"}));
  EXPECT_EQ(usual["floor"], 5.0);
  EXPECT_LT(weak["floor"].get<double>(), 0.0);
  EXPECT_EQ(weak["presets"].size(), usual["presets"].size() + 1);
}

TEST(WebCommand, AnotherMomentHasNoValueWhereNothingIs)
{
  const TemporaryFolder folder;
  const std::string page = MakePage(folder, {WriteTwoMoments(folder.Path()), "--moment", "VEL"});
  const nlohmann::json scene = SceneOf(page);
  EXPECT_EQ(scene["array"], "VEL");
  EXPECT_EQ(scene["masked"], true);
  EXPECT_EQ(scene["floor"], nullptr);
  EXPECT_EQ(ValuesOf(page, scene, 0).size(), 48U * 48U * 16U);
}

TEST(WebCommand, AFolderGetsThePageTheVolumesAndTheirIndex)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 2);
  const fs::path site = folder.Path() / "site";
  EXPECT_EQ(Message({"web", series, "-o", site, "--quiet"}, 0), "");
  const std::string page = FileContent(site / "index.html");
  const nlohmann::json scene = SceneOf(page);
  EXPECT_EQ(scene["series"], "volumes.nxv.series");
  EXPECT_EQ(scene["floor"], nullptr);
  EXPECT_FALSE(scene.contains("bricks"));
  EXPECT_EQ(scene["presets"].size(), 6U);
  EXPECT_FALSE(ReadPagePart(page, "ends-0"));
  EXPECT_EQ(ReadNxvSeries(site / "volumes.nxv.series"), ReadNxvSeries(series));
  for (const auto& [name, seconds] : ReadNxvSeries(series))
  {
    EXPECT_EQ(FileContent(site / name), FileContent(folder.Path() / name));
  }
}

// A page in a folder reads parts of large volumes, and begins with the whole in few voxels.
TEST(WebCommand, AFolderShowsALargeVolumeInItsLargestVoxels)
{
  const TemporaryFolder folder;
  const fs::path volume = WriteLargeStorm(folder.Path());
  const fs::path site = folder.Path() / "site";
  EXPECT_EQ(Message({"web", volume, "-o", site, "--quiet"}, 0), "");
  const nlohmann::json inFolder = SceneOf(FileContent(site / "index.html"));
  EXPECT_EQ(inFolder["size"], nlohmann::json({263, 8, 16}));
  EXPECT_EQ(inFolder["bricks"], true);
  const nlohmann::json alone = SceneOf(MakePage(folder, {volume}));
  EXPECT_EQ(alone["size"], nlohmann::json({1050, 32, 16}));
  EXPECT_FALSE(alone.contains("bricks"));
}

TEST(WebCommand, AFolderOfVolumesKeepsItsIndex)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 2);
  const std::string before = FileContent(series);
  EXPECT_EQ(Message({"web", folder.Path(), "-o", folder.Path(), "--quiet"}, 0), "");
  EXPECT_TRUE(fs::exists(folder.Path() / "index.html"));
  EXPECT_EQ(FileContent(series), before);
}

TEST(WebCommand, WrongInputsAndOutputsAreNamed)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 1);
  EXPECT_NE(Message({"web", series}, 2).find("--output"), std::string::npos);
  EXPECT_NE(Message({"web", series, "-o", "page.png"}, 2).find("page.png"), std::string::npos);
  const fs::path page = folder.Path() / "page.html";
  EXPECT_NE(Message({"web", "nothing.nxv", "-o", page}, 1).find("nothing.nxv"), std::string::npos);
  EXPECT_NE(Message({"web", series, "-o", page, "--preset", "velocity"}, 1).find("velocity"),
    std::string::npos);

  GriddedVolume other = MakeStorm(true);
  other.time += std::chrono::minutes(30);
  other.grid.spacing[2] = 1000.0;
  WriteNxv(folder.Path() / "other.nxv", other);
  const std::string grids = Message({"web", folder.Path(), "-o", page}, 1);
  EXPECT_NE(grids.find("different runs"), std::string::npos) << grids;
  EXPECT_FALSE(fs::exists(page));

  std::ofstream(folder.Path() / "image.vti") << "x";
  const std::string vti =
    Message({"web", folder.Path() / "image.vti", "-o", folder.Path() / "site"}, 1);
  EXPECT_NE(vti.find("image.vti"), std::string::npos) << vti;
}

// A folder may be that of a web site, or of volumes that somebody made.
TEST(WebCommand, FilesOfOthersStay)
{
  const TemporaryFolder folder;
  fs::create_directory(folder.Path() / "in");
  const fs::path series = WriteStormFiles(folder.Path() / "in", 2);
  const NxvSeries index = ReadNxvSeries(series);
  for (const std::string& name :
    {std::string("index.html"), std::string("volumes.nxv.series"), index.back().first})
  {
    const fs::path site = folder.Path() / ("site-of-" + name);
    fs::create_directory(site);
    std::ofstream(site / name) << "{\"file-series-version\": \"1.0\", \"files\": []}";
    const std::string before = FileContent(site / name);
    const std::string line = Message({"web", series, "-o", site, "--quiet"}, 1);
    EXPECT_NE(line.find((site / name).string() + ": "), std::string::npos) << line;
    EXPECT_NE(line.find("stays as it is"), std::string::npos) << line;
    EXPECT_EQ(FileContent(site / name), before);
    EXPECT_EQ(std::distance(fs::directory_iterator(site), {}), 1) << name;
  }
}

TEST(WebCommand, WhatItWroteItReplaces)
{
  const TemporaryFolder folder;
  const fs::path site = folder.Path() / "site";
  fs::create_directory(folder.Path() / "in");
  const fs::path series = WriteStormFiles(folder.Path() / "in", 2);
  EXPECT_EQ(Message({"web", series, "-o", site, "--quiet"}, 0), "");
  GriddedVolume other = ReadNxv(folder.Path() / "in" / ReadNxvSeries(series)[0].first);
  other.values.front() = 40.0F;
  other.states.front() = VoxelState::Echo;
  const std::string name = ReadNxvSeries(series)[0].first;
  WriteNxv(folder.Path() / "in" / name, other);
  EXPECT_EQ(Message({"web", series, "-o", site, "--quiet"}, 0), "");
  EXPECT_EQ(FileContent(site / name), FileContent(folder.Path() / "in" / name));
  // A file of others with the bytes of one of these does not become the command's own.
  const fs::path shared = folder.Path() / "shared";
  fs::create_directory(shared);
  fs::copy(site / name, shared / name);
  EXPECT_EQ(Message({"web", series, "-o", shared, "--quiet"}, 0), "");
  other.values.front() = 45.0F;
  WriteNxv(folder.Path() / "in" / name, other);
  EXPECT_NE(Message({"web", series, "-o", shared, "--quiet"}, 1).find(name), std::string::npos);
}

// Headers choose the words of the messages about them.
TEST(WebCommand, AMessageIsShortAndNamesTheFileAndItsIndex)
{
  const TemporaryFolder folder;
  const fs::path series = folder.Path() / "s.nxv.series";
  WriteNxvSeries(series, {{"gone.nxv", 0.0}, {"/dev/zero", 300.0}});
  for (const fs::path& output : {folder.Path() / "page.html", folder.Path() / "site"})
  {
    const std::string line = Message({"web", series, "-o", output}, 1);
    EXPECT_EQ(line.find("nexrad3d web: " + series.string() + ": "), 0U) << line;
    EXPECT_NE(
      line.find(output.extension().empty() ? "/dev/zero: " : "gone.nxv: "), std::string::npos)
      << line;
  }
  const fs::path file = folder.Path() / "long.nxv";
  for (const char* key : {"time", "projection", "method", "name"})
  {
    NxvHeader header;
    header.volume = MakeStorm(true);
    std::string text = FormatNxvHeader(header);
    text = text.substr(0, text.rfind(",\"header_crc32")) + "}";
    const std::string longText(5'000, 'x');
    const auto json = nlohmann::ordered_json::parse(text);
    auto changed = json;
    changed[key] = longText;
    text = changed.dump();
    std::ofstream stream(file, std::ios::binary);
    const auto size = static_cast<std::uint32_t>(text.size());
    stream.write("NXV1", 4).write(reinterpret_cast<const char*>(&size), 4) << text;
    stream.close();
    const std::string line = Message({"web", file, "-o", folder.Path() / "page.html"}, 1);
    EXPECT_EQ(line.find("nexrad3d web: " + file.string() + ": "), 0U) << line;
    EXPECT_LT(line.size(), file.string().size() + 350U) << key;
  }
}

TEST(WebCommand, AVolumeThatIsTooWideForBrowsersIsRefused)
{
  const TemporaryFolder folder;
  GriddedVolume wide = MakeStorm(true);
  wide.grid.dimensions = {2049, 2, 2};
  wide.values.assign(wide.grid.VoxelCount(), 40.0F);
  wide.states.assign(wide.grid.VoxelCount(), VoxelState::Echo);
  WriteNxv(folder.Path() / "wide.nxv", wide);
  const ProgramRun run =
    RunNexrad3d({"web", folder.Path() / "wide.nxv", "-o", folder.Path() / "page.html"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("2049x2x2 voxels has more than the 2048"), std::string::npos)
    << run.errors;
  EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
  EXPECT_FALSE(fs::exists(folder.Path() / "page.html"));
}
