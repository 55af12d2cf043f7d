// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"
#include "Libraries/VtkErrors.h"
#include "Live/WatchRun.h"
#include "Options/ThreadOptions.h"
#include "Options/UnitOptions.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"
#include "nexrad/System/Error.h"
#include "vtkNexradThreads.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <csignal>
#include <iostream>
#include <iterator>
#include <memory>
#include <sstream>

namespace nexrad::application
{
namespace
{

constexpr char group[] = "Following folders";

struct WatchOptions
{
  WatchJob job;
  bool noPicture = false;
  std::string drawing;
  bool quiet = false;
};

// "2006-03-12T18:00,20".
ReplayRequest ParseReplay(const std::string& text)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  const auto time = ParseIso8601(parts.front());
  const std::vector<double> speed = parts.size() == 2 ? FindNumbers(parts[1]) : FindNumbers("");
  if (!time || speed.size() != 1 || !(speed[0] > 0.0 && speed[0] <= 1000.0))
  {
    throw Error("'" + text +
                "' is no time and speed; write as in 2006-03-12T18:00,20: a time in UTC, and how "
                "many times as fast as the real clock, up to 1000");
  }
  return {*time, speed[0]};
}

std::chrono::milliseconds ParsePoll(const std::string& text)
{
  const Duration poll = ParseDuration(text);
  if (poll < std::chrono::milliseconds(50) || poll > std::chrono::minutes(10))
  {
    throw Error("'" + text + "' is no interval; write 0.05s to 10min");
  }
  return poll;
}

void AddWaiting(CLI::App& command, WatchJob& job)
{
  AddParsedOption(command, "--poll", job.poll, ParsePoll, "DURATION",
    "Longest time between two listings of the folders; shorter where a listing is quick", "0.25s")
    ->group(group);
  const auto add =
    [&command](const char* name, auto& duration, const char* description, const char* usual = "")
  {
    AddParsedOption(command, name, duration, ParseDuration, "DURATION", description, usual)
      ->group(group);
  };
  add("--patience", job.intake.patience,
    "How long a chunk is waited for that is missing or half-written; then what follows it is used "
    "without it. When it comes after all, it is used",
    "30s");
  add("--stale", job.stale,
    "A radar whose newest ray is older is STALE, else LIVE; a volume in progress of which nothing "
    "came for so long is taken as it is",
    "10min");
  add("--late", job.late,
    "What arrives later than this after the newest ray changes the series no more", "30min");
  add("--keep", job.keep,
    "Remove volumes of the series that are older than this (default: all stay)");
  add("--stop-after", job.stopAfter,
    "End when nothing arrived for so long: all that is there is finished then (default: follow "
    "until Ctrl+C)");
  AddParsedOption(command, "--replay", job.replay, ParseReplay, "TIME,SPEED",
    "The feed is played again: the clock shows TIME at the start, and runs SPEED times as fast. "
    "All durations here but --poll are by that clock")
    ->group(group);
}

std::vector<std::string> DrawingWords(const std::string& text)
{
  std::istringstream words(text);
  std::vector<std::string> drawing = {
    std::istream_iterator<std::string>(words), std::istream_iterator<std::string>()};
  if (drawing.empty())
  {
    drawing = {"--size", "1280x720"};
  }
  return drawing;
}

int RunWatch(const WatchOptions& options)
{
  WatchStopSignals();
  std::signal(SIGPIPE, SIG_IGN); // the feed is followed when nobody reads the lines any more
  const WatchReport report = WatchFolders(
    options.job,
    [&options](const std::string& line)
    {
      if (!options.quiet)
      {
        std::cout << line << std::endl;
      }
    },
    PrintMessage);
  if (!options.quiet)
  {
    std::cout << options.job.output.string() << ": " << Counted(report.newest, "newest volume")
              << ", " << Counted(report.steps, "volume") << " of the series, "
              << Counted(report.problems, "problem") << '\n';
  }
  if (report.newest == 0 && !IsStopAsked())
  {
    throw Error("nothing arrived of which a volume can be merged");
  }
  return report.problems == 0 ? Done : DoneWithDamage;
}

} // namespace

NEXRAD_ADD_OPTIONS(watch)(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<WatchOptions>();
  WatchJob& job = options->job;
  command
    .add_option("folder", job.folders,
      "Folders with Level II files, chunks named as 20060312-180000-001-S, or folders of these")
    ->required()
    ->type_name("FOLDER");
  command
    .add_option("-o,--output", job.output,
      "Folder that takes newest.nxv, newest.png, the volumes of the time steps with their index, "
      "and status.json; made when it does not exist")
    ->required()
    ->type_name("DIR");
  AddWaiting(command, job);
  CLI::Option* without =
    command.add_flag("--no-picture", options->noPicture, "Draw no picture")->group(group);
  command
    .add_option("--draw", options->drawing,
      "Options of render for the picture, as in \"--size 800x600 --tilt 60\" (default: --size "
      "1280x720)")
    ->type_name("OPTIONS")
    ->excludes(without)
    ->group(group);
  AddQuietOption(command, options->quiet);
  AddGridOptions(command, job.options);
  AddThreadsOption(command);
  command.callback(
    [options, &action, &command]
    {
      WatchJob& given = options->job;
      given.recipe = RecipeOf("nexrad3d watch", given.options);
      given.intake.idle = given.stale;
      given.intake.longestPause = std::max(LongestPause, given.late);
      given.intake.level2.siteName = given.options.siteName;
      given.intake.level2.threads = vtkNexradThreadCount();
      if (!options->noPicture)
      {
        given.drawing = DrawingWords(options->drawing);
        const std::vector<std::string> threads = GivenThreads(command);
        const bool own =
          std::find(given.drawing.begin(), given.drawing.end(), "--threads") != given.drawing.end();
        given.drawing.insert(
          given.drawing.end(), threads.begin(), own ? threads.begin() : threads.end());
      }
      action = [options] { return FailOnVtkErrors([&] { return RunWatch(*options); }); };
    });
}

} // namespace nexrad::application
