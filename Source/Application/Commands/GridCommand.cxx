// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/LoadedCommands.h"
#include "Libraries/VtkErrors.h"
#include "Options/ThreadOptions.h"
#include "Options/UnitOptions.h"
#include "Output/BiasOutput.h"
#include "Output/EchoReport.h"
#include "Output/MessageOutput.h"
#include "Output/ProgressBar.h"
#include "Parallel/JoinedProcesses.h"
#include "Volumes/WriteVolumes.h"
#include "vtkNexradProcesses.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <string>

namespace nexrad::application
{
namespace
{

struct GridCommandOptions
{
  GridJob job;
  bool quiet = false;
  bool json = false;
  // Until the program has said what went wrong: mpiexec ends all processes as soon as one has left
  // them with a failure.
  std::shared_ptr<vtkMultiProcessController> joined;
};

// Which formats have which options.
void CheckFormat(const GridJob& job)
{
  if (job.written.encoding && job.written.format != VolumeFormat::Nxv)
  {
    throw CLI::ValidationError("--code", "is of --format nxv alone");
  }
  if (job.perRadar && job.options.method == MergeMethod::Thesis)
  {
    throw CLI::ValidationError("--per-radar", "is of the method 'beam'");
  }
  if (job.oneFile && job.written.format != VolumeFormat::NetCDF)
  {
    throw CLI::ValidationError("--one-file", "is of --format nc alone");
  }
}

// The command, but for the names of its files: what a volume's origin is, for other programs.
std::string HistoryOf(const CLI::App& command)
{
  std::string history = "nexrad3d " NEXRAD_VERSION " grid";
  history += command.count("--per-radar") > 0 ? " --per-radar" : "";
  for (const Setting<MergeOptions>& setting : MergeSettings())
  {
    const std::string name = setting.Option();
    if (setting.use == SettingUse::Result && command.count(name) > 0)
    {
      history += ' ' + name;
      history += setting.IsFlag() ? "" : ' ' + command.get_option(name)->as<std::string>();
    }
  }
  return history;
}

// `noun` is what a file is called.
void PrintReport(const GridReport& report, const char* noun, QualityLevel level)
{
  for (std::size_t i = 0; i < report.indices.size(); ++i)
  {
    std::cout << (i > 0 ? ", " : "") << report.indices[i].string();
  }
  std::cout << ": " << Counted(report.files.size(), noun) << ", " << Counted(report.bytes, "byte")
            << '\n';
  if (report.echo)
  {
    std::cout << DescribeTakenOut(*report.echo, level) << '\n';
  }
  PrintBiases(report.comparison, report.takenOff, std::cout);
}

nlohmann::ordered_json MakeJson(const GridReport& report)
{
  const bool ends = !report.indices.empty(); // else it is a task, which others follow
  nlohmann::ordered_json json = {
    {"index", ends ? nlohmann::ordered_json(report.indices.front().string()) : nullptr},
    {"volumes", nlohmann::ordered_json::array()}, {"bytes", report.bytes},
    {"problems", report.problems}, {"notes", report.notes},
    {"radars", MakeBiasJson(report.comparison, report.takenOff)},
    {"echo", report.echo ? MakeEchoJson(*report.echo) : nlohmann::ordered_json()}};
  for (const std::filesystem::path& file : report.files)
  {
    json["volumes"].push_back(file.string());
  }
  for (const std::filesystem::path& index : report.indices)
  {
    json["indices"].push_back(index.string());
  }
  return json;
}

int RunGrid(GridCommandOptions& options)
{
  options.joined = JoinProcesses();
  const Processes processes = vtkNexradProcessesOf(options.joined.get());
  ProgressBar bar("merging", options.quiet || !processes.IsFirst());
  WatchStopSignals();
  const GridReport report = WriteVolumes(
    options.job, [&bar](double fraction) { return bar.Update(fraction); }, processes);
  bar.Clear();
  const int status = report.problems.empty() ? Done : DoneWithDamage;
  if (!processes.IsFirst())
  {
    return status;
  }
  if (options.json)
  {
    PrintJson(MakeJson(report));
  }
  else if (report.indices.empty())
  {
    std::cout << (options.quiet ? ""
                                : Counted(report.files.size(), "file") + " for further tasks\n");
  }
  else if (!options.quiet)
  {
    PrintReport(report, options.job.oneFile ? "file" : "volume", options.job.options.quality.level);
  }
  PrintMessages(report.problems);
  PrintMessages(report.notes);
  return status;
}

} // namespace

NEXRAD_ADD_OPTIONS(grid)(CLI::App& command, CommandAction& action)
{
  const auto options = std::make_shared<GridCommandOptions>();
  command
    .add_option("input", options->job.inputs, "Level II files, chunk folders, folders of these")
    ->required()
    ->type_name("INPUT");
  command
    .add_option("-o,--output", options->job.folder,
      "Folder that takes the volumes and their index; made when it does not exist")
    ->required()
    ->type_name("DIR");
  const auto formats = ChoiceValue<VolumeFormat>(
    "format of volumes", {{"nxv", VolumeFormat::Nxv}, {"nc", VolumeFormat::NetCDF}});
  AddValueOption(command, "--format", options->job.written.format, formats,
    "nxv: compressed volumes of this project; nc: NetCDF with the CF conventions, for other "
    "programs");
  command.add_flag("--one-file", options->job.oneFile,
    "Write all times into one file, volumes.nc (default: a file for each time); of --format nc");
  command.add_flag("--per-radar", options->job.perRadar,
    "Write a volume of each radar alone, on the grid of all, with azimuth, elevation, slant range "
    "and "
    "age, as multi-Doppler analysis needs them (default: merge the radars)");
  const auto codes = ChoiceValue<NxvEncoding>(
    "code of volumes", {{"radar", NxvEncoding::RadarSteps}, {"exact", NxvEncoding::Float}});
  AddParsedOption(command, "--code", options->job.written.encoding, codes.parse, codes.unit,
    "How nxv stores values: radar (the steps that the radar sends; half dBZ for REF), or exact "
    "(default: radar; of the method thesis its own code, whole dBZ from 1 to 80)");
  AddParsedOption(command, "--task", options->job.task, ParseGridTask, "TASK",
    "Do a part of the run alone, of volumes of more than 134 million voxels: scan:K/N (find out "
    "what part K of N of the files hold), then rows:K/N (make part K of N of the rows), then join "
    "(default: the whole run)");
  command.add_flag("--json", options->json, "Print what was made as JSON (default: lines of text)");
  AddQuietOption(command, options->quiet);
  AddGridOptions(command, options->job.options);
  AddThreadsOption(command);
  command.callback(
    [options, &action, &command]
    {
      CheckFormat(options->job);
      options->job.options.beam.ancillary |= options->job.perRadar;
      const auto written = [&command](const char* name)
      { return command.count(name) > 0 ? command.get_option(name)->as<std::string>() : ""; };
      options->job.recipe =
        RecipeOf("nexrad3d " NEXRAD_VERSION " grid\n--format " + written("--format") + "\n--code " +
                   written("--code") + (options->job.oneFile ? "\n--one-file" : "") +
                   (options->job.perRadar ? "\n--per-radar" : ""),
          options->job.options);
      for (const std::filesystem::path& input : options->job.inputs)
      {
        options->job.recipe += '\n' + input.string();
      }
      options->job.written.history = HistoryOf(command);
      action = [options] { return FailOnVtkErrors([&] { return RunGrid(*options); }); };
    });
}

} // namespace nexrad::application
