// SPDX-License-Identifier: BSD-3-Clause
#include "BenchCommand.h"

#include "Bench/ThesisFigures.h"
#include "BenchRuns.h"
#include "Model/Error.h"
#include "ProgressBar.h"
#include "Temporal/TimeMerge.h"
#include "UnitOptions.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <memory>

namespace nexrad::application
{
namespace
{

std::string ParseMethod(const std::string& text)
{
  if (!ParseMergeMethod(text))
  {
    throw Error("'" + text + "' is no method of merging; nexrad3d grid --help names them");
  }
  return text;
}

void AddInputs(CLI::App& command, BenchOptions& options)
{
  command
    .add_option("input", options.inputs,
      "Radar files, or folders of them (default: a synthetic series is simulated)")
    ->type_name("INPUT");
  command
    .add_option("--hours", options.hours,
      "Length of the synthetic series in hours; from 18:00 UTC on, a whole day from midnight")
    ->type_name("HOURS")
    ->check(CLI::Range(0.25, 24.0))
    ->capture_default_str();
}

void AddDimensions(CLI::App& command, BenchRequest& request)
{
  const auto addDimensions = [&request](const std::string& text)
  {
    try
    {
      request.dimensions.push_back(ParseDimensions(text));
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError("--dims", error.what());
    }
  };
  command
    .add_option_function<std::vector<std::string>>(
      "--dims",
      [addDimensions](const std::vector<std::string>& texts)
      { std::for_each(texts.begin(), texts.end(), addDimensions); },
      "Voxels of the merged volumes; may be given many times (default: the thesis's three)")
    ->allow_extra_args(false)
    ->type_name("XxYxZ");
}

void AddOptions(CLI::App& command, BenchOptions& options)
{
  AddInputs(command, options);
  command
    .add_option("--runs", options.request.runs,
      "How often everything is measured; frames are seen from as many sides")
    ->type_name("NUMBER")
    ->check(CLI::Range(1, 1000))
    ->capture_default_str();
  AddDimensions(command, options.request);
  AddParsedOption(command, "--method", options.request.options.method, ParseMethod, "NAME",
    "How rays become voxels", options.request.options.method);
  command
    .add_option("--only", options.only,
      "These tables alone, as in grid,drawing (default: decode,grid,series,drawing)")
    ->delimiter(',')
    ->check(CLI::IsMember(std::vector<std::string>(std::begin(tableNames), std::end(tableNames))))
    ->allow_extra_args(false)
    ->type_name("NAMES");
  command.add_flag("--json", options.json, "Print JSON, units in the names (default: tables)");
  AddQuietOption(command, options.quiet);
  command
    .add_option("--compare", options.compare,
      "Measure nothing: set two files that --json wrote side by side, on two machines perhaps")
    ->expected(2)
    ->type_name("A B");
}

// What the command line asks for, when it can be met.
CommandAction ChooseWork(const std::shared_ptr<BenchOptions>& options)
{
  if (!options->compare.empty())
  {
    if (!options->inputs.empty())
    {
      throw CLI::ValidationError("--compare", "takes two files that --json wrote, and no INPUT");
    }
    return [options] { return RunBenchComparison(*options); };
  }
  if (options->request.dimensions.empty())
  {
    for (const ThesisFigures& figures : ThesisTables)
    {
      options->request.dimensions.push_back(figures.dimensions);
    }
  }
  return [options] { return RunBenchTables(*options); };
}

} // namespace

void AddBenchCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* command = program.add_subcommand("bench",
    "Measure decoding, merging and drawing on this machine, beside bare decompression, VTK's ray "
    "caster and the thesis's figures");
  AddOptions(*command, *options);
  command->callback([options, &action] { action = ChooseWork(options); });
}

} // namespace nexrad::application
