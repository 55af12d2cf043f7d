// SPDX-License-Identifier: BSD-3-Clause
#include "ColourTable.h"

#include "Model/Error.h"

#include <vtkColorTransferFunction.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <sstream>

namespace nexrad::embedded
{
extern const unsigned char reflectivityColours[];
extern const std::size_t reflectivityColoursSize;
} // namespace nexrad::embedded

namespace nexrad::scene
{
namespace
{

std::optional<Colour> ParseHexColour(const std::string& text)
{
  if (text.size() != 7 || text[0] != '#' ||
      text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
  {
    return std::nullopt;
  }
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i)
  {
    colour[i] = std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
  }
  return colour;
}

std::optional<ColourBin> ParseRow(const std::string& line)
{
  const std::size_t comma = line.find(',');
  if (comma == std::string::npos)
  {
    return std::nullopt;
  }
  char* end = nullptr;
  const double value = std::strtod(line.c_str(), &end);
  const auto colour = ParseHexColour(line.substr(comma + 1));
  if (end != line.c_str() + comma || comma == 0 || !colour)
  {
    return std::nullopt;
  }
  return ColourBin{value, *colour};
}

} // namespace

ColourTable ParseColourTable(const std::string& text, const std::string& name)
{
  ColourTable table;
  std::istringstream stream(text);
  std::string line;
  std::getline(stream, line); // the heading
  for (int number = 2; std::getline(stream, line); ++number)
  {
    if (!line.empty() && line.back() == '\r')
    {
      line.pop_back();
    }
    if (line.empty())
    {
      continue;
    }
    const auto bin = ParseRow(line);
    if (!bin || (!table.empty() && !(bin->from > table.back().from)))
    {
      throw Error(name + ": line " + std::to_string(number) + ": '" + line +
                  "' is no row of a colour table; write an ascending value in dBZ and a colour, as "
                  "in 20,#02fd02");
    }
    table.push_back(*bin);
  }
  if (table.size() < 2)
  {
    throw Error(name + ": a colour table needs a heading and two rows at least");
  }
  return table;
}

ColourTable ReadColourTable(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (!stream)
  {
    throw Error(path.string() + ": cannot be read as a colour table");
  }
  return ParseColourTable(text, path.string());
}

const ColourTable& WeatherServiceColours()
{
  static const ColourTable table =
    ParseColourTable(std::string(embedded::reflectivityColours,
                       embedded::reflectivityColours + embedded::reflectivityColoursSize),
      "reflectivity colours");
  return table;
}

double UpperEnd(const ColourTable& table)
{
  const std::size_t last = table.size() - 1;
  return 2.0 * table[last].from - table[last - 1].from;
}

void FillSmooth(vtkColorTransferFunction* function, const ColourTable& table)
{
  function->RemoveAllPoints();
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const double end = i + 1 < table.size() ? table[i + 1].from : UpperEnd(table);
    const Colour& colour = table[i].colour;
    function->AddRGBPoint((table[i].from + end) / 2.0, colour[0], colour[1], colour[2]);
  }
}

} // namespace nexrad::scene
