// SPDX-License-Identifier: BSD-3-Clause
#include "GridCommand.h"

#include "Counted.h"
#include "JoinedProcesses.h"
#include "ProgressBar.h"
#include "UnitOptions.h"
#include "Volumes/WriteVolumes.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace nexrad::application
{
namespace
{

struct GridCommandOptions
{
  GridJob job;
  bool quiet = false;
};

VolumeFormat ParseFormat(const std::string& text)
{
  if (text != "nxv" && text != "vti")
  {
    throw Error("'" + text + "' is no format of volumes; write nxv or vti");
  }
  return text == "nxv" ? VolumeFormat::Nxv : VolumeFormat::Vti;
}

int RunGrid(const GridCommandOptions& options)
{
  const JoinedProcesses joined;
  const Processes processes = joined.Get();
  ProgressBar bar("merging", options.quiet || !processes.IsFirst());
  const GridReport report = WriteVolumes(
    options.job, [&bar](double fraction) { return bar.Update(fraction); }, processes);
  bar.Clear();
  const int status = report.problems.empty() ? Done : DoneWithDamage;
  if (!processes.IsFirst())
  {
    return status;
  }
  if (!options.quiet)
  {
    std::cout << report.index.string() << ": " << Counted(report.files.size(), "volume") << ", "
              << Counted(report.bytes, "byte") << '\n';
  }
  for (const std::string& problem : report.problems)
  {
    std::cerr << problem << '\n';
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
  AddQuietOption(*command, options->quiet);
  AddGridOptions(*command, options->job.options);
  command->callback([options, &action] { action = [options] { return RunGrid(*options); }; });
}

} // namespace nexrad::application
