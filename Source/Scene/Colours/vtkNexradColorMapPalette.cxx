// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradColorMapPalette.h"

#include "vtkNexradPaletteStatements.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <locale>
#include <optional>
#include <sstream>
#include <utility>

namespace
{

constexpr double highestByte = 255.0;

using Statement = vtkNexradPaletteStatement;
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
std::vector<Statement> InOrder(const std::vector<Statement>& all,
  const vtkNexradColorMap::Labels& labels, vtkNexradColorMap& map)
{
  std::vector<Statement> placed;
  for (Statement statement : all)
  {
    statement.From = (statement.From - labels.Offset) / labels.Factor;
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
  vtkNexradPaletteStatements read = vtkNexradReadPaletteStatements(text);
  map.PassedOver = std::move(read.PassedOver);
  const std::vector<Statement> statements = InOrder(read.Colors, read.Labels, map);
  if (statements.size() < 2)
  {
    const std::string first = map.PassedOver.empty() ? "" : map.PassedOver.front() + "; ";
    return first + "a colour table needs two colours at least, as in 'Color: 20 2 253 2'";
  }
  map.Bar = read.Labels;
  map.RangeFolded = read.RangeFolded;
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
