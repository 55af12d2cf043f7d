// SPDX-License-Identifier: BSD-3-Clause
#include "ProgramRun.h"
#include "TestData.h"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

using namespace nexrad::testing;
namespace fs = std::filesystem;

namespace
{

using Arguments = std::vector<std::string>;

// One line, which ends.
bool IsOneLine(const std::string& text)
{
  return !text.empty() && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

// Runs a command line that is wrong, and expects one line that contains `words`.
void ExpectWrongUsage(const Arguments& arguments, const std::vector<std::string>& words)
{
  const ProgramRun run = RunNexrad3d(arguments);
  EXPECT_EQ(run.status, 2) << run.errors;
  EXPECT_EQ(run.output, "");
  EXPECT_TRUE(IsOneLine(run.errors)) << run.errors;
  for (const std::string& word : words)
  {
    EXPECT_NE(run.errors.find(word), std::string::npos) << word << " in: " << run.errors;
  }
}

void ExpectFailure(const Arguments& arguments, const std::vector<std::string>& words)
{
  const ProgramRun run = RunNexrad3d(arguments);
  EXPECT_EQ(run.status, 1) << run.errors;
  EXPECT_TRUE(IsOneLine(run.errors)) << run.errors;
  for (const std::string& word : words)
  {
    EXPECT_NE(run.errors.find(word), std::string::npos) << word << " in: " << run.errors;
  }
}

/// CLI11 writes a default as NAME=DEFAULT, from 2.4 on as NAME [DEFAULT]: always the first.
std::string WithEqualSigns(std::string help)
{
  std::size_t open = help.find(" [");
  while (open != std::string::npos)
  {
    help.replace(open, 2, "=");
    const std::size_t close = help.find(']', open);
    if (close != std::string::npos)
    {
      help.erase(close, 1);
    }
    open = help.find(" [", open);
  }
  return help;
}

} // namespace

TEST(Usage, HelpAndVersionAreNoFailure)
{
  EXPECT_EQ(RunNexrad3d({"--version"}).output.rfind("nexrad3d ", 0), 0U);
  for (const Arguments& arguments :
    {Arguments{"--help"}, {"info", "--help"}, {"grid", "--help"}, {"render", "--help"}})
  {
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.errors, "");
    EXPECT_NE(run.output.find("--help"), std::string::npos);
  }
}

TEST(Usage, HelpHasUnitsAndDefaults)
{
  const std::string help = WithEqualSigns(RunNexrad3d({"grid", "--help"}).output);
  for (const char* text :
    {"--dims XxYxZ=256x256x128", "--step DURATION=5min", "--max-gap DURATION=15min",
      "--range LENGTH=230km", "--height LOWER,UPPER=0,20km", "--moment NAME,...=REF",
      "--method NAME=beam", "--format NAME=nxv", "--overlap NAME=distance",
      "--overlap-length LENGTH=100km", "--fill-columns", "--linear-reflectivity", "--ancillary",
      "--motion MOTION=estimated", "--memory SIZE", "--threads NUMBER", "--no-sharpening",
      "--despeckle NUMBER=0", "--no-dealiasing", "--storm-motion EAST,NORTH", "--bias BIAS=off",
      "--quality NAME=standard", "degrees", "km", "UTC"})
  {
    EXPECT_NE(help.find(text), std::string::npos) << text;
  }
}

TEST(Usage, AWrongCommandNamesTheCommands)
{
  ExpectWrongUsage({}, {"a command is missing", "info", "grid", "render"});
  ExpectWrongUsage({"gird"}, {"unknown command 'gird'", "grid"});
}

TEST(Usage, WrongOptionsAreNamed)
{
  ExpectWrongUsage({"grid"}, {"input"});
  ExpectWrongUsage({"grid", "a"}, {"--output"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--frobnicate"}, {"--frobnicate"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--code", "raw"}, {"--code", "radar or exact"});
  ExpectWrongUsage(
    {"grid", "a", "-o", "b", "--code", "exact", "--format", "nc"}, {"--code", "nxv alone"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--code", "thesis"}, {"--code", "radar or exact"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--moment", "VEL", "--overlap", "mean"},
    {"--overlap", "nearest alone"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--step"}, {"--step"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--step", "0"}, {"--step", "above 0"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--step", "5minutes"}, {"--step", "5min"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--bounds", "-86,36,-97,43"},
    {"--bounds", "its lower bound above its upper bound"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--axes", "polar"}, {"--axes", "geographic"});
  ExpectWrongUsage({"render", "a", "-o", "b.ogv", "--fly"}, {"--fly", "--look-at or --zoom"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--height", "20km,0"},
    {"--height", "its lower bound above its upper bound"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--range", "0"}, {"--range"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--dims", "0x256x128"}, {"--dims"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--begin", "yesterday"}, {"--begin", "UTC"});
  ExpectWrongUsage(
    {"grid", "a", "-o", "b", "--begin", "2006-03-12", "--end", "2006-03-11"}, {"--end", "--begin"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--bounds", "-97,36,-86,43", "--range", "5km"},
    {"--range", "--bounds"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--moment", "DBZ"}, {"--moment", "REF"});
  ExpectWrongUsage(
    {"grid", "a", "-o", "b", "--moment", "VEL", "--method", "thesis"}, {"--moment", "REF"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--method", "bin"}, {"--method", "beam", "thesis"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--motion", "fast"}, {"--motion", "none", "12,-7.5"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--motion", "90,-130"}, {"--motion", "150 m/s"});
  ExpectWrongUsage(
    {"grid", "a", "-o", "b", "--motion", "1,2", "--method", "thesis"}, {"--motion", "beam"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--format", "hdf"}, {"--format", "nxv", "nc"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--one-file"}, {"--one-file", "nc alone"});
  ExpectWrongUsage(
    {"grid", "a", "-o", "b", "--per-radar", "--method", "thesis"}, {"--per-radar", "beam"});
  ExpectWrongUsage({"grid", "a", "-o", "b", "--site", "ZZZZ"}, {"--site", "ZZZZ"});
}

TEST(Usage, WrongOptionsOfTheMethodBeamAreNamed)
{
  const auto expect = [](Arguments options, const std::vector<std::string>& words)
  {
    options.insert(options.begin(), {"grid", "a", "-o", "b"});
    ExpectWrongUsage(options, words);
  };
  expect({"--overlap", "median"}, {"--overlap", "mean, nearest, maximum or distance"});
  expect({"--overlap-length", "0"}, {"--overlap-length", "100km"});
  expect({"--overlap-length", "far"}, {"--overlap-length", "km"});
  expect({"--overlap", "mean", "--overlap-length", "50km"}, {"--overlap-length", "distance"});
  expect({"--moment", "ZDR", "--linear-reflectivity"}, {"--linear-reflectivity", "REF"});
  expect({"--moment", "ZDR", "--no-sharpening"}, {"--no-sharpening", "REF"});
  expect({"--linear-reflectivity", "--no-sharpening"}, {"--no-sharpening", "dBZ"});
  expect({"--memory", "lots"}, {"--memory", "512MiB"});
  const std::vector<Arguments> ofBeam = {{"--overlap", "mean"}, {"--overlap-length", "50km"},
    {"--fill-columns"}, {"--linear-reflectivity"}, {"--no-sharpening"}, {"--ancillary"}};
  for (Arguments options : ofBeam)
  {
    const std::string name = options.front();
    options.insert(options.end(), {"--method", "thesis"});
    expect(options, {name, "beam"});
  }
}

TEST(Usage, WrongMapsAreNamed)
{
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--map", "top"},
    {"--map", "composite", "lowest", "vil-density", "3km"});
  for (const char* map : {"vil-density:", "vil-density:x", "vil-density:101", "vil-density30"})
  {
    ExpectWrongUsage({"render", "a", "-o", "b.png", "--map", map}, {"--map", "vil-density:30"});
  }
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--array", "REF_age"}, {"--array", "--map"});
}

TEST(Usage, WrongOptionsOfRenderAreNamed)
{
  ExpectWrongUsage({"render", "a", "-o", "b.gif"}, {"--output", ".png"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--size", "1280"}, {"--size", "1280x720"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--tilt", "91"}, {"--tilt", "90"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--zoom", "0"}, {"--zoom"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--zoom", "nan"}, {"--zoom", "0.01 to 1000"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--exaggeration", "-1"}, {"--exaggeration"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--shadow", "1.5"}, {"--shadow", "1.5"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--occlusion", "nan"}, {"--occlusion"});
  for (const char* light : {"90", "90,91", "400,10", "90,", "90,10km", "nan,10"})
  {
    ExpectWrongUsage({"render", "a", "-o", "b.png", "--light", light}, {"--light", "250,45"});
  }
  for (const char* place : {"35", "35,", "91,10", "35,-97,", "35,-97,4", "35,-97,4km,1", "nan,10"})
  {
    ExpectWrongUsage({"render", "a", "-o", "b.png", "--look-at", place}, {"--look-at"});
  }
  for (const char* option : {"--azimuth", "--clip", "--colours", "--crop", "--iso-values",
         "--look-at", "--map", "--preset"})
  {
    ExpectWrongUsage({"render", "a", "-o", "b.png", option, ""}, {option, "'' is no value; write"});
  }
  for (const char* values : {",", "20,", "20:", "20:0", "20:1.5", "20:0.5:1", "20;40", "nan",
         "1e999", "20:nan", "20:0.3,30:x", "20dBZ"})
  {
    ExpectWrongUsage({"render", "a", "-o", "b.png", "--iso-values", values},
      {"--iso-values", "no iso-value", "20:0.3,40:0.6,50:1"});
  }
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--iso-values", "20,35:0.5,20:0.4"},
    {"--iso-values", "'20:0.4' twice"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--iso-values", "20", "--map", "composite"},
    {"--iso-values", "a map has no surfaces"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--slices", "-1"}, {"--slices", "0"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--mapper", "x"}, {"--mapper", "texture-slice"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--theme", "x"}, {"--theme", "dark or light"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--classification", "x"},
    {"--classification", "pre-integrated", "sampled"});
  ExpectWrongUsage({"render", "a", "-o", "b.png", "--colours", "/none"}, {"--colours", "/none"});
  ExpectWrongUsage({"render", "a", "-o", "b.ogv", "--fps", "0"}, {"--fps"});
}

TEST(Usage, WrongOptionsOfViewAreNamed)
{
  ExpectWrongUsage({"view", "a", "--interval", "0.001s"}, {"no interval"});
  ExpectWrongUsage({"view", "a", "--preset", "rainbow"}, {"storm cores"});
  ExpectWrongUsage({"view", "a", "--pictures", "/nonexistent"}, {"--pictures"});
}

// As a build without Qt leaves it: the program alone, without the library of the window.
TEST(Usage, WithoutTheLibraryOfTheWindowViewSaysWhatItNeeds)
{
  const TemporaryFolder folder;
  const fs::path program = folder.Path() / "bin" / "nexrad3d";
  fs::create_directory(program.parent_path());
  fs::copy_file(Nexrad3dPath(), program);
  const fs::path libraries = fs::path(Nexrad3dPath()).parent_path() / ".." / "lib";
  setenv("LD_LIBRARY_PATH", libraries.c_str(), 1);
  const ProgramRun run = RunProgram(program, {"view", "a"});
  unsetenv("LD_LIBRARY_PATH");
  EXPECT_EQ(run.status, 1);
  EXPECT_TRUE(IsOneLine(run.errors)) << run.errors;
  EXPECT_NE(run.errors.find("nexrad3d-window, which needs Qt 5"), std::string::npos) << run.errors;
}

TEST(Usage, InputsThatDoNotExist)
{
  const TemporaryFolder folder;
  const std::string output = folder.Path() / "out";
  const std::string none = folder.Path() / "none";
  ExpectFailure({"grid", none, "-o", output}, {none});
  fs::create_directory(folder.Path() / "empty");
  ExpectFailure({"grid", folder.Path() / "empty", "-o", output}, {"empty"});
  std::ofstream(folder.Path() / "text.txt") << "This is no radar file.";
  ExpectFailure({"grid", folder.Path() / "text.txt", "-o", output}, {"text.txt"});
  EXPECT_FALSE(fs::exists(output)) << "nothing was made, so no folder either";
}

// A program that mpiexec started may start others, which inherit its variables.
TEST(Usage, AForeignLauncherSilencesNothing)
{
  setenv("OMPI_COMM_WORLD_RANK", "3", 1);
  for (const char* count : {"4", "2", "many"})
  {
    setenv("OMPI_COMM_WORLD_SIZE", count, 1);
    const Arguments wrong = {"-c", Nexrad3dPath() + " grid --dims x /nonexistent -o out; exit $?"};
    const ProgramRun usage = RunProgram("/bin/sh", wrong);
    EXPECT_EQ(usage.status, 2) << count;
    EXPECT_TRUE(IsOneLine(usage.errors)) << usage.errors;
    const Arguments missing = {"-c", Nexrad3dPath() + " info /nonexistent; exit $?"};
    const ProgramRun failure = RunProgram("/bin/sh", missing);
    EXPECT_EQ(failure.status, 1) << count;
    EXPECT_NE(failure.errors.find("/nonexistent"), std::string::npos) << failure.errors;
  }
  unsetenv("OMPI_COMM_WORLD_RANK");
  unsetenv("OMPI_COMM_WORLD_SIZE");
}

TEST(Usage, ControlCharactersOfFileNamesAreShownAsText)
{
  const ProgramRun run = RunNexrad3d({"info", "/nonexistent/\x1b[31mred\a\xc2\x9bJ é"});
  EXPECT_EQ(run.status, 1);
  EXPECT_NE(run.errors.find("/nonexistent/\\x1b[31mred\\x07"), std::string::npos) << run.errors;
  EXPECT_EQ(run.errors.find('\x1b'), std::string::npos);
  EXPECT_EQ(run.errors.find("\xc2\x9b"), std::string::npos);
  EXPECT_NE(run.errors.find(" é"), std::string::npos);
}

TEST(Usage, AnEmptyNameOfAFolder)
{
  const TemporaryFolder folder;
  ExpectFailure({"simulate", "", "--hours", "0.1"}, {"the folder to write to is empty"});
}

// Whoever reads a log by lines finds each message whole.
TEST(Usage, AMessageIsOneLineWhateverTheNameOfTheFile)
{
  const TemporaryFolder folder;
  const std::string name = folder.Path() / "two\nlines";
  std::ofstream(name) << "This is no radar file.";
  fs::create_directory(folder.Path() / "in");
  std::ofstream(folder.Path() / "in" / "two\nlines") << "This is no radar file.";
  for (const char* ending : {".nxv", ".nxv.series", ".vti", ".json", ".pal", ".nxsession"})
  {
    std::ofstream(name + ending) << "{}";
  }
  const std::string out = folder.Path() / "out";
  const Arguments commands[] = {{"info", name + " none"}, {"wind", name + " none"},
    {"grid", name, "-o", out}, {"grid", folder.Path() / "in", "-o", out},
    {"grid", "in", "-o", name}, {"render", name + ".nxv", "-o", "x.tif", "--map", "composite"},
    {"render", name + ".nxv.series", "-o", "x.tif", "--map", "composite"},
    {"render", name + ".vti", "-o", "x.tif", "--map", "composite"},
    {"web", name + ".nxv.series", "-o", out}, {"web", name + ".nxv", "-o", "x.html"},
    {"watch", name, "-o", name}};
  for (const Arguments& arguments : commands)
  {
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 1) << arguments.front() << run.errors;
    EXPECT_TRUE(IsOneLine(run.errors)) << run.errors;
  }
  ExpectWrongUsage({"render", "a", "-o", name}, {"two"});
}

// Whatever opens a pipe waits until somebody writes into it.
TEST(Usage, PipesAndDevicesAreNamedAndNotOpened)
{
  const TemporaryFolder folder;
  const std::string pipe = folder.Path() / "pipe";
  for (const char* ending : {"", ".nxv", ".nxv.series", ".vti"})
  {
    ASSERT_EQ(mkfifo((pipe + ending).c_str(), 0600), 0);
  }
  const std::string out = folder.Path() / "out";
  const Arguments commands[] = {{"info", pipe}, {"info", "/dev/zero"}, {"wind", pipe},
    {"grid", pipe, "-o", out}, {"grid", "/dev/zero", "-o", out},
    {"render", pipe + ".nxv", "-o", "x.tif", "--map", "composite"},
    {"render", pipe + ".nxv.series", "-o", "x.tif", "--map", "composite"},
    {"render", pipe + ".vti", "-o", "x.tif", "--map", "composite"},
    {"web", pipe + ".nxv", "-o", "x.html"}, {"web", pipe, "-o", out}};
  for (const Arguments& arguments : commands)
  {
    const ProgramRun run = RunNexrad3d(arguments);
    EXPECT_EQ(run.status, 1) << arguments.front() << run.errors;
    EXPECT_TRUE(IsOneLine(run.errors)) << run.errors;
    EXPECT_NE(run.errors.find(arguments[1]), std::string::npos) << run.errors;
  }
}

// A script's shell starts what it runs in the background with SIGINT ignored.
TEST(Usage, TheFirstSignalEndsACommand)
{
  const TemporaryFolder folder;
  const fs::path begun = folder.Path() / "begun";
  const std::string script = "trap '' INT; touch " + begun.string() + "; exec " + Nexrad3dPath() +
                             " simulate " + (folder.Path() / "day").string() +
                             " --hours 24 --quiet";
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    const ProgramRun run = InterruptProgram(
      "/bin/sh", {"-c", script}, [&] { return fs::exists(folder.Path() / "day"); }, signal);
    EXPECT_EQ(run.status, 1) << signal << run.errors;
    fs::remove_all(folder.Path() / "day");
  }
}
