// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/PictureWindow.h"
#include "ErrorMessage.h"
#include "HandMadeVolume.h"
#include "Libraries/VtkErrors.h"
#include "NoDisplay.h"
#include "ProgramRun.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Codec/NxvFile.h"

#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <gtest/gtest.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

constexpr char small[] = "320x180";

} // namespace

TEST(RenderCommand, OnePictureForEachTime)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 3);
  fs::create_directory(folder.Path() / "out");
  const ProgramRun run =
    RunNexrad3d({"render", series, "-o", folder.Path() / "out" / "storm.png", "--size", small});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_NE(run.errors.find("storm.png: 3 times make as many pictures"), std::string::npos)
    << run.errors;
  const std::set<std::string> expected = {
    "storm-20060312T183000Z.png", "storm-20060312T183500Z.png", "storm-20060312T184000Z.png"};
  EXPECT_EQ(NamesIn(folder.Path() / "out"), expected);
  for (const std::string& name : expected)
  {
    EXPECT_NE(run.output.find(name), std::string::npos);
    EXPECT_EQ(FileContent(folder.Path() / "out" / name).substr(1, 3), "PNG");
  }
}

TEST(RenderCommand, OneTimeAndTheCamera)
{
  const TemporaryFolder folder;
  WriteStormFiles(folder.Path(), 3);
  const auto draw = [&](const std::string& name, const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments = {"render", folder.Path(), "-o", folder.Path() / name,
      "--size", small, "--time", "2006-03-12T18:35", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.output, "");
    return FileContent(folder.Path() / name);
  };
  const std::string first = draw("first.png", {});
  EXPECT_EQ(first, draw("again.png", {}));
  EXPECT_NE(first, draw("east.png", {"--azimuth", "90"}));
  EXPECT_NE(first, draw("high.png", {"--tilt", "80"}));
  EXPECT_NE(first, draw("near.png", {"--zoom", "2"}));
  EXPECT_NE(first, draw("place.png", {"--look-at", "38.5,-90.5,2km"}));
  EXPECT_NE(first, draw("flat.png", {"--exaggeration", "2"}));
  EXPECT_NE(first, draw("rings.png", {"--rings", "100km"}));
  EXPECT_NE(first, draw("occlusion.png", {"--occlusion", "0.7"}));
  const auto shadow = draw("shadow.png", {"--shadow", "0.7"});
  EXPECT_NE(first, shadow);
  EXPECT_NE(shadow, draw("light.png", {"--shadow", "0.7", "--light", "90,30"}));
  EXPECT_EQ(shadow, draw("usual-light.png", {"--shadow", "0.7", "--light", "250,45"}));
  const auto surfaces = draw("surfaces.png", {"--preset", "iso-values"});
  EXPECT_NE(first, surfaces);
  EXPECT_EQ(surfaces, draw("values.png", {"--iso-values", "50:0.95,20:0.35,35:0.55"}));
  EXPECT_NE(surfaces, draw("opaque.png", {"--iso-values", "20:1,35:0.55,50:0.95"}));
  EXPECT_EQ(draw("usual.png", {"--iso-values", "20,35,50"}),
    draw("written.png", {"--iso-values", "20:0.35,35:0.65,50:0.95"}));
  EXPECT_NE(surfaces, draw("shaded-surfaces.png", {"--preset", "iso-values", "--shadow", "0.7"}));
  EXPECT_NE(first, draw("parallel.png", {"--parallel"}));
  EXPECT_NE(first, draw("dark.png", {"--theme", "dark"}));
  EXPECT_NE(first, draw("walls.png", {"--no-walls"}));
}

TEST(RenderCommand, MapsOfTheMomentAndOfWhatStandsBehindIt)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto draw = [&](const std::string& name, const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments = {"render", data / "level2" / "run-kbgm-20050821", "-o",
      folder.Path() / name, "--size", small, "--dims", "32x32x16", "--time", "2005-08-21T02:55",
      "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return FileContent(folder.Path() / name);
  };
  std::set<std::string> pictures;
  for (const char* map : {"composite", "lowest", "3km", "echo-top", "echo-top:30", "vil",
         "vil-density", "vil-density:30"})
  {
    pictures.insert(draw("a.png", {"--map", map}));
  }
  // Radar files are merged with the ancillary arrays that the picture needs.
  for (const char* array : {"REF_age", "REF_radars", "REF_weight", "REF_site"})
  {
    pictures.insert(draw("b.png", {"--map", "3km", "--array", array}));
  }
  EXPECT_EQ(pictures.size(), 12u);
  EXPECT_EQ(pictures.count(draw("c.png", {"--map", "3km", "--array", "REF"})), 1u);
}

TEST(RenderCommand, Movies)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 3);
  const ProgramRun run = RunNexrad3d({"render", series, "-o", folder.Path() / "storm.ogv", "--size",
    small, "--frames", "4", "--turn", "90"});
  EXPECT_EQ(run.status, 0) << run.errors;
  const std::string movie = FileContent(folder.Path() / "storm.ogv");
  EXPECT_EQ(movie.substr(0, 4), "OggS");
  EXPECT_NE(movie.find("theora"), std::string::npos);
  EXPECT_AT_LEAST(movie.size(), 30'000U, "size of the movie, bytes");
  const ProgramRun flight = RunNexrad3d({"render", series, "-o", folder.Path() / "flight.ogv",
    "--size", small, "--frames", "4", "--fly", "--zoom", "8"});
  EXPECT_EQ(flight.status, 0) << flight.errors;
  const ProgramRun rest = RunNexrad3d({"render", series, "-o", folder.Path() / "rest.ogv", "--size",
    small, "--frames", "4", "--zoom", "8"});
  EXPECT_NE(FileContent(folder.Path() / "flight.ogv"), FileContent(folder.Path() / "rest.ogv"));
}

namespace
{

// The mean colour about a place of the middle frame of a movie, as ffmpeg decodes it by its tags;
// of a picture likewise.
std::array<int, 3> ColourIn(const fs::path& file, const std::array<int, 2>& place)
{
  const std::string raw = file.string() + ".rgb";
  const std::string crop = "crop=4:4:" + std::to_string(place[0]) + ":" + std::to_string(place[1]);
  const std::string command = "ffmpeg -y -v error -i '" + file.string() + "' -frames:v 1 -vf " +
                              crop + ",scale=1:1:flags=area -pix_fmt rgb24 -f rawvideo '" + raw +
                              "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  const std::string bytes = FileContent(raw);
  std::array<int, 3> colour{};
  for (std::size_t i = 0; i < 3 && bytes.size() == 3; ++i)
  {
    colour[i] = static_cast<unsigned char>(bytes[i]);
  }
  return colour;
}

} // namespace

// An .mp4 says by which matrix it was made, else players guess by its size; Theora is of BT.601 by
// its specification.
TEST(RenderCommand, MoviesHaveTheColoursOfPictures)
{
  if (std::system("command -v ffmpeg ffprobe > /dev/null 2>&1") != 0)
  {
    GTEST_SKIP() << "needs the programs ffmpeg and ffprobe";
  }
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 1);
  for (const char* name : {"a.png", "a.mp4", "a.ogv"})
  {
    const ProgramRun run = RunNexrad3d({"render", series, "-o", folder.Path() / name});
    ASSERT_EQ(run.status, 0) << run.errors;
  }
  const fs::path tags = folder.Path() / "tags";
  const std::string probe =
    "ffprobe -v error -show_entries stream=color_range,color_space,color_transfer,color_primaries "
    "-of csv=p=0 '" +
    (folder.Path() / "a.mp4").string() + "' > '" + tags.string() + "'";
  ASSERT_EQ(std::system(probe.c_str()), 0);
  EXPECT_EQ(FileContent(tags), "pc,bt709,bt709,bt709\n");
  // In the boxes of the colour bar: all of its colours, the letters of which begin at 97 %.
  constexpr int x = 1231;
  for (int box = 0; box < 14; ++box)
  {
    const std::array<int, 2> place = {x, static_cast<int>(720 * (0.90 - 0.052 * (box + 0.5))) - 2};
    const std::array<int, 3> wanted = ColourIn(folder.Path() / "a.png", place);
    for (const char* name : {"a.mp4", "a.ogv"})
    {
      const std::array<int, 3> shown = ColourIn(folder.Path() / name, place);
      for (std::size_t i = 0; i < 3; ++i)
      {
        EXPECT_AT_MOST(std::abs(shown[i] - wanted[i]), 6,
          std::string("error of a colour of 0 to 255 in ") + name)
          << "box " << box;
      }
    }
  }
}

// As users do with a folder of one volume of each radar.
TEST(RenderCommand, OneFileOfEachRadarMakesOnePictureOfAll)
{
  const TemporaryFolder folder;
  const fs::path files = folder.Path() / "files";
  fs::create_directory(files);
  const auto at = [](const char* text) { return *ParseIso8601(text); };
  WriteLevel2(files / "a",
    {ConstantVolume({"KEAX", Position{38.81, -94.264, 333.0}}, at("2006-03-12T18:01:10"), 40.0)});
  WriteLevel2(files / "b",
    {ConstantVolume({"KLSX", Position{38.699, -90.683, 214.0}}, at("2006-03-12T18:41:00"), 30.0)});
  const auto draw = [&](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments = {
      "render", files, "-o", folder.Path() / "x.png", "--size", small, "--dims", "32x32x16"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return run;
  };
  const ProgramRun one = draw({});
  EXPECT_EQ(one.output, (folder.Path() / "x.png").string() + "\n");
  EXPECT_NE(one.errors.find("one picture of all radars, at 2006-03-12T18:21"), std::string::npos)
    << one.errors;
  EXPECT_NE(draw({"--step", "10min"}).errors.find("4 times make as many"), std::string::npos);
}

TEST(RenderCommand, LinesOfAColourTableThatCannotBeReadAreNamed)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 1);
  const fs::path table = folder.Path() / "my.pal";
  std::ofstream(table) << "TABLE BY somebody\nColor: 0 0 0 255\nColor: 60 255 0 0\n";
  const ProgramRun run = RunNexrad3d({"render", series, "-o", folder.Path() / "a.png", "--size",
    small, "--colours", table, "--quiet"});
  EXPECT_EQ(run.status, 0);
  EXPECT_NE(run.errors.find("my.pal: passed over: line 1: 'TABLE BY somebody'"), std::string::npos)
    << run.errors;
}

TEST(RenderCommand, Mp4NeedsFfmpegAndSaysSo)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 3);
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const ProgramRun run =
    RunNexrad3d({"render", series, "-o", folder.Path() / "storm.mp4", "--size", small});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("ffmpeg"), std::string::npos) << run.errors;
  EXPECT_NE(run.errors.find(".ogv"), std::string::npos) << run.errors;
  EXPECT_FALSE(fs::exists(folder.Path() / "storm.mp4"));
}

TEST(RenderCommand, RadarFilesAreMergedFirst)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const ProgramRun run =
    RunNexrad3d({"render", data / "level2" / "run-kbgm-20050821", "-o", folder.Path() / "kbgm.png",
      "--size", small, "--dims", "64x64x32", "--time", "2005-08-21T02:56:30"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(NamesIn(folder.Path()), std::set<std::string>{"kbgm.png"});
}

TEST(RenderCommand, ABoxOfRadarFilesIsDrawnWhereItsEchoIs)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const auto draw = [&](const std::vector<std::string>& options)
  {
    const std::string png = folder.Path() / "box.png";
    std::vector<std::string> arguments = {"render", data / "level2" / "run-kbgm-20050821", "-o",
      png, "--size", small, "--dims", "64x64x32", "--time", "2005-08-21T03:05"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0) << run.errors;
    return FileContent(png);
  };
  const std::string box = "--box=-30km,60km,90km,150km";
  const std::string still = draw({box});
  EXPECT_NE(draw({}), still);
  EXPECT_NE(draw({box, "--follow-from", "2005-08-21T02:50"}), still);
  EXPECT_EQ(draw({box, "--follow-from", "2005-08-21T03:05"}), still);
}

// One radar file is drawn without a word on times; a time at which nothing was scanned is named.
TEST(RenderCommand, OneRadarFileIsDrawnAtItsMiddle)
{
  const TemporaryFolder folder;
  const Site site = {"KEAX", Position{38.81, -94.264, 333.0}};
  const std::string file = WriteLevel2(
    folder.Path() / "one", {ConstantVolume(site, *ParseIso8601("2006-03-12T18:01:10"), 40.0)});
  const std::string png = folder.Path() / "one.png";
  const ProgramRun run =
    RunNexrad3d({"render", file, "-o", png, "--size", small, "--dims", "32x32x16"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_EQ(run.output, png + "\n");
  for (const char* time : {"2006-03-12T18:01:09", "2006-03-12T18:02", "2016-03-12"})
  {
    const ProgramRun outside = RunNexrad3d(
      {"render", file, "-o", png, "--size", small, "--dims", "32x32x16", "--time", time});
    EXPECT_EQ(outside.status, 1) << time;
    EXPECT_NE(outside.errors.find("2006-03-12T18:01:10.000Z to 2006-03-12T18:01:17.180Z"),
      std::string::npos)
      << outside.errors;
    EXPECT_EQ(outside.errors.find('\n'), outside.errors.size() - 1) << outside.errors;
  }
}

TEST(RenderCommand, FailuresAreOneLine)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 3);
  std::ofstream(folder.Path() / "broken.nxv") << "NXV1 and nothing more";
  std::ofstream(folder.Path() / "broken.vti") << "<VTKFile";
  std::ofstream(folder.Path() / "colours.csv") << "dbz,colour\n5,#000000\n1,#ffffff\n";
  std::ofstream(folder.Path() / "plain.csv") << "dbz,colour\n5,#000000\n9,#ffffff\n";
  const std::string radar = WriteLevel2(folder.Path() / "radar",
    {ConstantVolume({"KEAX", Position{38.81, -94.264, 333.0}}, *ParseIso8601("2006-03-12"), 40.0)});
  fs::create_symlink("/dev/full", folder.Path() / "full.png");
  const std::string png = folder.Path() / "x.png";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
    {{folder.Path() / "none.nxv", "-o", png}, "none.nxv"},
    {{folder.Path() / "broken.nxv", "-o", png}, "broken.nxv"},
    {{folder.Path() / "broken.vti", "-o", png}, "broken.vti"},
    {{series, "-o", png, "--time", "2006-03-12T18:36"}, "18:30"},
    {{series, "-o", folder.Path() / "no" / "x.png", "--time", "2006-03-12T18:35"}, "no/x.png"},
    {{series, "-o", folder.Path() / "no" / "x.ogv"}, "no/x.ogv"},
    {{series, "-o", folder.Path() / "full.png", "--time", "2006-03-12T18:35"}, "full.png"},
    {{series, "-o", png, "--time", "2006-03-12T18:35", "--map", "25km"}, "from 0 km to 20 km"},
    {{series, "-o", png, "--time", "2006-03-12T18:35", "--map", "vil", "--array", "REF_age"},
      "computed of REF"},
    {{series, "-o", png, "--time", "2006-03-12T18:35", "--map", "3km", "--array", "REF_age"},
      "no array REF_age"},
    {{series, "-o", png, "--colours", folder.Path() / "colours.csv"}, "line 3"},
    {{series, "-o", png, "--box", "0,20km,0,20km"}, "from radar files alone"},
    {{radar, "-o", png, "--box=-95deg,-94deg,38deg,39deg"},
      "the box is in degrees, and the volume is in metres"},
    {{series, "-o", png, "--opacities", folder.Path() / "plain.csv"}, "has no opacities"},
    {{series, "-o", png, "--crop=-91deg,-90deg,38deg,39deg,0,15km"}, "volume is in metres"},
    {{series, "/dev/null", "-o", png}, "one or the other"}};
  for (const auto& [options, words] : cases)
  {
    std::vector<std::string> arguments = {"render", "--size", small};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 1) << words;
    EXPECT_NE(run.errors.find(words), std::string::npos) << words << " in: " << run.errors;
    EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
    EXPECT_FALSE(fs::exists(png));
  }
}

// VTK drew a coloured line in its place.
TEST(RenderCommand, OneLayerIsNotDrawnAsAVolume)
{
  const TemporaryFolder folder;
  const std::string radar = WriteLevel2(folder.Path() / "radar",
    {ConstantVolume({"KEAX", Position{38.81, -94.264, 333.0}}, *ParseIso8601("2006-03-12"), 40.0)});
  const fs::path layer = folder.Path() / "layer";
  ASSERT_EQ(RunNexrad3d({"grid", radar, "-o", layer, "--dims", "16x16x1"}).status, 0);
  const fs::path picture = folder.Path() / "x.png";
  const ProgramRun refused = RunNexrad3d({"render", layer, "-o", picture, "--size", small});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.errors.find("16x16x1"), std::string::npos) << refused.errors;
  EXPECT_FALSE(fs::exists(picture));
  const ProgramRun drawn =
    RunNexrad3d({"render", layer, "-o", picture, "--size", small, "--map", "composite"});
  EXPECT_EQ(drawn.status, 0) << drawn.errors;
}

// A movie that is stopped leaves no hidden file behind.
TEST(RenderCommand, CtrlCLeavesNoFile)
{
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 3);
  const fs::path made = folder.Path() / "made";
  fs::create_directory(made);
  const ProgramRun run = InterruptProgram(
    Nexrad3dPath(), {"render", series, "-o", made / "x.ogv", "--size", small, "--frames", "100000"},
    [&made] { return !fs::is_empty(made); }, SIGINT);
  EXPECT_EQ(run.status, 1) << run.errors;
  EXPECT_NE(run.errors.find("stopped before all was drawn"), std::string::npos) << run.errors;
  EXPECT_TRUE(fs::is_empty(made));
}

TEST(RenderCommand, WithoutADisplayItSaysSo)
{
  const NoDisplay none;
  const TemporaryFolder folder;
  const fs::path series = WriteStormFiles(folder.Path(), 3);
  const ProgramRun run = RunNexrad3d({"render", series, "-o", folder.Path() / "x.png"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("xvfb-run"), std::string::npos) << run.errors;
  EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << run.errors;
}

// Radar files whose moments the picture needs are merged for it; from volumes they are read.
TEST(RenderCommand, ColoursFromAnotherArray)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const TemporaryFolder folder;
  const fs::path files = data / "level2" / "run-kbgm-20050821";
  const auto draw =
    [&](const fs::path& input, const std::string& name, const std::vector<std::string>& options)
  {
    std::vector<std::string> arguments = {"render", input, "-o", folder.Path() / name, "--size",
      small, "--time", "2005-08-21T02:55", "--dims", "32x32x16", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const ProgramRun done = RunNexrad3d(arguments);
    EXPECT_EQ(done.status, 0) << done.errors;
    return FileContent(folder.Path() / name);
  };
  const auto merge = [&](const fs::path& volumes, bool ancillary)
  {
    std::vector<std::string> arguments = {"grid", files, "-o", volumes, "--moment", "REF,VEL",
      "--code", "exact", "--dims", "32x32x16", "--quiet"};
    if (ancillary)
    {
      arguments.emplace_back("--ancillary");
    }
    const ProgramRun merged = RunNexrad3d(arguments);
    EXPECT_EQ(merged.status, 0) << merged.errors;
  };
  const fs::path volumes = folder.Path() / "volumes";
  merge(volumes, false);
  const fs::path withAges = folder.Path() / "with-ages"; // captions state the age where it is known
  merge(withAges, true);
  std::set<std::string> pictures = {draw(files, "a.png", {})};
  for (const char* array : {"VEL", "REF_age", "REF_site"})
  {
    const std::string picture = draw(files, "b.png", {"--colour-by", array});
    const fs::path& merged = array == std::string("VEL") ? volumes : withAges;
    EXPECT_EQ(picture, draw(merged, "c.png", {"--colour-by", array})) << array;
    pictures.insert(picture);
  }
  const std::string velocity = draw(files, "d.png", {"--moment", "VEL"});
  EXPECT_EQ(velocity, draw(volumes, "e.png", {"--moment", "VEL"}));
  pictures.insert(velocity);
  EXPECT_EQ(pictures.size(), 5U);
  const ProgramRun absent = RunNexrad3d({"render", volumes, "-o", folder.Path() / "f.png", "--size",
    small, "--colour-by", "SW", "--quiet"});
  EXPECT_EQ(absent.status, 1);
  EXPECT_NE(absent.errors.find("has no SW; it has REF, VEL"), std::string::npos) << absent.errors;
  EXPECT_EQ(RunNexrad3d({"render", volumes, "-o", folder.Path() / "f.png", "--map", "3km",
                          "--colour-by", "VEL"})
              .status,
    2);
}

namespace
{

// A volume that is wider than the texture of any OpenGL, with the same echo everywhere.
fs::path WriteWideVolume(const fs::path& folder)
{
  GriddedVolume wide = MakeStorm(true);
  wide.grid.dimensions = {40'000, 3, 3};
  wide.grid.spacing = {12.0, 100'000.0, 10'000.0};
  wide.values.assign(wide.grid.VoxelCount(), 40.0F);
  wide.states.assign(wide.grid.VoxelCount(), VoxelState::Echo);
  WriteNxv(folder / "wide.nxv", wide);
  return folder / "wide.nxv";
}

} // namespace

// Slices draw it; VTK's ray caster cannot. An empty sky would look like no echo.
TEST(RenderCommand, AWideVolumeIsDrawnOrALineSaysWhyNot)
{
  const TemporaryFolder folder;
  const fs::path volume = WriteWideVolume(folder.Path());
  const std::vector<std::vector<std::string>> modes = {{"volume.png"},
    {"surface.png", "--iso-values", "30"}, {"rays.png", "--mapper", "ray-cast"},
    {"movie.ogv", "--frames", "3"}};
  for (std::vector<std::string> mode : modes)
  {
    mode.front() = folder.Path() / mode.front();
    mode.insert(mode.begin(), {"render", volume, "--size", small, "-o"});
    const bool casts = mode.back() == "ray-cast";
    const ProgramRun run = RunNexrad3d(mode);
    EXPECT_EQ(run.status, casts ? 1 : 0) << run.errors;
    if (casts)
    {
      EXPECT_NE(run.errors.find("the volume has 40000x3x3: draw it by --mapper texture-slice"),
        std::string::npos)
        << run.errors;
      EXPECT_NE(run.errors.find("--dims"), std::string::npos) << run.errors;
      EXPECT_EQ(run.errors.find('\n'), run.errors.size() - 1) << "one line: " << run.errors;
    }
    else
    {
      EXPECT_EQ(run.errors, "");
    }
  }
}

// What needs no texture of the volume has all of it.
TEST(RenderCommand, MapsAndModelsOfAWideVolumeAreWhole)
{
  const TemporaryFolder folder;
  const fs::path volume = WriteWideVolume(folder.Path());
  const std::vector<std::vector<std::string>> modes = {{"map.png", "--map", "composite"},
    {"map.tif", "--map", "composite"}, {"model.glb", "--iso-values", "30"}};
  for (std::vector<std::string> mode : modes)
  {
    mode.front() = folder.Path() / mode.front();
    mode.insert(mode.begin(), {"render", volume, "--size", small, "-o"});
    const ProgramRun run = RunNexrad3d(mode);
    EXPECT_EQ(run.status, 0) << run.errors;
    EXPECT_EQ(run.errors, "");
  }
}

// Whatever VTK or OpenGL complains of while a picture is drawn.
TEST(PictureWindow, AnErrorWhileAPictureIsDrawnIsAFailure)
{
  application::TakeVtkErrors();
  vtkNew<vtkRenderer> renderer;
  scene::PictureWindow window(renderer, {64, 48});
  EXPECT_NE(window.Draw(), nullptr);
  vtkNew<vtkCallbackCommand> complain;
  complain->SetCallback([](vtkObject* drawn, unsigned long, void*, void*)
    { vtkErrorWithObjectMacro(drawn, << "the texture has no room"); });
  const unsigned long tag = renderer->AddObserver(vtkCommand::EndEvent, complain);
  EXPECT_EQ(MessageOf([&window] { window.Draw(); }), std::string("the texture has no room"));
  renderer->RemoveObserver(tag);
  EXPECT_NE(window.Draw(), nullptr);
}
