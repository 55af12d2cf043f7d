// SPDX-License-Identifier: BSD-3-Clause
#include "Commands/Command.h"

#include "Commands/WindReport.h"
#include "Output/ExplainedRead.h"
#include "Output/InputSubjects.h"
#include "Output/MessageOutput.h"
#include "nexrad/System/ThreadGroup.h"
#include "nexrad/Velocity/VelocityAzimuthDisplay.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace nexrad::application
{

namespace
{

struct WindOptions
{
  std::vector<std::string> files;
  double layer = 300.0;
  double range = 60.0;
  bool json = false;
};

// Makes one report after the other; the profile of a volume helps to dealias the next of its site.
class WindReporter
{
public:
  explicit WindReporter(const WindOptions& theOptions)
  {
    profileOptions.layerDepth = theOptions.layer;
    profileOptions.farthest = 1000.0 * theOptions.range;
    dealiasOptions.loop = ThreadLoop(CoreCount());
  }

  // Empty where the volume has no velocity.
  std::optional<WindReport> Report(const RadarVolume& volume)
  {
    constexpr Duration oldest = std::chrono::minutes(30);
    VelocityVolume velocities = MakeVelocityVolume(volume);
    if (velocities.sweeps.empty())
    {
      return std::nullopt;
    }
    const bool follows = last && last->site.name == volume.site.name &&
                         velocities.start >= last->start && velocities.start - last->end < oldest;
    dealiasOptions.before = follows ? last->profile : WindProfile();
    WindReport report{volume.file, volume.site, velocities.start, velocities.end, volume.synthetic,
      Dealias(velocities, dealiasOptions), {}};
    report.profile = FitWindProfile(velocities, profileOptions);
    last = report;
    return report;
  }

private:
  ProfileOptions profileOptions;
  DealiasOptions dealiasOptions;
  std::optional<WindReport> last;
};

int RunWind(const WindOptions& options)
{
  WindReporter reporter(options);
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  bool anyRay = false;
  bool anyDamage = false;
  const std::vector<InputSubject> subjects = FindSubjects(options.files, anyDamage);
  ExplainedReader reader(subjects);
  for (const auto& [file, ofFolder] : subjects)
  {
    const RadarVolume volume = reader.Next();
    anyDamage = anyDamage || !volume.damage.empty();
    if (HoldsMetadataAlone(volume))
    {
      PrintMessage(file + ": metadata alone, no ray: passed over");
      continue;
    }
    for (const RadarVolume& cycle : SplitCycles(volume))
    {
      const std::optional<WindReport> report = reporter.Report(cycle);
      if (!report)
      {
        if (!volume.sweeps.empty()) // else reading it said what is wrong
        {
          PrintMessage(file + ": no ray has velocities; a wind profile needs the moment VEL");
        }
        anyDamage = true;
        continue;
      }
      anyRay = true;
      options.json ? result.push_back(MakeWindJson(*report)) : PrintWindTable(*report, std::cout);
    }
  }
  if (options.json)
  {
    std::cout << result.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
  }
  return !anyRay ? Failed : anyDamage ? DoneWithDamage : Done;
}

} // namespace

void AddWindCommand(CLI::App& program, CommandAction& action)
{
  const auto options = std::make_shared<WindOptions>();
  CLI::App* command = program.add_subcommand("wind",
    "Prints the wind profile over the radar for each volume: the velocity-azimuth display of "
    "dealiased velocities");
  command
    ->add_option("FILE", options->files,
      "Level II files, folders of real-time chunks, or folders and tar archives of files")
    ->required();
  command->add_flag("--json", options->json,
    "print JSON: metres, metres a second, degrees, UTC (default: a table)");
  command
    ->add_option("--layer", options->layer, "depth of the layer of each level, m (default: 300)")
    ->check(CLI::Range(50.0, 5000.0));
  command
    ->add_option("--range", options->range,
      "ground distance up to which velocities are used, km (default: 60)")
    ->check(CLI::Range(5.0, 300.0));
  command->callback([options, &action] { action = [options] { return RunWind(*options); }; });
}

} // namespace nexrad::application
