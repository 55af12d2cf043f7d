// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapPalette.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <locale>
#include <optional>
#include <sstream>

namespace
{

constexpr double highestByte = 255.0;

// A colour statement of a .pal table.
struct Statement
{
  double From = 0.0;
  std::array<double, 4> Color{};                // red, green, blue, opacity
  std::optional<std::array<double, 4>> Towards; // what the ramp ends in; empty: the next colour
  bool Solid = false;
  bool HasOpacity = false;
};

std::istringstream Stream(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  return stream;
}

std::string LineError(int number, const std::string& what)
{
  return "line " + std::to_string(number) + ": " + what;
}

std::vector<double> ReadNumbers(const std::string& text, bool& complete)
{
  std::istringstream stream = Stream(text);
  std::vector<double> numbers;
  double number = 0.0;
  while (stream >> number)
  {
    numbers.push_back(number);
  }
  complete = stream.eof();
  return numbers;
}

bool AreBytes(std::vector<double>::const_iterator from, std::vector<double>::const_iterator to)
{
  return std::all_of(from, to, [](double byte) { return byte >= 0.0 && byte <= highestByte; });
}

std::array<double, 4> ColorOf(std::vector<double>::const_iterator from, std::size_t channels)
{
  std::array<double, 4> color{0.0, 0.0, 0.0, 1.0};
  for (std::size_t i = 0; i < channels; ++i)
  {
    color[i] = from[static_cast<std::ptrdiff_t>(i)] / highestByte;
  }
  return color;
}

// Value, colour and perhaps a second colour; empty when the numbers are not that.
std::optional<Statement> ReadStatement(const std::string& key, const std::string& rest)
{
  bool complete = false;
  const std::vector<double> numbers = ReadNumbers(rest, complete);
  const std::size_t channels = key.back() == '4' ? 4 : 3;
  const bool two = numbers.size() == 1 + 2 * channels;
  if (!complete || !(two || numbers.size() == 1 + channels) || !std::isfinite(numbers[0]) ||
      !AreBytes(numbers.begin() + 1, numbers.end()))
  {
    return std::nullopt;
  }
  Statement statement;
  statement.From = numbers[0];
  statement.Solid = key.front() == 's';
  statement.HasOpacity = channels == 4;
  statement.Color = ColorOf(numbers.begin() + 1, channels);
  if (two && !statement.Solid)
  {
    statement.Towards =
      ColorOf(numbers.begin() + 1 + static_cast<std::ptrdiff_t>(channels), channels);
  }
  return statement;
}

vtkNexradColorMap::Color RedGreenBlue(const std::array<double, 4>& color)
{
  return {color[0], color[1], color[2]};
}

// The last statement has no successor: its box is as wide as the one before it.
double EndOf(const std::vector<Statement>& statements, std::size_t i)
{
  const std::size_t last = statements.size() - 1;
  return i < last ? statements[i + 1].From
                  : 2.0 * statements[last].From - statements[last - 1].From;
}

void AddBins(const std::vector<Statement>& statements, vtkNexradColorMap& map)
{
  for (std::size_t i = 0; i < statements.size(); ++i)
  {
    const Statement& statement = statements[i];
    std::array<double, 4> end = statement.Color;
    if (statement.Towards)
    {
      end = *statement.Towards;
    }
    else if (!statement.Solid && i + 1 < statements.size())
    {
      end = statements[i + 1].Color;
    }
    map.Bins.push_back(
      {statement.From, EndOf(statements, i), RedGreenBlue(statement.Color), RedGreenBlue(end)});
    if (statement.HasOpacity)
    {
      map.Channels[3].push_back({statement.From, statement.Color[3]});
    }
  }
}

std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

std::string Trim(const std::string& text)
{
  const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

bool IsColorKey(const std::string& key)
{
  return key == "color" || key == "color4" || key == "solidcolor" || key == "solidcolor4";
}

// Values of the table are scale × dBZ + offset.
struct Units
{
  double Scale = 1.0;
  double Offset = 0.0;
};

bool ReadUnits(const std::string& key, const std::string& rest, Units& units)
{
  bool complete = false;
  const std::vector<double> numbers = ReadNumbers(rest, complete);
  if (!complete || numbers.size() != 1 || !std::isfinite(numbers[0]) ||
      (key == "scale" && numbers[0] == 0.0))
  {
    return false;
  }
  (key == "scale" ? units.Scale : units.Offset) = numbers[0];
  return true;
}

std::string Finish(std::vector<Statement>& statements, const Units& units, vtkNexradColorMap& map)
{
  if (statements.size() < 2)
  {
    return "a colour table needs two colours at least, as in 'Color: 20 2 253 2'";
  }
  for (Statement& statement : statements)
  {
    statement.From = (statement.From - units.Offset) / units.Scale;
    if (!(std::abs(statement.From) <= vtkNexradColorMap::LargestPlace))
    {
      return "a colour stands at a value beyond 1e30; check Scale and Offset";
    }
  }
  const auto lower = [](const Statement& a, const Statement& b) { return a.From < b.From; };
  std::stable_sort(statements.begin(), statements.end(), lower);
  for (std::size_t i = 1; i < statements.size(); ++i)
  {
    if (!vtkNexradColorMap::IsAbove(statements[i].From, statements[i - 1].From))
    {
      return "two colours stand at the same value; each needs a value of its own";
    }
  }
  AddBins(statements, map);
  map.MakeColorNodesFromBins();
  return {};
}

int ByteOf(double value)
{
  return static_cast<int>(std::lround(std::clamp(value, 0.0, 1.0) * highestByte));
}

std::string FormatNumbers(const char* key, double value, std::initializer_list<double> channels)
{
  std::ostringstream line;
  line.imbue(std::locale::classic());
  line << key << ' ' << value;
  for (const double channel : channels)
  {
    line << ' ' << ByteOf(channel);
  }
  line << '\n';
  return line.str();
}

std::optional<vtkNexradColorMap::Color> ParseHexColor(const std::string& text)
{
  unsigned int red = 0;
  unsigned int green = 0;
  unsigned int blue = 0;
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos ||
      std::sscanf(text.c_str(), "#%2x%2x%2x", &red, &green, &blue) != 3)
  {
    return std::nullopt;
  }
  return vtkNexradColorMap::Color{red / highestByte, green / highestByte, blue / highestByte};
}

} // namespace

namespace vtkNexradColorMapText
{

std::string ParsePalette(const std::string& text, vtkNexradColorMap& map)
{
  std::istringstream lines(text);
  std::vector<Statement> statements;
  Units units;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number)
  {
    const std::string content = Trim(line.substr(0, line.find(';')));
    const std::size_t colon = content.find(':');
    if (content.empty())
    {
      continue;
    }
    if (colon == std::string::npos)
    {
      return LineError(number, "'" + content + "' is no statement; write 'Color: 20 2 253 2'");
    }
    const std::string key = ToLower(Trim(content.substr(0, colon)));
    const std::string rest = content.substr(colon + 1);
    if (IsColorKey(key))
    {
      const std::optional<Statement> statement = ReadStatement(key, rest);
      if (!statement)
      {
        return LineError(number, "'" + content + "' must hold a value and " +
                                   (key.back() == '4' ? "four" : "three") +
                                   " numbers from 0 to 255, once or twice");
      }
      statements.push_back(*statement);
    }
    else if ((key == "scale" || key == "offset") && !ReadUnits(key, rest, units))
    {
      return LineError(number, "'" + content + "' must hold one number, and no scale of 0");
    }
  }
  return Finish(statements, units, map);
}

namespace
{

// What such tables call the moment and its unit.
std::string ProductOf(const std::string& array)
{
  constexpr const char* products[][2] = {{"REF", "Product: BR\nUnits: DBZ\nStep: 10\n"},
    {"VEL", "Product: BV\nUnits: M/S\nStep: 10\n"}, {"SW", "Product: SW\nUnits: M/S\nStep: 2\n"},
    {"ZDR", "Product: ZDR\nUnits: DB\nStep: 1\n"}, {"PHI", "Product: PHI\nUnits: DEG\nStep: 30\n"},
    {"RHO", "Product: CC\nStep: 0.1\n"}, {"CFP", "Product: CFP\nUnits: DB\nStep: 10\n"}};
  for (const auto& product : products)
  {
    if (array == product[0])
    {
      return product[1];
    }
  }
  return "";
}

} // namespace

std::string FormatPalette(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples)
{
  std::string text = "; " + map.Name + "\n" + ProductOf(map.Array);
  for (const vtkNexradColorMap::Bin& bin : map.Bins)
  {
    if (bin.Lower == bin.Upper)
    {
      text += FormatNumbers("SolidColor:", bin.From, {bin.Lower[0], bin.Lower[1], bin.Lower[2]});
    }
    else
    {
      text += FormatNumbers("Color:", bin.From,
        {bin.Lower[0], bin.Lower[1], bin.Lower[2], bin.Upper[0], bin.Upper[1], bin.Upper[2]});
    }
  }
  if (map.Bins.empty())
  {
    for (const std::array<double, 5>& sample : samples)
    {
      text += FormatNumbers("Color4:", sample[0], {sample[1], sample[2], sample[3], sample[4]});
    }
  }
  return text;
}

std::string ParseTable(const std::string& text, vtkNexradColorMap& map)
{
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line); // the heading
  std::vector<Statement> statements;
  for (int number = 2; std::getline(lines, line); ++number)
  {
    const std::string content = Trim(line);
    if (content.empty())
    {
      continue;
    }
    const std::size_t comma = content.find(',');
    bool complete = false;
    const std::vector<double> value = ReadNumbers(content.substr(0, comma), complete);
    const auto color =
      comma == std::string::npos ? std::nullopt : ParseHexColor(Trim(content.substr(comma + 1)));
    if (!complete || value.size() != 1 || !color ||
        !(std::abs(value[0]) <= vtkNexradColorMap::LargestPlace) ||
        (!statements.empty() && !vtkNexradColorMap::IsAbove(value[0], statements.back().From)))
    {
      return LineError(number,
        "'" + content + "' is no row of a colour table; write an ascending value in dBZ and a " +
          "colour, as in 20,#02fd02");
    }
    Statement statement;
    statement.From = value[0];
    statement.Solid = true;
    statement.Color = {(*color)[0], (*color)[1], (*color)[2], 1.0};
    statements.push_back(statement);
  }
  if (statements.size() < 2)
  {
    return "a colour table needs a heading and two rows at least";
  }
  AddBins(statements, map);
  map.MakeColorNodesFromBins();
  return {};
}

} // namespace vtkNexradColorMapText
