// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNexradPaletteStatements.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <locale>
#include <sstream>
#include <utility>

namespace
{

constexpr double fullByte = 255.0;

using Statement = vtkNexradPaletteStatement;

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

// Reads a file line by line.
class Reader
{
public:
  vtkNexradPaletteStatements Found;

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
    std::string& unit = Found.Labels.Unit;
    const Speed* const scaled = FindSpeed(Found.Labels.Factor);
    const Speed* const said = FindSpeed(unit);
    if (said != nullptr && scaled != nullptr && said != scaled)
    {
      Found.PassedOver.push_back(vtkNexradPaletteLine(
        unitLine, "the unit " + unit + " does not fit the scale, which is of " + scaled->Unit));
    }
    if (scaled != nullptr && (said != nullptr || (unit.empty() && Found.Labels.Factor != 1.0)))
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
    Found.PassedOver.push_back(vtkNexradPaletteLine(number, "'" + content + "' " + why));
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
      Found.Labels.Unit = ToLower(rest) == "dbz" ? "dBZ" : ValidText(rest);
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
    Found.Colors.push_back(*statement);
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
      Found.Labels.Offset = value;
    }
    else if (key == "scale" && value != 0.0)
    {
      Found.Labels.Factor = value;
    }
    else if (key == "step" && value > 0.0)
    {
      Found.Labels.Step = value;
    }
    else if (key == "decimals" && value >= 0.0 && value <= mostDecimals)
    {
      Found.Labels.Decimals = static_cast<int>(value);
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
    Found.RangeFolded = {color[0], color[1], color[2]};
  }

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

} // namespace

std::string vtkNexradTrimmed(const std::string& text)
{
  const char* blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string()
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

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

std::string vtkNexradPaletteLine(int number, const std::string& what)
{
  return "line " + std::to_string(number) + ": " + what;
}

vtkNexradPaletteStatements vtkNexradReadPaletteStatements(const std::string& text)
{
  Reader reader;
  std::istringstream lines(Plain(text));
  std::string line;
  while (std::getline(lines, line))
  {
    reader.Read(line);
  }
  reader.CheckUnit();
  return std::move(reader.Found);
}
