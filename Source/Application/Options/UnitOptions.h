// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Grid/PlaceUnit.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Motion/MotionField.h"

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
class Option;
} // namespace CLI

/// Values with units as the command line writes them. Every Parse function throws Error, saying
/// what is wrong with the text and what would be right; the Add functions turn that into the wrong
/// usage of the named option.
namespace nexrad::application
{

/// "5min", "90s", "2h", "1d", "1.5h"; a bare number is seconds. To the millisecond, not negative.
Duration ParseDuration(const std::string& text);

/// A duration from 16 ms to 8 s, the time from one step to the next in playing.
Duration ParseInterval(const std::string& text);

/// "230km", "500m", "-1km", "0"; any other bare number is refused. Result in m.
double ParseLength(const std::string& text);

/// "0,20km": lower and upper height in m; a unit after the second number alone counts for both, and
/// one of them needs it.
/// Refuses an upper height that is not above the lower one.
std::pair<double, double> ParseHeightRange(const std::string& text);

/// "256x256x128": three numbers of voxels from 1 on.
std::array<int, 3> ParseDimensions(const std::string& text);

/// "1280x720": width and height in pixels, 16…16384 each.
std::array<int, 2> ParsePictureSize(const std::string& text);

/// "west,south,east,north" in degrees. Refuses a lower bound above its upper one, and bounds off
/// the globe.
GeographicBounds ParseBounds(const std::string& text);

/// A number from -360 to 360: degrees.
double ParseDegrees(const std::string& text);

/// A coordinate towards east or north: "20km" and "500m" in m, "-97.5deg" in degrees (-360 to 360),
/// "0" in either. Places that belong together share `unit`: the first one with a unit sets it, and
/// one in the other unit is refused.
double ParsePlace(const std::string& text, PlaceUnit& unit);

/// "WEST,EAST,SOUTH,NORTH", each as ParsePlace. Refuses a face that is not above the one opposite.
std::array<double, 4> ParseBox(const std::string& text, PlaceUnit& unit);

/// "WEST,EAST,SOUTH,NORTH,BOTTOM,TOP": the same, then two lengths.
std::array<double, 6> ParseBoxWithHeights(const std::string& text, PlaceUnit& unit);

/// "12,-7.5": m/s towards east and north. Refuses a speed above FastestEcho.
Velocity ParseMotion(const std::string& text);

/// "512MiB", "2GiB"; a bare number is bytes. Not negative, at most 1024 GiB.
std::size_t ParseMemory(const std::string& text);

/// A time in UTC as ParseIso8601 reads it.
Time ParseTime(const std::string& text);

/// The texts between the commas of a list: "" is one, "a," are two.
std::vector<std::string> SplitAtCommas(const std::string& text);

/// The numbers of a list with commas, without units; empty for any other text.
std::vector<double> FindNumbers(const std::string& text);

/// An option whose text `take` takes. `unit` is the placeholder in the help text.
CLI::Option* AddTextOption(CLI::App& command, const std::string& name,
  const std::function<void(const std::string&)>& take, const std::string& unit,
  const std::string& description);

/// An option whose text `parse` turns into `value`. `unit` is the placeholder in the help text. The
/// help text shows `defaultText` when it is not empty.
template <typename Value, typename Target>
CLI::Option* AddParsedOption(CLI::App& command, const std::string& name, Target& value,
  Value (*parse)(const std::string&), const std::string& unit, const std::string& description,
  const std::string& defaultText = "");

/// An option that takes a number from `least` to `most`, both inclusive; what `value` holds is the
/// default that the help text shows. `unit` is the placeholder there.
template <typename Number>
CLI::Option* AddNumberOption(CLI::App& command, const std::string& name, Number& value,
  Number least, Number most, const std::string& unit, const std::string& description);

} // namespace nexrad::application

#include "Options/UnitOptions.hxx"
