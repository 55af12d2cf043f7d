// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/GridCommand.h"

#include "Options/GridOptions.h"
#include "Options/UnitOptions.h"
#include "Output/BiasOutput.h"
#include "Output/Counted.h"
#include "Output/EchoReport.h"
#include "Output/ProgressBar.h"
#include "Output/StopSignal.h"
#include "Parallel/JoinedProcesses.h"
#include "Volumes/WriteVolumes.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

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
  std::optional<JoinedProcesses> joined;
};

VolumeFormat ParseFormat(const std::string& text)
{
  if (text != "nxv" && text != "vti")
  {
    throw Error("'" + text + "' is no format of volumes; write nxv or vti");
  }
  return text == "nxv" ? VolumeFormat::Nxv : VolumeFormat::Vti;
}

NxvEncoding ParseCode(const std::string& text)
{
  constexpr std::pair<const char*, NxvEncoding> names[] = {{"radar", NxvEncoding::RadarSteps},
    {"thesis", NxvEncoding::RunLength}, {"exact", NxvEncoding::Float}};
  for (const auto& [name, encoding] : names)
  {
    if (text == name)
    {
      return encoding;
    }
  }
  throw Error("'" + text + "' is no code of volumes; write radar, thesis or exact");
}

// The codes of the thesis are whole dBZ.
void CheckCode(const GridJob& job)
{
  if (job.nxv.encoding && job.format != VolumeFormat::Nxv)
  {
    throw CLI::ValidationError("--code", "is of --format nxv alone");
  }
  const bool reflectivityAlone =
    job.options.moment == MomentName::REF && job.options.furtherMoments.empty();
  if (job.nxv.encoding == NxvEncoding::RunLength && !reflectivityAlone)
  {
    throw CLI::ValidationError("--code", "'thesis' is of --moment REF alone");
  }
}

// All options that decide what the volumes contain.
std::string RecipeOf(const CLI::App& command, const std::string& format, const std::string& code)
{
  std::string recipe = "nexrad3d " NEXRAD_VERSION "\n--format " + format + "\n--code " + code;
  for (const OptionText& option : GivenGridOptions(command))
  {
    recipe += '\n' + option.name + ' ' + option.value;
  }
  return recipe;
}

void PrintReport(const GridReport& report, QualityLevel level)
{
  std::cout << report.index.string() << ": " << Counted(report.files.size(), "volume") << ", "
            << Counted(report.bytes, "byte") << '\n';
  if (report.echo)
  {
    std::cout << DescribeTakenOut(*report.echo, level) << '\n';
  }
  PrintBiases(report.comparison, report.takenOff, std::cout);
}

void PrintJson(const GridReport& report)
{
  nlohmann::ordered_json json = {{"index", report.index.string()},
    {"volumes", nlohmann::ordered_json::array()}, {"bytes", report.bytes},
    {"problems", report.problems}, {"notes", report.notes},
    {"radars", MakeBiasJson(report.comparison, report.takenOff)},
    {"echo", report.echo ? MakeEchoJson(*report.echo) : nlohmann::ordered_json()}};
  for (const std::filesystem::path& file : report.files)
  {
    json["volumes"].push_back(file.string());
  }
  // A file's name need not be UTF-8; JSON must be.
  std::cout << json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

int RunGrid(GridCommandOptions& options)
{
  const Processes processes = options.joined.emplace().Get();
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
    PrintJson(report);
  }
  else if (!options.quiet)
  {
    PrintReport(report, options.job.options.quality.level);
  }
  for (const std::string& problem : report.problems)
  {
    std::cerr << problem << '\n';
  }
  for (const std::string& note : report.notes)
  {
    std::cerr << note << '\n';
  }
  return status;
}

} // namespace

void AddGridCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<GridCommandOptions>();
  CLI::App* command = program.add_subcommand(
    "grid", "Merge radar files of any number of sites into one volume for each time step");
  command
    ->add_option("input", options->job.inputs, "Level II files, chunk folders, folders of these")
    ->required()
    ->type_name("INPUT");
  command
    ->add_option("-o,--output", options->job.folder,
      "Folder that takes the volumes and their index; made when it does not exist")
    ->required()
    ->type_name("DIR");
  AddParsedOption(*command, "--format", options->job.format, ParseFormat, "NAME",
    "nxv: compressed volumes of this project; vti: VTK XML image data", "nxv");
  AddParsedOption(*command, "--code", options->job.nxv.encoding, ParseCode, "NAME",
    "How nxv stores values: radar (the steps that the radar sends; half dBZ for REF), thesis (REF "
    "alone, whole dBZ from 1 to 80), or exact (default: as --method, radar for beam)");
  command->add_flag(
    "--json", options->json, "Print what was made as JSON (default: lines of text)");
  AddQuietOption(*command, options->quiet);
  AddGridOptions(*command, options->job.options);
  command->callback(
    [options, &action, command]
    {
      CheckCode(options->job);
      const auto written = [command](const char* name)
      { return command->count(name) > 0 ? command->get_option(name)->as<std::string>() : ""; };
      options->job.recipe = RecipeOf(*command, written("--format"), written("--code"));
      action = [options] { return RunGrid(*options); };
    });
}

} // namespace nexrad::application
