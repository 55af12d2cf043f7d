// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/MergeSettings.h"

#include "nexrad/Model/SiteTable.h"
#include "nexrad/Quality/Despeckling.h"

#include <algorithm>
#include <tuple>

namespace nexrad
{
namespace
{

using Rows = SettingTable<MergeOptions>;

// Reasons for which a setting is refused beside the others; empty: it is right.

std::string OfBeam(const MergeOptions& options)
{
  return options.method == MergeMethod::Thesis
           ? "is of the method 'beam'; 'thesis' does not have this option"
           : "";
}

bool HasReflectivity(const MergeOptions& options)
{
  const std::vector<MomentName>& moments = options.moments;
  return std::find(moments.begin(), moments.end(), MomentName::REF) != moments.end();
}

std::string OfReflectivity(const MergeOptions& options)
{
  const std::string ofBeam = OfBeam(options);
  return !ofBeam.empty() || HasReflectivity(options) ? ofBeam : "is of --moment REF alone";
}

std::string OfDecibels(const MergeOptions& options)
{
  const std::string ofBeam = OfBeam(options);
  return !ofBeam.empty() || (HasReflectivity(options) && !options.beam.linearReflectivity)
           ? ofBeam
           : "is of --moment REF in dBZ; nothing else is sharpened";
}

std::string OfOverlap(const MergeOptions& options)
{
  const std::vector<MomentName>& moments = options.moments;
  const auto acts = [&moments](OverlapStrategy wanted)
  {
    return std::any_of(moments.begin(), moments.end(),
      [wanted](MomentName moment) { return StrategyFor(moment, wanted) == wanted; });
  };
  const std::string ofBeam = OfBeam(options);
  return !ofBeam.empty() || acts(options.beam.strategy) || acts(OverlapStrategy::Mean)
           ? ofBeam
           : "of --moment VEL, SW, PHI, SRV and DIV is nearest alone, since they depend on the "
             "direction from the radar; that of AZSHEAR is the largest value";
}

std::string OfDistance(const MergeOptions& options)
{
  const std::string ofBeam = OfBeam(options);
  return !ofBeam.empty() || options.beam.strategy == OverlapStrategy::Distance
           ? ofBeam
           : "is of --overlap distance alone";
}

std::string AfterBegin(const MergeOptions& options)
{
  return options.begin && options.end && *options.end < *options.begin ? "lies before --begin" : "";
}

std::string InPlaceOfBounds(const MergeOptions& options)
{
  return options.grid.bounds ? "--bounds stands in its place" : "";
}

std::string KnownToMethod(const MergeOptions& options)
{
  const bool reflectivityAlone = options.moments == std::vector<MomentName>{MomentName::REF};
  return options.method == MergeMethod::Thesis && !reflectivityAlone
           ? "the method 'thesis' merges REF alone"
           : "";
}

// Types of values that the merge alone has.

ValueType<std::string> SiteValue()
{
  const auto parse = [](const std::string& text)
  {
    if (!text.empty() && FindSite(text) == nullptr)
    {
      throw Error(
        "'" + text + "' is no radar that is known here; write four capital letters, as in KLSX");
    }
    return text;
  };
  return {{"site", "NAME", {}}, parse, [](const std::string& name) { return name; }};
}

using EchoMotion = std::tuple<TimeInterpolationMethod, std::optional<Velocity>>;

ValueType<EchoMotion> EchoMotionValue()
{
  const auto parse = [](const std::string& text) -> EchoMotion
  {
    const bool choice = text == "none" || text == "estimated";
    if (!choice && text.find(',') == std::string::npos)
    {
      throw Error("'" + text +
                  "' is no motion; write estimated, none, or m/s towards east and north, as in "
                  "12,-7.5");
    }
    return {text == "none" ? TimeInterpolationMethod::Linear : TimeInterpolationMethod::AlongMotion,
      choice ? std::nullopt : std::optional(ParseMotion(text))};
  };
  const auto write = [](const EchoMotion& value)
  {
    const auto& [interpolation, motion] = value;
    const bool none = interpolation == TimeInterpolationMethod::Linear;
    return none ? "none" : motion ? MotionText(*motion) : "estimated";
  };
  return {{"echo motion", "MOTION", {"estimated", "none"}}, parse, write};
}

ValueType<std::tuple<bool, RadarBiases>> BiasValue()
{
  const auto parse = [](const std::string& text) -> std::tuple<bool, RadarBiases>
  {
    const BiasRequest request = ParseBiasRequest(text);
    return {request.measured, request.given};
  };
  const auto write = [](const std::tuple<bool, RadarBiases>& value)
  {
    const auto& [measured, given] = value;
    std::string list;
    for (const auto& [radar, bias] : given)
    {
      list += (list.empty() ? "" : ",") + radar + ":" + NumberText(bias);
    }
    return measured ? "auto" : list.empty() ? "off" : list;
  };
  return {{"bias", "BIAS", {}}, parse, write};
}

ValueType<std::optional<Wind>> StormMotionValue()
{
  const auto parse = [](const std::string& text)
  {
    const Velocity motion = ParseMotion(text);
    return Wind{motion.east, motion.north};
  };
  const auto write = [](const Wind& wind) { return MotionText({wind.east, wind.north}); };
  return Optional(ValueType<Wind>{MotionValue(), parse, write});
}

ValueType<MemoryLimit> MemoryLimitValue()
{
  const auto parse = [](const std::string& text)
  {
    const MemoryLimit limit = {ParseMemory(text), "--memory"};
    if (limit.bytes == 0)
    {
      throw Error("'" + text + "' is no memory to work with; write 512MiB or more");
    }
    return limit;
  };
  const auto write = [](const MemoryLimit& limit)
  { return limit.bytes == 0 ? "" : BytesText(limit.bytes); };
  return {{"memory", "SIZE", {}}, parse, write};
}

// The rows, in the order of the help texts.

void AddTimes(Rows& rows)
{
  rows.push_back(MakeSetting<MergeOptions>(
    {"step",
      "Time between two merged volumes, in s, min, h or d; their times are its multiples in UTC. "
      "Default for the files of a single radar volume: the middle of that",
      DurationText(DefaultStep)},
    Optional(Where<Duration>(
      DurationValue(), [](Duration step) { return step.count() > 0; },
      "is no time step; it must be above 0, as in 5min")),
    [](auto& of) -> auto& { return of.step; }));
  rows.push_back(MakeSetting<MergeOptions>(
    {"begin",
      "First time in UTC, as in 2006-03-12T18:00 (default: the first step after the first ray)"},
    Optional(TimeValue()), [](auto& of) -> auto& { return of.begin; }));
  rows.push_back(MakeSetting<MergeOptions>(
    {"end", "Last time in UTC, inclusive (default: the last step before the last ray)"},
    Optional(TimeValue()), [](auto& of) -> auto& { return of.end; }, AfterBegin));
  rows.push_back(MakeSetting<MergeOptions>(
    {"max-gap", "What a radar scanned farther than this from a time does not count"},
    DurationValue(), [](auto& of) -> auto& { return of.maximumGap; }));
}

void AddDomain(Rows& rows)
{
  rows.push_back(MakeSetting<MergeOptions>(
    {"dims", "Voxels to the east, to the north and upward"}, DimensionsValue(),
    [](auto& of) -> auto& { return of.grid.dimensions; }));
  rows.push_back(MakeSetting<MergeOptions>(
    {"range",
      "The domain holds the circle of this radius about each radar, m or km. Default for a single "
      "terminal radar: its own range",
      LengthText(DefaultRange)},
    Optional(Where<double>(
      LengthValue(), [](double range) { return range > 0.0 && range <= 1e6; },
      "is no range of a radar; it must be above 0 and at most 1000km")),
    [](auto& of) -> auto& { return of.grid.range; }, InPlaceOfBounds));
  rows.push_back(MakeSetting<MergeOptions>(
    {"bounds", "Outer faces of the domain in degrees, in place of --range", "", "range"},
    Optional(BoundsValue()), [](auto& of) -> auto& { return of.grid.bounds; }));
  rows.push_back(
    MakeSetting<MergeOptions>({"height", "Lower and upper face above mean sea level, m or km"},
      HeightRangeValue(), [](auto& of) { return std::tie(of.grid.bottom, of.grid.top); }));
  rows.push_back(MakeSetting<MergeOptions>(
    {"axes",
      "What x and y are: projected (m east and north of the centre of the domain), or geographic "
      "(degrees of longitude and latitude)"},
    ChoiceValue<GridAxes>(
      "kind of axes", {{"projected", GridAxes::Projected}, {"geographic", GridAxes::Geographic}}),
    [](auto& of) -> auto& { return of.grid.axes; }));
}

void AddMethod(Rows& rows)
{
  rows.push_back(MakeSetting<MergeOptions>(
    {"moment",
      "Moment to merge, or several as in REF,VEL,SW: each file is decoded once for all of them. "
      "Derived moments: SRV (storm-relative velocity), AZSHEAR (azimuthal shear), DIV (radial "
      "divergence), KDP (specific differential phase)"},
    MomentsValue(), [](auto& of) -> auto& { return of.moments; }, KnownToMethod));
  rows.push_back(MakeSetting<MergeOptions>(
    {"method",
      "How rays become voxels: beam (interpolates between tilts and times), or thesis (mean of the "
      "gates in a voxel)"},
    ChoiceValue<MergeMethod>(
      "method", {{"beam", MergeMethod::Beam}, {"thesis", MergeMethod::Thesis}}),
    [](auto& of) -> auto& { return of.method; }));
  rows.push_back(MakeSetting<MergeOptions>(
    {"quality",
      "What quality control takes out of REF: standard (ground clutter and anomalous propagation, "
      "spikes of the sun and of other transmitters, receiver faults, speckle), strict (birds and "
      "insects too), or off"},
    ChoiceValue<QualityLevel>(
      "level of quality control", {{"off", QualityLevel::Off}, {"standard", QualityLevel::Standard},
                                    {"strict", QualityLevel::Strict}}),
    [](auto& of) -> auto& { return of.quality.level; }, OfBeam));
  rows.push_back(MakeSetting<MergeOptions>(
    {"despeckle",
      "Take out gates of which fewer than this many of the 26 neighbours in ray, gate and tilt "
      "have a value; 0: none"},
    NumberValue(0, MostNeighbours), [](auto& of) -> auto& { return of.quality.neighbours; }));
  rows.push_back(MakeSetting<MergeOptions>(
    {"site", "Treat all files as data of this radar, in place of the name in each file"},
    SiteValue(), [](auto& of) -> auto& { return of.siteName; }));
  rows.push_back(MakeSetting<MergeOptions>(
    {"memory",
      "Memory that the merges may take, MiB or GiB: a grid that needs more is refused before "
      "anything is decoded. What is left, at most 1 GiB, keeps decoded volumes where times are "
      "asked for in any order; what does not fit is decoded again (default: what this machine, or "
      "the container, has)",
      "", "", SettingUse::Machine},
    MemoryLimitValue(), [](auto& of) -> auto& { return of.memoryLimit; }));
}

void AddRadars(Rows& rows)
{
  rows.push_back(MakeSetting<MergeOptions>(
    {"dealiasing", "Leave the velocities of VEL folded, as the radars measured them"}, FlagValue(),
    [](auto& of) -> auto& { return of.dealias; }, OfBeam));
  rows.push_back(MakeSetting<MergeOptions>(
    {"storm-motion",
      "Motion of the storm that SRV is relative to, m/s towards east and north (default: the mean "
      "wind from 0 to 6 km over each radar, of each volume's wind profile)"},
    StormMotionValue(), [](auto& of) -> auto& { return of.stormMotion; }, OfBeam));
  rows.push_back(MakeSetting<MergeOptions>(
    {"bias",
      "Take biases of radars off reflectivity: auto (those that the comparison of the radars "
      "finds), or how many dB radars measure too high, as in KLSX:2,KILX:-1.5, or off"},
    BiasValue(), [](auto& of) { return std::tie(of.measureBiases, of.beam.biases); },
    OfReflectivity));
  rows.push_back(MakeSetting<MergeOptions>(
    {"overlap",
      "Where radars overlap: distance (the nearer counts more), nearest (alone; VEL always), mean, "
      "or maximum (AZSHEAR always)"},
    ChoiceValue<OverlapStrategy>("strategy",
      {{"mean", OverlapStrategy::Mean}, {"nearest", OverlapStrategy::Nearest},
        {"maximum", OverlapStrategy::Maximum}, {"distance", OverlapStrategy::Distance}}),
    [](auto& of) -> auto& { return of.beam.strategy; }, OfOverlap));
  rows.push_back(MakeSetting<MergeOptions>(
    {"overlap-length",
      "Distance at which a radar's weight has fallen to 1/e, m or km; of --overlap distance"},
    Where<double>(
      LengthValue(), [](double length) { return length >= 1e3 && length <= 1e6; },
      "is no length of overlap; write 1km to 1000km, as in 100km"),
    [](auto& of) -> auto& { return of.beam.overlapLength; }, OfDistance));
}

void AddInterpolation(Rows& rows)
{
  rows.push_back(MakeSetting<MergeOptions>(
    {"motion",
      "Motion of the echo between two observations of a radar: estimated (from reflectivity), "
      "EAST,NORTH in m/s, or none. Other moments than REF are shifted by a given motion only"},
    EchoMotionValue(), [](auto& of) { return std::tie(of.interpolation, of.motion); }, OfBeam));
  rows.push_back(MakeSetting<MergeOptions>(
    {"fill-columns", "Give values to voxels between and below those that were scanned"},
    FlagValue(), [](auto& of) -> auto& { return of.beam.fillColumns; }, OfBeam));
  rows.push_back(MakeSetting<MergeOptions>(
    {"linear-reflectivity", "Interpolate and average Z (mm^6/m^3) in place of dBZ; of REF"},
    FlagValue(), [](auto& of) -> auto& { return of.beam.linearReflectivity; }, OfReflectivity));
  rows.push_back(MakeSetting<MergeOptions>(
    {"sharpening", "Do not deconvolve the beam width in elevation; of REF"}, FlagValue(),
    [](auto& of) -> auto& { return of.beam.sharpen; }, OfDecibels));
  rows.push_back(MakeSetting<MergeOptions>(
    {"ancillary", "Add the ancillary arrays: age in s, number of radars, weight, nearest radar"},
    FlagValue(), [](auto& of) -> auto& { return of.beam.ancillary; }, OfBeam));
}

} // namespace

const SettingTable<MergeOptions>& MergeSettings()
{
  static const Rows table = []
  {
    Rows rows;
    AddTimes(rows);
    AddDomain(rows);
    AddMethod(rows);
    AddRadars(rows);
    AddInterpolation(rows);
    return rows;
  }();
  return table;
}

} // namespace nexrad
