// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Settings/Setting.h"

#include <nlohmann/json.hpp>

#include <charconv>

namespace nexrad
{
namespace
{

template <typename Number>
std::function<Number(const std::string&)> NumberParser(
  Number least, Number most, const std::string& refusal)
{
  const std::string wrong =
    !refusal.empty() ? refusal
                     : "is no number from " + NumberText(least) + " to " + NumberText(most);
  return [least, most, wrong](const std::string& text)
  {
    Number number{};
    const char* begin = text.data() + (text[0] == '+' ? 1 : 0);
    const char* end = text.data() + text.size();
    const auto [stop, failure] = std::from_chars(begin, end, number);
    if (failure != std::errc() || stop != end || !(number >= least && number <= most))
    {
      throw Error("'" + text + "' " + wrong);
    }
    return number;
  };
}

} // namespace

ValueType<Duration> DurationValue()
{
  return {{"duration", "DURATION", {}}, ParseDuration, DurationText};
}

ValueType<Time> TimeValue()
{
  return {{"time", "TIME", {}}, ParseTime, [](Time time) { return FormatIso8601(time); }};
}

ValueType<double> LengthValue()
{
  return {{"length", "LENGTH", {}}, ParseLength, LengthText};
}

ValueType<std::array<int, 3>> DimensionsValue()
{
  return {{"dimensions", "XxYxZ", {}}, ParseDimensions, DimensionsText};
}

ValueType<GeographicBounds> BoundsValue()
{
  return {{"bounds", "W,S,E,N", {}}, ParseBounds, BoundsText};
}

ValueType<std::tuple<double, double>> HeightRangeValue()
{
  return {{"heights", "LOWER,UPPER", {}}, ParseHeightRange,
    [](const std::tuple<double, double>& range)
    { return HeightRangeText(std::get<0>(range), std::get<1>(range)); }};
}

ValueType<Velocity> MotionValue()
{
  return {{"motion", "EAST,NORTH", {}}, ParseMotion, MotionText};
}

ValueType<std::vector<MomentName>> MomentsValue()
{
  const auto parse = [](const std::string& text)
  {
    std::vector<MomentName> moments = ParseMomentNames(text);
    if (moments.empty())
    {
      throw Error("'" + text + "' is no moment; write " + MomentNameList() +
                  ", or several of them as in REF,VEL");
    }
    return moments;
  };
  const auto write = [](const std::vector<MomentName>& moments)
  {
    std::string text;
    for (const MomentName moment : moments)
    {
      text += (text.empty() ? "" : ",") + std::string(ToString(moment));
    }
    return text;
  };
  return {{"moments", "NAME,...", {}}, parse, write};
}

ValueType<bool> FlagValue()
{
  const auto parse = [](const std::string& text)
  {
    const bool on = text == "on" || text == "1" || text == "true";
    if (!on && text != "off" && text != "0" && text != "false")
    {
      throw Error("'" + text + "' is neither on nor off");
    }
    return on;
  };
  return {{"flag", "", {}}, parse, [](bool on) { return on ? "on" : "off"; }};
}

ValueType<int> NumberValue(int least, int most, const std::string& refusal)
{
  return {{"number", "NUMBER", {}, least, most}, NumberParser(least, most, refusal),
    [](int number) { return std::to_string(number); }};
}

ValueType<double> RealValue(
  double least, double most, const std::string& unit, const std::string& refusal)
{
  return {{"real", unit, {}}, NumberParser(least, most, refusal), NumberText};
}

ValueType<std::array<int, 2>> PictureSizeValue()
{
  return {{"size", "WxH", {}}, ParsePictureSize, [](const std::array<int, 2>& size) {
            return std::to_string(size[0]) + "x" + std::to_string(size[1]);
          }};
}

std::string ListOfChoices(const std::vector<std::string>& names)
{
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    list += (i == 0 ? "" : i + 1 < names.size() ? ", " : " or ") + names[i];
  }
  return list;
}

std::string SettingRow::Option() const
{
  return (IsFlag() && usual == "on" ? "--no-" : "--") + key;
}

std::string SettingRow::TextOf(double number) const
{
  const auto index = static_cast<std::size_t>(number);
  if (value.kind == "choice" && number >= 0.0 && index < value.choices.size())
  {
    return value.choices[index];
  }
  if (IsFlag())
  {
    return number != 0.0 ? "on" : "off";
  }
  const char* unit = value.kind == "length" ? "m" : value.kind == "duration" ? "s" : "";
  return NumberText(number) + unit;
}

std::string SettingsJson(const std::vector<SettingRow>& rows)
{
  constexpr const char* uses[] = {"result", "machine", "picture", "program"};
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const SettingRow& row : rows)
  {
    json.push_back({{"key", row.key}, {"option", row.Option()}, {"kind", row.value.kind},
      {"choices", row.value.choices}, {"least", row.value.least}, {"most", row.value.most},
      {"default", row.Default()}, {"excludes", row.excludes},
      {"use", uses[static_cast<int>(row.use)]}, {"says", row.says}});
  }
  return json.dump(1);
}

} // namespace nexrad
