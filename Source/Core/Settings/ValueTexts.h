// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Motion/MotionField.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// Values with units as users write them: in options, sessions, recipes and the properties of the
/// VTK classes. Every Parse function throws Error, saying what is wrong with the text and what
/// would be right. A Text function gives a text that its Parse function reads as the same value.
namespace nexrad
{

/// The shortest text without an exponent that is read as the same number.
std::string NumberText(double value);

/// "5min", "90s", "2h", "1d", "1.5h"; a bare number is seconds. To the millisecond, not negative.
Duration ParseDuration(const std::string& text);
/// "5min", "90s".
std::string DurationText(Duration duration);

/// A duration from 16 ms to 8 s, the time from one step to the next in playing.
Duration ParseInterval(const std::string& text);

/// "230km", "500m", "-1km", "0"; any other bare number is refused. Result in m.
double ParseLength(const std::string& text);
/// "230km", "500m".
std::string LengthText(double metres);

/// "0,20km": lower and upper height in m; a unit after the second number alone counts for both, and
/// one of them needs it.
/// Refuses an upper height that is not above the lower one.
std::pair<double, double> ParseHeightRange(const std::string& text);
std::string HeightRangeText(double bottom, double top);

/// "256x256x128": three numbers of voxels from 1 on.
std::array<int, 3> ParseDimensions(const std::string& text);
std::string DimensionsText(const std::array<int, 3>& dimensions);

/// "1280x720": width and height in pixels, 16…16384 each.
std::array<int, 2> ParsePictureSize(const std::string& text);

/// "west,south,east,north" in degrees. Refuses a lower bound above its upper one, and bounds off
/// the globe.
GeographicBounds ParseBounds(const std::string& text);
std::string BoundsText(const GeographicBounds& bounds);

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

/// Coordinates with commas between them: degrees with their unit, or lengths.
template <typename Places>
std::string PlacesText(const Places& places, PlaceUnit unit)
{
  std::string text;
  for (const double place : places)
  {
    text += text.empty() ? "" : ",";
    text += unit == PlaceUnit::Degrees ? NumberText(place) + "deg" : LengthText(place);
  }
  return text;
}

/// "12,-7.5": m/s towards east and north. Refuses a speed above FastestEcho.
Velocity ParseMotion(const std::string& text);
std::string MotionText(const Velocity& motion);

/// "512MiB", "2GiB"; a bare number is bytes. Not negative, at most 1024 GiB.
std::size_t ParseMemory(const std::string& text);
std::string BytesText(std::size_t bytes);

/// A time in UTC as ParseIso8601 reads it.
Time ParseTime(const std::string& text);

/// The texts between the commas of a list: "" is one, "a," are two.
std::vector<std::string> SplitAtCommas(const std::string& text);

/// The numbers of a list with commas, without units; empty for any other text.
std::vector<double> FindNumbers(const std::string& text);

} // namespace nexrad
