// SPDX-License-Identifier: BSD-3-Clause
#include "Options/GridOptions.h"

#include "Options/UnitOptions.h"
#include "nexrad/Calibration/RadarBiases.h"
#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Quality/Despeckling.h"
#include "nexrad/System/MachineMemory.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace nexrad::application
{
namespace
{

constexpr char group[] = "Merging radar files";
constexpr char machineGroup[] = "Memory and threads"; // change no volume
constexpr char hidden[] = ""; // the group of names that options had in earlier versions

Duration ParseStep(const std::string& text)
{
  const Duration step = ParseDuration(text);
  if (step <= Duration::zero())
  {
    throw Error("'" + text + "' is no time step; it must be above 0, as in 5min");
  }
  return step;
}

double ParseRange(const std::string& text)
{
  const double range = ParseLength(text);
  if (range <= 0.0 || range > 1e6)
  {
    throw Error("'" + text + "' is no range of a radar; it must be above 0 and at most 1000km");
  }
  return range;
}

std::vector<MomentName> ParseMoments(const std::string& text)
{
  std::vector<MomentName> moments = ParseMomentNames(text);
  if (moments.empty())
  {
    throw Error("'" + text + "' is no moment; write " + MomentNameList() +
                ", or several of them as in REF,VEL");
  }
  return moments;
}

MergeMethod ParseMethod(const std::string& text)
{
  const auto method = ParseMergeMethod(text);
  if (!method)
  {
    throw Error("'" + text + "' is no method; write beam or thesis");
  }
  return *method;
}

OverlapStrategy ParseOverlap(const std::string& text)
{
  constexpr std::pair<const char*, OverlapStrategy> names[] = {{"mean", OverlapStrategy::Mean},
    {"nearest", OverlapStrategy::Nearest}, {"maximum", OverlapStrategy::Maximum},
    {"distance", OverlapStrategy::Distance}};
  for (const auto& [name, strategy] : names)
  {
    if (text == name)
    {
      return strategy;
    }
  }
  throw Error("'" + text + "' is no strategy; write mean, nearest, maximum or distance");
}

double ParseOverlapLength(const std::string& text)
{
  const double length = ParseLength(text);
  if (length < 1'000.0 || length > 1e6)
  {
    throw Error("'" + text + "' is no length of overlap; write 1km to 1000km, as in 100km");
  }
  return length;
}

// Along which motion the method beam interpolates in time.
void StoreMotion(const std::string& text, MergeOptions& options)
{
  const bool choice = text == "none" || text == "estimated";
  if (!choice && text.find(',') == std::string::npos)
  {
    throw Error("'" + text +
                "' is no motion; write estimated, none, or m/s towards east and north, as in "
                "12,-7.5");
  }
  options.interpolation =
    text == "none" ? TimeInterpolationMethod::Linear : TimeInterpolationMethod::AlongMotion;
  options.motion = choice ? std::nullopt : std::optional(ParseMotion(text));
}

std::string ParseSite(const std::string& text)
{
  if (FindSite(text) == nullptr)
  {
    throw Error("'" + text +
                "' is no radar that is known here; write four capital letters, as in "
                "KLSX");
  }
  return text;
}

void AddTimes(CLI::App& command, MergeOptions& options)
{
  AddParsedOption(command, "--step", options.step, ParseStep, "DURATION",
    "Time between two merged volumes, in s, min, h or d; their times are its multiples in UTC. "
    "Default "
    "for the files of a single radar volume: the middle of that",
    "5min")
    ->group(group);
  AddParsedOption(command, "--begin", options.begin, ParseTime, "TIME",
    "First time in UTC, as in 2006-03-12T18:00 (default: the first step after the first ray)")
    ->group(group);
  AddParsedOption(command, "--end", options.end, ParseTime, "TIME",
    "Last time in UTC, inclusive (default: the last step before the last ray)")
    ->group(group);
  AddParsedOption(command, "--max-gap", options.maximumGap, ParseDuration, "DURATION",
    "What a radar scanned farther than this from a time does not count", "15min")
    ->group(group);
}

void AddDomain(CLI::App& command, MergeOptions& options)
{
  AddParsedOption(command, "--dims", options.grid.dimensions, ParseDimensions, "XxYxZ",
    "Voxels to the east, to the north and upward", "256x256x128")
    ->group(group);
  CLI::Option* range = AddParsedOption(command, "--range", options.grid.range, ParseRange, "LENGTH",
    "The domain holds the circle of this radius about each radar, m or km. Default for a single "
    "terminal radar: its own range",
    "230km");
  CLI::Option* bounds = AddParsedOption(command, "--bounds", options.grid.bounds, ParseBounds,
    "W,S,E,N", "Outer faces of the domain in degrees, in place of --range");
  range->group(group);
  bounds->group(group)->excludes(range);
  const auto takeHeights = [&options](const std::string& text)
  { std::tie(options.grid.bottom, options.grid.top) = ParseHeightRange(text); };
  AddTextOption(command, "--height", takeHeights, "LOWER,UPPER",
    "Lower and upper face above mean sea level, m or km")
    ->default_str("0,20km")
    ->group(group);
}

void AddMethod(CLI::App& command, MergeOptions& options)
{
  const auto takeMoments = [&options](const std::string& text)
  {
    options.furtherMoments = ParseMoments(text);
    options.moment = options.furtherMoments.front();
    options.furtherMoments.erase(options.furtherMoments.begin());
  };
  AddTextOption(command, "--moment", takeMoments, "NAME,...",
    "Moment to merge, or several as in REF,VEL,SW: each file is decoded once for all of them. "
    "Derived moments: SRV (storm-relative velocity), AZSHEAR (azimuthal shear), DIV (radial "
    "divergence), KDP (specific differential phase)")
    ->default_str("REF")
    ->group(group);
  AddParsedOption(command, "--method", options.method, ParseMethod, "NAME",
    "How rays become voxels: beam (interpolates between tilts and times), or thesis (mean of the "
    "gates "
    "in a voxel)",
    "beam")
    ->group(group);
  AddParsedOption(command, "--quality", options.quality.level, ParseQuality, "NAME",
    "What quality control takes out of REF: standard (ground clutter and anomalous propagation, "
    "spikes of the sun and of other transmitters, receiver faults, speckle), strict (birds and "
    "insects too), or off",
    "standard")
    ->group(group);
  AddNumberOption(command, "--despeckle", options.quality.neighbours, 0, MostNeighbours, "NUMBER",
    "Take out gates of which fewer than this many of the 26 neighbours in ray, gate and tilt have "
    "a "
    "value; 0: none")
    ->group(group);
  AddParsedOption(command, "--site", options.siteName, ParseSite, "NAME",
    "Treat all files as data of this radar, in place of the name in each file")
    ->group(group);
}

void AddMemory(CLI::App& command, MergeOptions& options)
{
  options.memoryLimit = {MachineMemory().value_or(0), ""};
  const auto take = [&options](const std::string& text)
  {
    options.memoryLimit = {ParseMemory(text), "--memory"};
    if (options.memoryLimit.bytes == 0)
    {
      throw Error("'" + text + "' is no memory to work with; write 512MiB or more");
    }
  };
  AddTextOption(command, "--memory", take, "SIZE",
    "Memory that the merges may take, MiB or GiB: a grid that needs more is refused before "
    "anything is decoded. What is left, at most 1 GiB, keeps decoded volumes where times are asked "
    "for in any order; what does not fit is decoded again (default: what this machine, or the "
    "container, has)")
    ->group(machineGroup);
}

void AddVelocity(CLI::App& command, MergeOptions& options)
{
  command
    .add_flag_callback(
      "--no-dealiasing", [&options] { options.dealias = false; },
      "Leave the velocities of VEL folded, as the radars measured them")
    ->group(group);
  const auto takeStormMotion = [&options](const std::string& text)
  {
    const Velocity motion = ParseMotion(text);
    options.stormMotion = Wind{motion.east, motion.north};
  };
  AddTextOption(command, "--storm-motion", takeStormMotion, "EAST,NORTH",
    "Motion of the storm that SRV is relative to, m/s towards east and north (default: the mean "
    "wind from 0 to 6 km over each radar, of each volume's wind profile)")
    ->group(group);
}

void AddBias(CLI::App& command, MergeOptions& options)
{
  const auto takeBias = [&options](const std::string& text)
  {
    const BiasRequest request = ParseBiasRequest(text);
    options.measureBiases = request.measured;
    options.beam.biases = request.given;
  };
  AddTextOption(command, "--bias", takeBias, "BIAS",
    "Take biases of radars off reflectivity: auto (those that the comparison of the radars finds), "
    "or how many dB radars measure too high, as in KLSX:2,KILX:-1.5, or off")
    ->default_str("off")
    ->group(group);
}

// Options that the method beam has and the method thesis has not.
constexpr const char* beamOptions[] = {"--overlap", "--overlap-length", "--fill-columns", "--fill",
  "--linear-reflectivity", "--no-sharpening", "--ancillary", "--companions", "--motion",
  "--no-dealiasing", "--storm-motion", "--quality", "--bias"};

void AddBeam(CLI::App& command, MergeOptions& options)
{
  AddParsedOption(command, "--overlap", options.beam.strategy, ParseOverlap, "NAME",
    "Where radars overlap: distance (the nearer counts more), nearest (alone; VEL always), mean, "
    "or maximum (AZSHEAR always)",
    "distance")
    ->group(group);
  AddParsedOption(command, "--overlap-length", options.beam.overlapLength, ParseOverlapLength,
    "LENGTH",
    "Distance at which a radar's weight has fallen to 1/e, m or km; of --overlap distance", "100km")
    ->group(group);
  AddTextOption(
    command, "--motion", [&options](const std::string& text) { StoreMotion(text, options); },
    "MOTION",
    "Motion of the echo between two observations of a radar: estimated (from reflectivity), "
    "EAST,NORTH in m/s, or none. Other moments than REF are shifted by a given motion only")
    ->default_str("estimated")
    ->group(group);
  command
    .add_flag("--fill-columns", options.beam.fillColumns,
      "Give values to voxels between and below those that were scanned")
    ->group(group);
  command
    .add_flag("--linear-reflectivity", options.beam.linearReflectivity,
      "Interpolate and average Z (mm^6/m^3) in place of dBZ; of REF")
    ->group(group);
  command
    .add_flag_callback(
      "--no-sharpening", [&options] { options.beam.sharpen = false; },
      "Do not deconvolve the beam width in elevation; of REF")
    ->group(group);
  command
    .add_flag("--ancillary", options.beam.ancillary,
      "Add the ancillary arrays: age in s, number of radars, weight, nearest radar")
    ->group(group);
  command.add_flag("--fill", options.beam.fillColumns)->group(hidden);
  command.add_flag("--companions", options.beam.ancillary)->group(hidden);
}

constexpr char onlyDecibels[] = "is of --moment REF in dBZ; nothing else is sharpened";

// Once all are known. Options that contradict each other are wrong usage.
void Finish(const CLI::App& command, MergeOptions& options)
{
  if (options.begin && options.end && *options.end < *options.begin)
  {
    throw CLI::ValidationError("--end", "lies before --begin");
  }
  const bool thesis = options.method == MergeMethod::Thesis;
  const std::vector<MomentName> moments = options.Moments();
  const bool reflectivity =
    std::find(moments.begin(), moments.end(), MomentName::REF) != moments.end();
  if (thesis && (moments.size() > 1 || !reflectivity))
  {
    throw CLI::ValidationError("--moment", "the method 'thesis' merges REF alone");
  }
  for (const char* name : beamOptions)
  {
    if (thesis && command.count(name) > 0)
    {
      throw CLI::ValidationError(
        name, "is of the method 'beam'; 'thesis' does not have this option");
    }
  }
  if (command.count("--overlap-length") > 0 && options.beam.strategy != OverlapStrategy::Distance)
  {
    throw CLI::ValidationError("--overlap-length", "is of --overlap distance alone");
  }
  const bool overlaps = std::any_of(moments.begin(), moments.end(),
    [&options](MomentName moment)
    { return StrategyFor(moment, options.beam.strategy) == options.beam.strategy; });
  for (const char* name : {"--overlap", "--linear-reflectivity", "--no-sharpening", "--bias"})
  {
    const bool asItIs = name == std::string("--overlap") && overlaps;
    const std::string refusal = RefusalFor(name, moments);
    if (command.count(name) > 0 && !asItIs && !refusal.empty())
    {
      throw CLI::ValidationError(name, refusal);
    }
  }
  if (!options.beam.sharpen && options.beam.linearReflectivity)
  {
    throw CLI::ValidationError("--no-sharpening", onlyDecibels);
  }
}

} // namespace

QualityLevel ParseQuality(const std::string& text)
{
  const auto level = ParseQualityLevel(text);
  if (!level)
  {
    throw Error("'" + text + "' is no level of quality control; write off, standard or strict");
  }
  return *level;
}

void AddGridOptions(CLI::App& command, MergeOptions& options)
{
  AddTimes(command, options);
  AddDomain(command, options);
  AddMethod(command, options);
  AddMemory(command, options);
  AddVelocity(command, options);
  AddBias(command, options);
  AddBeam(command, options);
  command.parse_complete_callback([&command, &options] { Finish(command, options); });
}

std::string RefusalFor(const std::string& name, const std::vector<MomentName>& moments)
{
  const bool reflectivity =
    std::find(moments.begin(), moments.end(), MomentName::REF) != moments.end();
  const bool fixed = std::none_of(moments.begin(), moments.end(),
    [](MomentName moment)
    { return StrategyFor(moment, OverlapStrategy::Mean) == OverlapStrategy::Mean; });
  if (name == "--overlap" && fixed)
  {
    return "of --moment VEL, SW, PHI, SRV and DIV is nearest alone, since they depend on the "
           "direction from the radar; that of AZSHEAR is the largest value";
  }
  if ((name == "--linear-reflectivity" || name == "--bias") && !reflectivity)
  {
    return "is of --moment REF alone";
  }
  return name == "--no-sharpening" && !reflectivity ? onlyDecibels : "";
}

std::vector<OptionText> GivenGridOptions(const CLI::App& command)
{
  std::vector<OptionText> given;
  const auto isGiven = [](const CLI::Option* option) {
    return option->count() > 0 && (option->get_group() == group || option->get_group() == hidden);
  };
  for (const CLI::Option* option : command.get_options(isGiven))
  {
    const bool flag = option->get_expected_max() == 0;
    given.push_back({"--" + option->get_lnames().front(), flag ? "" : option->as<std::string>()});
  }
  return given;
}

} // namespace nexrad::application
