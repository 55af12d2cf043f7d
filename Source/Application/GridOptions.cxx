// SPDX-License-Identifier: BSD-3-Clause
#include "GridOptions.h"

#include "Model/SiteTable.h"
#include "Temporal/TimeMerge.h"
#include "UnitOptions.h"

#include <CLI/CLI.hpp>

namespace nexrad::application
{
namespace
{

constexpr char group[] = "Merging radar files";

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

MomentName ParseMoment(const std::string& text)
{
  const auto moment = ParseMomentName(text);
  if (!moment)
  {
    throw Error("'" + text + "' is no moment; write REF, VEL, SW, ZDR, PHI, RHO or CFP");
  }
  return *moment;
}

std::string ParseMethod(const std::string& text)
{
  if (!ParseMergeMethod(text))
  {
    throw Error("'" + text + "' is no method; write beam or thesis");
  }
  return text;
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

void AddTimes(CLI::App& command, GridOptions& options)
{
  AddParsedOption(command, "--step", options.step, ParseStep, "DURATION",
    "Time between two volumes, in s, min, h or d; they stand at its multiples in UTC", "5min")
    ->group(group);
  AddParsedOption(command, "--begin", options.begin, ParseTime, "TIME",
    "First time in UTC, as in 2006-03-12T18:00 (default: the first step after the first ray)")
    ->group(group);
  AddParsedOption(command, "--end", options.end, ParseTime, "TIME",
    "Last time in UTC, inclusive (default: the last step before the last ray)")
    ->group(group);
  AddParsedOption(command, "--max-gap", options.maximumGap, ParseDuration, "DURATION",
    "A site's volume farther than this from a time does not count", "15min")
    ->group(group);
}

void AddDomain(CLI::App& command, GridOptions& options)
{
  AddParsedOption(command, "--dims", options.grid.dimensions, ParseDimensions, "XxYxZ",
    "Voxels to the east, to the north and upward", "256x256x128")
    ->group(group);
  CLI::Option* range = AddParsedOption(command, "--range", options.grid.range, ParseRange, "LENGTH",
    "The domain holds the circle of this radius about each site, m or km", "230km");
  CLI::Option* bounds = AddParsedOption(command, "--bounds", options.grid.bounds, ParseBounds,
    "W,S,E,N", "Outer faces of the domain in degrees, in place of --range");
  range->group(group);
  bounds->group(group)->excludes(range);
  const auto storeHeights = [&options](const std::string& text)
  {
    try
    {
      std::tie(options.grid.bottom, options.grid.top) = ParseHeightRange(text);
    }
    catch (const Error& error)
    {
      throw CLI::ValidationError("--height", error.what());
    }
  };
  command
    .add_option_function<std::string>(
      "--height", storeHeights, "Lower and upper face above mean sea level, m or km")
    ->type_name("LOWER,UPPER")
    ->default_str("0,20km")
    ->group(group);
}

} // namespace

void AddGridOptions(CLI::App& command, GridOptions& options)
{
  AddTimes(command, options);
  AddDomain(command, options);
  AddParsedOption(
    command, "--moment", options.moment, ParseMoment, "NAME", "Moment to merge", "REF")
    ->group(group);
  AddParsedOption(command, "--method", options.method, ParseMethod, "NAME",
    "How rays become voxels: beam (between the beams), or thesis (its bin average)", "beam")
    ->group(group);
  AddParsedOption(command, "--site", options.siteName, ParseSite, "NAME",
    "All files are this radar's, whatever name stands in them")
    ->group(group);
  // Two options that contradict each other are wrong usage, found once both are known.
  const auto check = [&options]
  {
    if (options.begin && options.end && *options.end < *options.begin)
    {
      throw CLI::ValidationError("--end", "lies before --begin");
    }
    if (options.method == ToString(MergeMethod::Thesis) && options.moment != MomentName::REF)
    {
      throw CLI::ValidationError("--moment", "the method 'thesis' merges REF alone");
    }
  };
  command.parse_complete_callback(check);
}

} // namespace nexrad::application
