// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapPalette.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <locale>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace
{

// A colour statement of a table.
struct Statement
{
  using Color = std::array<double, 4>; ///< red, green, blue, opacity

  double From = 0.0; ///< unit of the table
  Color Lower{};
  std::optional<Color> Towards; ///< what the ramp ends in; empty: the next colour
  bool Solid = false;
  bool HasOpacity = false;
  int Line = 0; ///< of the file, from 1 on
};

// A text of a table without the blanks at its ends.
std::string vtkNexradTrimmed(const std::string& text)
{
  const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

// The finite numbers of such a text; empty when it holds anything else.
std::optional<std::vector<double>> vtkNexradReadNumbers(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  std::vector<double> numbers;
  double number = 0.0;
  while (stream >> number)
  {
    numbers.push_back(number);
  }
  const bool finite =
    std::all_of(numbers.begin(), numbers.end(), [](double each) { return std::isfinite(each); });
  return stream.eof() && finite ? std::optional(numbers) : std::nullopt;
}

// "line 3: what".
std::string vtkNexradPaletteLine(int number, const std::string& what)
{
  return "line " + std::to_string(number) + ": " + what;
}

constexpr double fullByte = 255.0;

// A unit of speed, the ways in which tables write it, and how many of it are 1 m/s.
struct Speed
{
  const char* Unit;
  std::vector<std::string> Spellings;
  double Factor;
};

const std::vector<Speed>& Speeds()
{
  static const std::vector<Speed> speeds = {{"m/s", {"m/s", "mps", "ms"}, 1.0},
    {"kt", {"kt", "kts", "kn", "knot", "knots"}, 3600.0 / 1852.0},
    {"mph", {"mph", "mi/h"}, 3600.0 / 1609.344}, {"km/h", {"km/h", "kmh", "kph"}, 3.6}};
  return speeds;
}

std::string ToLower(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

using Numbers = std::vector<double>::const_iterator;

bool AreBytes(Numbers from, Numbers to)
{
  return std::all_of(from, to, [](double byte) { return byte >= 0.0 && byte <= fullByte; });
}

Statement::Color ColorOf(Numbers from, std::size_t channels)
{
  Statement::Color color{0.0, 0.0, 0.0, 1.0};
  std::transform(from, from + static_cast<std::ptrdiff_t>(channels), color.begin(),
    [](double byte) { return byte / fullByte; });
  return color;
}

// Value, colour and perhaps a second colour; empty when the numbers are not that.
std::optional<Statement> ReadColor(const std::string& key, const std::string& rest)
{
  const auto numbers = vtkNexradReadNumbers(rest);
  const std::size_t channels = key.back() == '4' ? 4 : 3;
  const bool two = numbers && numbers->size() == 1 + 2 * channels;
  if (!numbers || !(two || numbers->size() == 1 + channels) ||
      !AreBytes(numbers->begin() + 1, numbers->end()))
  {
    return std::nullopt;
  }
  Statement statement;
  statement.From = numbers->front();
  statement.Solid = key.front() == 's';
  statement.HasOpacity = channels == 4;
  statement.Lower = ColorOf(numbers->begin() + 1, channels);
  if (two && !statement.Solid)
  {
    statement.Towards =
      ColorOf(numbers->begin() + 1 + static_cast<std::ptrdiff_t>(channels), channels);
  }
  return statement;
}

// Tables are in any encoding: bytes that are no UTF-8 become its replacement character.
std::string ValidText(const std::string& text)
{
  using Json = nlohmann::json;
  return Json::parse(Json(text).dump(-1, ' ', false, Json::error_handler_t::replace))
    .get<std::string>();
}

const Speed* FindSpeed(const std::string& unit)
{
  const auto found = std::find_if(Speeds().begin(), Speeds().end(),
    [spelling = ToLower(unit)](const Speed& speed)
    {
      const auto& all = speed.Spellings;
      return std::find(all.begin(), all.end(), spelling) != all.end();
    });
  return found != Speeds().end() ? &*found : nullptr;
}

const Speed* FindSpeed(double factor)
{
  constexpr double tolerance = 0.01; // tables round: the specification's knots are 1.9426
  const auto found = std::find_if(Speeds().begin(), Speeds().end(),
    [factor](const Speed& speed) { return std::abs(factor / speed.Factor - 1.0) < tolerance; });
  return found != Speeds().end() ? &*found : nullptr;
}

// Reads a file line by line into a map, but for the colours: keys in any order and any case; text
// behind a semicolon is a comment.
class Reader
{
public:
  explicit Reader(vtkNexradColorMap& read)
    : map(read)
  {
  }

  std::vector<Statement> Colors; // in the order of the file

  void Read(const std::string& line)
  {
    ++number;
    content = vtkNexradTrimmed(line.substr(0, line.find(';')));
    if (content.empty())
    {
      return;
    }
    const std::size_t colon = content.find(':');
    if (colon == std::string::npos)
    {
      this->PassOver("is no statement; write 'Color: 20 2 253 2'");
      return;
    }
    this->ReadStatement(ToLower(vtkNexradTrimmed(content.substr(0, colon))),
      vtkNexradTrimmed(content.substr(colon + 1)));
  }

  // A bar that called knots miles an hour would be read wrongly: the scale decides.
  void CheckUnit()
  {
    std::string& unit = map.Bar.Unit;
    const Speed* const scaled = FindSpeed(map.Bar.Factor);
    const Speed* const said = FindSpeed(unit);
    if (said != nullptr && scaled != nullptr && said != scaled)
    {
      map.PassedOver.push_back(vtkNexradPaletteLine(
        unitLine, "the unit " + unit + " does not fit the scale, which is of " + scaled->Unit));
    }
    if (scaled != nullptr && (said != nullptr || (unit.empty() && map.Bar.Factor != 1.0)))
    {
      unit = scaled->Unit;
    }
    else if (said != nullptr)
    {
      unit = said->Unit;
    }
  }

private:
  void PassOver(const std::string& why)
  {
    map.PassedOver.push_back(vtkNexradPaletteLine(number, "'" + content + "' " + why));
  }

  void ReadStatement(const std::string& key, const std::string& rest)
  {
    if (key == "color" || key == "color4" || key == "solidcolor" || key == "solidcolor4")
    {
      this->AddColor(key, rest);
    }
    else if (key == "scale" || key == "offset" || key == "step" || key == "decimals")
    {
      this->SetNumber(key, rest);
    }
    else if (key == "units")
    {
      map.Bar.Unit = ToLower(rest) == "dbz" ? "dBZ" : ValidText(rest);
      unitLine = number;
    }
    else if (key == "rf")
    {
      this->SetRangeFolded(rest);
    }
    else if (key != "product" && key != "nd")
    {
      this->PassOver("is no statement of a colour table; write 'Color: 20 2 253 2'");
    }
  }

  void AddColor(const std::string& key, const std::string& rest)
  {
    std::optional<Statement> statement = ReadColor(key, rest);
    if (!statement)
    {
      this->PassOver(std::string("must hold a value and ") +
                     (key.back() == '4' ? "four" : "three") +
                     " numbers from 0 to 255, once or twice");
      return;
    }
    statement->Line = number;
    Colors.push_back(*statement);
  }

  void SetNumber(const std::string& key, const std::string& rest)
  {
    constexpr double mostDecimals = 6.0;
    const auto numbers = vtkNexradReadNumbers(rest);
    if (!numbers || numbers->size() != 1)
    {
      this->PassOver("must hold one number");
      return;
    }
    const double value = numbers->front();
    if (key == "offset")
    {
      map.Bar.Offset = value;
    }
    else if (key == "scale" && value != 0.0)
    {
      map.Bar.Factor = value;
    }
    else if (key == "step" && value > 0.0)
    {
      map.Bar.Step = value;
    }
    else if (key == "decimals" && value >= 0.0 && value <= mostDecimals)
    {
      map.Bar.Decimals = static_cast<int>(value);
    }
    else
    {
      this->PassOver(
        key == "decimals" ? "must hold a number from 0 to 6" : "must hold a number above 0");
    }
  }

  void SetRangeFolded(const std::string& rest)
  {
    const auto numbers = vtkNexradReadNumbers(rest);
    if (!numbers || numbers->size() < 3 || !AreBytes(numbers->begin(), numbers->end()))
    {
      this->PassOver("must hold three numbers from 0 to 255");
      return;
    }
    const Statement::Color color = ColorOf(numbers->begin(), 3);
    map.RangeFolded = {color[0], color[1], color[2]};
  }

  vtkNexradColorMap& map;
  int number = 0;
  int unitLine = 0;
  std::string content;
};

// Line ends of any system become one letter each, and the byte order mark goes.
std::string Plain(const std::string& text)
{
  std::string plain;
  for (std::size_t i = text.compare(0, 3, "\xEF\xBB\xBF") == 0 ? 3 : 0; i < text.size(); ++i)
  {
    const bool firstOfTwo = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!firstOfTwo)
    {
      plain += text[i] == '\r' ? '\n' : text[i];
    }
  }
  return plain;
}

using Node = vtkNexradColorMap::Node;

vtkNexradColorMap::Color RedGreenBlue(const Statement::Color& color)
{
  return {color[0], color[1], color[2]};
}

// Where the box of a statement ends. The last one has no successor: its box is as wide as the one
// before it.
double EndOf(const std::vector<Statement>& statements, std::size_t i)
{
  const std::size_t last = statements.size() - 1;
  return i < last ? statements[i + 1].From
                  : 2.0 * statements[last].From - statements[last - 1].From;
}

// The colour just below that end.
Statement::Color UpperOf(const std::vector<Statement>& statements, std::size_t i)
{
  const Statement& statement = statements[i];
  const bool towardsNext = !statement.Solid && i + 1 < statements.size();
  return statement.Towards ? *statement.Towards
         : towardsNext     ? statements[i + 1].Lower
                           : statement.Lower;
}

void AddBins(const std::vector<Statement>& statements, vtkNexradColorMap& map)
{
  for (std::size_t i = 0; i < statements.size(); ++i)
  {
    map.Bins.push_back({statements[i].From, EndOf(statements, i), RedGreenBlue(statements[i].Lower),
      RedGreenBlue(UpperOf(statements, i))});
  }
}

// A place just below another: values jump between the two.
double JustBelow(double place, double width)
{
  constexpr double share = 1e-6;    // of the width of a box
  constexpr double relative = 1e-8; // far enough for vtkNexradColorMap::IsAbove
  return place - std::min(0.5 * width, std::max(share * width, relative * std::abs(place)));
}

// One channel of the statements in straight lines, with a node where its slope changes and two
// where it jumps.
std::vector<Node> LinearNodes(const std::vector<Statement>& statements, std::size_t channel)
{
  std::vector<Node> nodes = {{statements[0].From, statements[0].Lower[channel]}};
  for (std::size_t i = 1; i < statements.size(); ++i)
  {
    const double from = statements[i].From;
    const double value = statements[i].Lower[channel];
    const double below = UpperOf(statements, i - 1)[channel];
    const double before = statements[i - 1].Lower[channel];
    const double above = UpperOf(statements, i)[channel];
    if (before == value && below == value && above == value)
    {
      continue;
    }
    if (below != value)
    {
      const double width = from - statements[i - 1].From;
      const double place = JustBelow(from, width);
      const double share = (place - statements[i - 1].From) / width;
      nodes.push_back({place, before + share * (below - before)});
    }
    nodes.push_back({from, value});
  }
  const std::size_t last = statements.size() - 1;
  const double end = UpperOf(statements, last)[channel];
  if (end != statements[last].Lower[channel])
  {
    nodes.push_back({EndOf(statements, last), end});
  }
  return nodes;
}

// Nothing shows below the first statement.
void SetOpacities(const std::vector<Statement>& statements, vtkNexradColorMap& map)
{
  constexpr std::size_t opacity = 3;
  std::vector<Node>& nodes = map.Channels[opacity];
  nodes = LinearNodes(statements, opacity);
  map.Linear[opacity] = true;
  if (nodes.front()[1] > 0.0)
  {
    const double width = statements[1].From - statements[0].From;
    nodes.insert(nodes.begin(), Node{JustBelow(nodes.front()[0], width), 0.0});
  }
}

void SetColors(const std::vector<Statement>& statements, vtkNexradColorMap& map)
{
  const bool ramps = std::any_of(map.Bins.begin(), map.Bins.end(),
    [](const vtkNexradColorMap::Bin& bin) { return !(bin.Lower == bin.Upper); });
  if (!ramps)
  {
    map.MakeColorNodesFromBins();
    return;
  }
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    map.Channels[channel] = LinearNodes(statements, channel);
    map.Linear[channel] = true;
  }
}

// The statements in ascending order of the data's values. Those too far off are passed over; of two
// at one value the later counts.
std::vector<Statement> InOrder(const std::vector<Statement>& all, vtkNexradColorMap& map)
{
  std::vector<Statement> placed;
  for (Statement statement : all)
  {
    statement.From = (statement.From - map.Bar.Offset) / map.Bar.Factor;
    if (std::abs(statement.From) <= vtkNexradColorMap::LargestPlace)
    {
      placed.push_back(statement);
    }
    else
    {
      map.PassedOver.push_back(vtkNexradPaletteLine(
        statement.Line, "a colour stands at a value beyond 1e30; check Scale and Offset"));
    }
  }
  const auto lower = [](const Statement& a, const Statement& b) { return a.From < b.From; };
  std::stable_sort(placed.begin(), placed.end(), lower);
  std::vector<Statement> ordered;
  for (const Statement& statement : placed)
  {
    if (!ordered.empty() && !vtkNexradColorMap::IsAbove(statement.From, ordered.back().From))
    {
      ordered.back() = statement.Line > ordered.back().Line ? statement : ordered.back();
      continue;
    }
    ordered.push_back(statement);
  }
  return ordered;
}

int ByteOf(double value)
{
  return static_cast<int>(std::lround(std::clamp(value, 0.0, 1.0) * fullByte));
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
  return vtkNexradColorMap::Color{red / fullByte, green / fullByte, blue / fullByte};
}

} // namespace

namespace vtkNexradColorMapText
{

std::string ParsePalette(const std::string& text, vtkNexradColorMap& map)
{
  Reader reader(map);
  std::istringstream lines(Plain(text));
  std::string line;
  while (std::getline(lines, line))
  {
    reader.Read(line);
  }
  reader.CheckUnit();
  const std::vector<Statement> statements = InOrder(reader.Colors, map);
  if (statements.size() < 2)
  {
    const std::string first = map.PassedOver.empty() ? "" : map.PassedOver.front() + "; ";
    return first + "a colour table needs two colours at least, as in 'Color: 20 2 253 2'";
  }
  AddBins(statements, map);
  SetColors(statements, map);
  if (std::any_of(statements.begin(), statements.end(),
        [](const Statement& statement) { return statement.HasOpacity; }))
  {
    SetOpacities(statements, map);
  }
  return {};
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

std::string LabelsOf(const vtkNexradColorMap::Labels& labels)
{
  std::ostringstream lines;
  lines.imbue(std::locale::classic());
  lines.precision(std::numeric_limits<double>::max_digits10);
  lines << (labels.Unit.empty() ? "" : "Units: " + labels.Unit + "\n") << "Scale: " << labels.Factor
        << "\nOffset: " << labels.Offset << '\n';
  if (labels.Step > 0.0)
  {
    lines << "Step: " << labels.Step << '\n';
  }
  if (labels.Decimals >= 0)
  {
    lines << "Decimals: " << labels.Decimals << '\n';
  }
  return lines.str();
}

} // namespace

std::string FormatPalette(
  const vtkNexradColorMap& map, const std::vector<std::array<double, 5>>& samples)
{
  const bool own = map.Bar == vtkNexradColorMap::Labels();
  std::string text = "; " + map.Name + "\n" + (own ? ProductOf(map.Array) : LabelsOf(map.Bar));
  const auto written = [&map](double place) { return place * map.Bar.Factor + map.Bar.Offset; };
  for (const vtkNexradColorMap::Bin& bin : map.Bins)
  {
    const double from = written(bin.From);
    if (bin.Lower == bin.Upper)
    {
      text += FormatNumbers("SolidColor:", from, {bin.Lower[0], bin.Lower[1], bin.Lower[2]});
    }
    else
    {
      text += FormatNumbers("Color:", from,
        {bin.Lower[0], bin.Lower[1], bin.Lower[2], bin.Upper[0], bin.Upper[1], bin.Upper[2]});
    }
  }
  if (map.Bins.empty())
  {
    for (const std::array<double, 5>& sample : samples)
    {
      text +=
        FormatNumbers("Color4:", written(sample[0]), {sample[1], sample[2], sample[3], sample[4]});
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
    const std::string content = vtkNexradTrimmed(line);
    if (content.empty())
    {
      continue;
    }
    const std::size_t comma = content.find(',');
    const auto value = vtkNexradReadNumbers(content.substr(0, comma));
    const auto color = comma == std::string::npos
                         ? std::nullopt
                         : ParseHexColor(vtkNexradTrimmed(content.substr(comma + 1)));
    if (!value || value->size() != 1 || !color ||
        !(std::abs(value->front()) <= vtkNexradColorMap::LargestPlace) ||
        (!statements.empty() &&
          !vtkNexradColorMap::IsAbove(value->front(), statements.back().From)))
    {
      return vtkNexradPaletteLine(number,
        "'" + content + "' is no row of a colour table; write an ascending value in dBZ and a " +
          "colour, as in 20,#02fd02");
    }
    Statement statement;
    statement.From = value->front();
    statement.Solid = true;
    statement.Lower = {(*color)[0], (*color)[1], (*color)[2], 1.0};
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
