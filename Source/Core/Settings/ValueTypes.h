// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Moment.h"
#include "nexrad/Model/Time.h"
#include "nexrad/Settings/ValueTexts.h"
#include "nexrad/System/Error.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace nexrad
{

/// What is said of the values of a setting.
struct ValueDescription
{
  std::string kind;                 ///< "length", "duration", "time", "choice", "flag", …
  std::string unit;                 ///< placeholder in help texts, as "LENGTH"; empty for a flag
  std::vector<std::string> choices; ///< the names of a choice, in the order of its numbers
  int least = 0;                    ///< of a number
  int most = 0;                     ///< of a number
};

/// How a value is read of a text and written as one. `parse` throws Error, saying what is wrong
/// with the text and what would be right; parse(text(value)) is the value.
template <typename Value>
struct ValueType : ValueDescription
{
  std::function<Value(const std::string&)> parse;
  std::function<std::string(const Value&)> text;
};

ValueType<Duration> DurationValue();
ValueType<Time> TimeValue();
ValueType<double> LengthValue();
ValueType<std::array<int, 3>> DimensionsValue();
ValueType<GeographicBounds> BoundsValue();
ValueType<std::tuple<double, double>> HeightRangeValue();
ValueType<Velocity> MotionValue();
ValueType<std::vector<MomentName>> MomentsValue();
/// "on" and "off"; "1", "0", "true" and "false" are read as well.
ValueType<bool> FlagValue();
/// A whole number from `least` to `most`. `refusal` says after the text what is wrong and what
/// would be right; by default "is no number from 0 to 1".
ValueType<int> NumberValue(int least, int most, const std::string& refusal = "");
/// Likewise any number.
ValueType<double> RealValue(
  double least, double most, const std::string& unit, const std::string& refusal = "");
/// Width and height of a picture in pixels.
ValueType<std::array<int, 2>> PictureSizeValue();

/// The same type, of which only values that `isRight` takes are right; `refusal` says after the
/// text what is wrong and what would be right.
template <typename Value>
ValueType<Value> Where(
  ValueType<Value> type, std::function<bool(const Value&)> isRight, std::string refusal)
{
  type.parse = [parse = type.parse, isRight, refusal](const std::string& text)
  {
    const Value value = parse(text);
    if (!isRight(value))
    {
      throw Error("'" + text + "' " + refusal);
    }
    return value;
  };
  return type;
}

/// The same type, whose empty text is no value.
template <typename Value>
ValueType<std::optional<Value>> Optional(const ValueType<Value>& type)
{
  ValueType<std::optional<Value>> optional{{type}, {}, {}};
  optional.parse = [parse = type.parse](const std::string& text)
  { return text.empty() ? std::nullopt : std::optional<Value>(parse(text)); };
  optional.text = [write = type.text](const std::optional<Value>& value)
  { return value ? write(*value) : ""; };
  return optional;
}

/// The names as a sentence lists them: "mean, nearest or maximum".
std::string ListOfChoices(const std::vector<std::string>& names);

/// One of the values, by its name. `noun` is what a name is, as "method".
template <typename Value>
ValueType<Value> ChoiceValue(const std::string& noun,
  const std::vector<std::pair<std::string, Value>>& choices, const std::string& unit = "NAME")
{
  ValueType<Value> type{{"choice", unit, {}}, {}, {}};
  for (const auto& [name, value] : choices)
  {
    type.choices.push_back(name);
  }
  type.parse = [noun, choices, names = type.choices](const std::string& text)
  {
    for (const auto& [name, value] : choices)
    {
      if (text == name)
      {
        return value;
      }
    }
    throw Error("'" + text + "' is no " + noun + "; write " + ListOfChoices(names));
  };
  type.text = [choices](const Value& wanted)
  {
    for (const auto& [name, value] : choices)
    {
      if (wanted == value)
      {
        return name;
      }
    }
    return std::string();
  };
  return type;
}

} // namespace nexrad
