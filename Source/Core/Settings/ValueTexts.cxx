// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Settings/ValueTexts.h"

#include "nexrad/System/Error.h"

#include <charconv>
#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <string_view>

namespace nexrad
{
namespace
{

struct Quantity
{
  double number = 0.0;
  std::string unit;
};

// A finite number and what follows it; empty when the text does not start with a number.
std::optional<Quantity> SplitQuantity(const std::string& text)
{
  // Extraction of a double would take the first letters of "5e" or "1d" for an exponent.
  const std::size_t end = text.find_first_not_of("+-.0123456789");
  std::istringstream stream(text.substr(0, end));
  stream.imbue(std::locale::classic());
  Quantity quantity;
  stream >> quantity.number;
  if (!stream || stream.peek() != std::istringstream::traits_type::eof() ||
      !std::isfinite(quantity.number))
  {
    return std::nullopt;
  }
  quantity.unit = end == std::string::npos ? "" : text.substr(end);
  return quantity;
}

std::vector<std::string> SplitAt(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream stream(text + separator);
  for (std::string part; std::getline(stream, part, separator);)
  {
    parts.push_back(part);
  }
  return parts;
}

// The name of a unit, and what one of it is in the unit of the result.
using Unit = std::pair<std::string_view, double>;
constexpr Unit lengthUnits[] = {{"m", 1.0}, {"km", 1000.0}};
constexpr Unit durationUnits[] = {
  {"", 1.0}, {"s", 1.0}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}};
constexpr Unit memoryUnits[] = {
  {"", 1.0}, {"KiB", 1024.0}, {"MiB", 1024.0 * 1024.0}, {"GiB", 1024.0 * 1024.0 * 1024.0}};

// A number times its unit; empty for a text that is no number, or has none of the units.
template <std::size_t Count>
std::optional<double> FindAmount(const std::string& text, const Unit (&units)[Count])
{
  const std::optional<Quantity> quantity = SplitQuantity(text);
  for (const auto& [name, size] : units)
  {
    if (quantity && quantity->unit == name)
    {
      return quantity->number * size;
    }
  }
  return std::nullopt;
}

// Whole numbers separated by 'x', each within the limits. `refusal` says after the text what is
// wrong with any other and what would be right.
template <std::size_t Count>
std::array<int, Count> ParseCounts(
  const std::string& text, int least, int most, const std::string& refusal)
{
  const bool commas = text.find(',') != std::string::npos;
  const std::vector<std::string> parts = SplitAt(text, commas ? ',' : 'x');
  std::array<int, Count> counts{};
  bool right = parts.size() == Count;
  for (std::size_t i = 0; right && i < Count; ++i)
  {
    const std::string& part = parts[i];
    const bool isWhole = !part.empty() && part.size() <= 9 &&
                         part.find_first_not_of("0123456789") == std::string::npos;
    counts[i] = isWhole ? std::stoi(part) : 0;
    right = isWhole && counts[i] >= least && counts[i] <= most;
  }
  if (!right)
  {
    throw Error("'" + text + "' " + refusal);
  }
  return counts;
}

// West, east, south and north, and the heights of bottom and top where there are six.
template <std::size_t Count>
std::array<double, Count> ParseFaces(const std::string& text, PlaceUnit& unit)
{
  const std::vector<std::string> parts = SplitAtCommas(text);
  if (parts.size() != Count)
  {
    constexpr bool heights = Count > 4;
    const std::string ending = heights ? ",0,15km" : "";
    throw Error("'" + text + "' is no box; write its west, east, south" +
                (heights ? ", north, bottom and top" : " and north") +
                " with units, as in -50km,20km,-40km,60km" + ending +
                " or -98deg,-97deg,35deg,36deg" + ending);
  }
  std::array<double, Count> faces{};
  for (std::size_t i = 0; i < Count; ++i)
  {
    faces[i] = i < 4 ? ParsePlace(parts[i], unit) : ParseLength(parts[i]);
    if (i % 2 == 1 && !(faces[i] > faces[i - 1]))
    {
      throw Error("'" + text + "' is no box: " + parts[i] + " is not above " + parts[i - 1]);
    }
  }
  return faces;
}

} // namespace

std::string NumberText(double value)
{
  std::array<char, 400> buffer{}; // room for every double
  return {buffer.data(),
    std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
      .ptr};
}

Duration ParseDuration(const std::string& text)
{
  const std::optional<double> seconds = FindAmount(text, durationUnits);
  constexpr double century = 100.0 * 366.0 * 86400.0;
  if (!seconds || *seconds < 0.0 || *seconds > century)
  {
    throw Error("'" + text + "' is no duration; write a number and s, min, h or d, as in 5min");
  }
  return Duration(std::llround(*seconds * 1000.0));
}

std::string DurationText(Duration duration)
{
  constexpr long minute = 60'000;
  const auto milliseconds = duration.count();
  return milliseconds % minute == 0 ? std::to_string(milliseconds / minute) + "min"
                                    : NumberText(static_cast<double>(milliseconds) / 1000.0) + "s";
}

Duration ParseInterval(const std::string& text)
{
  const Duration interval = ParseDuration(text);
  if (interval < std::chrono::milliseconds(16) || interval > std::chrono::seconds(8))
  {
    throw Error("'" + text + "' is no interval of steps; write 16 ms (0.016s) to 8s");
  }
  return interval;
}

double ParseLength(const std::string& text)
{
  const auto quantity = SplitQuantity(text);
  if (quantity && quantity->unit.empty())
  {
    if (quantity->number == 0.0)
    {
      return 0.0;
    }
    throw Error("'" + text + "' has no unit; write " + text + "km or " + text + "m");
  }
  const std::optional<double> metres = FindAmount(text, lengthUnits);
  if (!metres)
  {
    throw Error("'" + text + "' is no length; write a number and m or km, as in 230km");
  }
  return *metres;
}

std::string LengthText(double metres)
{
  return std::fmod(metres, 1000.0) == 0.0 ? NumberText(metres / 1000.0) + "km"
                                          : NumberText(metres) + "m";
}

std::size_t ParseMemory(const std::string& text)
{
  const std::optional<double> bytes = FindAmount(text, memoryUnits);
  constexpr double most = 1024.0 * 1024.0 * 1024.0 * 1024.0;
  if (!bytes || *bytes < 0.0 || *bytes > most)
  {
    throw Error("'" + text + "' is no size of memory; write a number and MiB or GiB, as in 512MiB");
  }
  return static_cast<std::size_t>(*bytes);
}

std::string BytesText(std::size_t bytes)
{
  std::size_t number = bytes;
  const char* unit = "";
  for (const char* larger : {"KiB", "MiB", "GiB"})
  {
    if (number == 0 || number % 1024 != 0)
    {
      break;
    }
    number /= 1024;
    unit = larger;
  }
  return std::to_string(number) + unit;
}

std::pair<double, double> ParseHeightRange(const std::string& text)
{
  const std::string right = "write the lower and the upper height, as in 0,20km";
  const std::vector<std::string> parts = SplitAtCommas(text);
  if (parts.size() != 2)
  {
    throw Error("'" + text + "' is no range of heights; " + right);
  }
  const auto lower = SplitQuantity(parts[0]);
  const auto upper = SplitQuantity(parts[1]);
  if (lower && upper && lower->unit.empty() && upper->unit.empty())
  {
    throw Error("'" + text + "' has no unit; write " + text + "km or " + text + "m");
  }
  const double top = ParseLength(parts[1]);
  const bool shared = lower && lower->unit.empty();
  const double bottom = ParseLength(shared ? parts[0] + upper->unit : parts[0]);
  if (bottom >= top)
  {
    throw Error("'" + text + "' has its lower bound above its upper bound; " + right);
  }
  return {bottom, top};
}

std::string HeightRangeText(double bottom, double top)
{
  return (bottom == 0.0 ? "0" : LengthText(bottom)) + "," + LengthText(top);
}

std::array<int, 3> ParseDimensions(const std::string& text)
{
  return ParseCounts<3>(text, 1, 100'000,
    "is no size of a grid; write three numbers of voxels from 1 on, as in 256x256x128");
}

std::string DimensionsText(const std::array<int, 3>& dimensions)
{
  const auto& [x, y, z] = dimensions;
  return std::to_string(x) + "x" + std::to_string(y) + "x" + std::to_string(z);
}

std::array<int, 2> ParsePictureSize(const std::string& text)
{
  return ParseCounts<2>(text, 16, 16'384,
    "is no size of a picture; write width and height from 16 to 16384 pixels, as in 1280x720");
}

GeographicBounds ParseBounds(const std::string& text)
{
  const std::vector<double> degrees = FindNumbers(text);
  if (degrees.size() != 4)
  {
    throw Error("'" + text +
                "' is no box; write west,south,east,north in degrees, as in "
                "-97,36,-86,43");
  }
  const GeographicBounds bounds{degrees[0], degrees[1], degrees[2], degrees[3]};
  if (bounds.west >= bounds.east || bounds.south >= bounds.north)
  {
    throw Error("'" + text +
                "' has its lower bound above its upper bound; write west,south,east,north in "
                "degrees with west "
                "below east and south below north");
  }
  if (bounds.west < -360.0 || bounds.east > 360.0 || bounds.south < -90.0 || bounds.north > 90.0)
  {
    throw Error("'" + text +
                "' is off the globe; longitudes lie in -360…360 and latitudes in "
                "-90…90 degrees");
  }
  return bounds;
}

std::string BoundsText(const GeographicBounds& bounds)
{
  return NumberText(bounds.west) + "," + NumberText(bounds.south) + "," + NumberText(bounds.east) +
         "," + NumberText(bounds.north);
}

double ParseDegrees(const std::string& text)
{
  const std::vector<double> numbers = FindNumbers(text);
  if (numbers.size() != 1 || std::abs(numbers.front()) > 360.0)
  {
    throw Error("'" + text + "' is no angle; write degrees, -360 to 360");
  }
  return numbers.front();
}

double ParsePlace(const std::string& text, PlaceUnit& unit)
{
  const auto quantity = SplitQuantity(text);
  if (quantity && quantity->unit.empty())
  {
    if (quantity->number == 0.0)
    {
      return 0.0;
    }
    throw Error(
      "'" + text + "' has no unit; write " + text + "km, " + text + "m or " + text + "deg");
  }
  constexpr std::size_t letters = 3; // of deg
  const bool degrees = quantity && quantity->unit == "deg";
  if (!degrees && !FindAmount(text, lengthUnits))
  {
    throw Error("'" + text + "' is no place; write a number and km, m or deg, as in 20km");
  }
  const double place =
    degrees ? ParseDegrees(text.substr(0, text.size() - letters)) : ParseLength(text);
  const PlaceUnit ofText = degrees ? PlaceUnit::Degrees : PlaceUnit::Metres;
  if (unit != PlaceUnit::OfVolume && unit != ofText)
  {
    throw Error("'" + text +
                "': some places are in degrees and some in m or km; write all of them in degrees "
                "for a volume on axes of longitude and latitude, else in m or km");
  }
  unit = ofText;
  return place;
}

std::array<double, 4> ParseBox(const std::string& text, PlaceUnit& unit)
{
  return ParseFaces<4>(text, unit);
}

std::array<double, 6> ParseBoxWithHeights(const std::string& text, PlaceUnit& unit)
{
  return ParseFaces<6>(text, unit);
}

Velocity ParseMotion(const std::string& text)
{
  const std::vector<double> numbers = FindNumbers(text);
  if (numbers.size() != 2)
  {
    throw Error("'" + text + "' is no motion; write m/s towards east and north, as in 12,-7.5");
  }
  if (std::hypot(numbers[0], numbers[1]) > FastestEcho)
  {
    throw Error("'" + text +
                "' is faster than any echo; write m/s towards east and north, of a "
                "speed of at most 150 m/s");
  }
  return {numbers[0], numbers[1]};
}

std::string MotionText(const Velocity& motion)
{
  return NumberText(motion.east) + "," + NumberText(motion.north);
}

Time ParseTime(const std::string& text)
{
  const auto time = ParseIso8601(text);
  if (!time)
  {
    throw Error("'" + text + "' is no time; write it in UTC, as in 2006-03-12T18:00");
  }
  return *time;
}

std::vector<std::string> SplitAtCommas(const std::string& text)
{
  return SplitAt(text, ',');
}

std::vector<double> FindNumbers(const std::string& text)
{
  std::vector<double> numbers;
  for (const std::string& part : SplitAtCommas(text))
  {
    const auto quantity = SplitQuantity(part);
    if (!quantity || !quantity->unit.empty())
    {
      return {};
    }
    numbers.push_back(quantity->number);
  }
  return numbers;
}

} // namespace nexrad
