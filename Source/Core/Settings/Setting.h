// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Moment.h"
#include "nexrad/Settings/ValueTexts.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

/// Settings that are described once: options of the program, texts, comparison, and the options of
/// VTK classes, Python and ParaView are all made of a table of rows (MergeSettings.h,
/// DrawingSettings.h).
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

/// An option of the program as its text: "--preset" and "storm cores". A flag has no value.
struct OptionText
{
  std::string name;
  std::string value;
};

/// Where a setting acts.
enum class SettingUse
{
  Result,  ///< it changes what is made
  Machine, ///< it changes no result, but the time and memory that it takes
  Picture, ///< it changes pictures and the window, and is no option of pages
  Program  ///< likewise, and it is an option of the program alone
};

/// What is said of a setting.
struct SettingRow
{
  std::string key;           ///< "overlap-length"
  std::string says;          ///< a sentence: what it is
  std::string shown = {};    ///< default that help texts show; empty: `usual`
  std::string excludes = {}; ///< key of the setting in whose place it stands
  SettingUse use = SettingUse::Result;
  std::string group = {}; ///< heading in help texts
  ValueDescription value = {};
  std::string usual = {}; ///< text of the default

  bool IsFlag() const { return value.unit.empty(); }
  /// "--overlap-length"; of a flag that is on by default "--no-sharpening".
  std::string Option() const;
  /// The text of a number: of metres, of seconds, of 0 or 1 for a flag, or of the place of a name
  /// among those of a choice, from 0.
  std::string TextOf(double number) const;
  /// The default that help texts show.
  const std::string& Default() const { return shown.empty() ? usual : shown; }
};

/// A row, and how the setting is read and written in a struct.
template <typename Settings>
struct Setting : SettingRow
{
  /// Throws Error, saying what is wrong with the text.
  std::function<void(Settings&, const std::string&)> set;
  std::function<std::string(const Settings&)> text;
  /// Why it cannot be set beside the others; empty: it can.
  std::function<std::string(const Settings&)> refusal;
};

template <typename Settings>
using SettingTable = std::vector<Setting<Settings>>;

/// A row for what `set` reads of a text and `text` writes.
template <typename Settings>
Setting<Settings> MakeSetting(SettingRow row, ValueDescription value,
  std::function<void(Settings&, const std::string&)> set,
  std::function<std::string(const Settings&)> text,
  std::function<std::string(const Settings&)> refusal = {})
{
  Setting<Settings> setting{std::move(row), std::move(set), std::move(text), std::move(refusal)};
  setting.value = std::move(value);
  setting.usual = setting.text(Settings());
  if (!setting.refusal)
  {
    setting.refusal = [](const Settings&) { return std::string(); };
  }
  return setting;
}

/// A row for the value that `member` finds in a struct: it returns a reference to it.
template <typename Settings, typename Value, typename Member>
Setting<Settings> MakeSetting(SettingRow row, const ValueType<Value>& type, Member member,
  std::function<std::string(const Settings&)> refusal = {})
{
  return MakeSetting<Settings>(
    std::move(row), ValueDescription(type),
    [parse = type.parse, member](Settings& settings, const std::string& text)
    { member(settings) = parse(text); },
    [write = type.text, member](const Settings& settings) { return write(member(settings)); },
    std::move(refusal));
}

/// The setting of a key; nullptr when there is none.
template <typename Settings>
const Setting<Settings>* FindSetting(const SettingTable<Settings>& table, const std::string& key)
{
  const auto found = std::find_if(table.begin(), table.end(),
    [&key](const Setting<Settings>& setting) { return setting.key == key; });
  return found == table.end() ? nullptr : &*found;
}

/// Sets a value by its text. Throws Error, with the key of the setting, for a text that is wrong.
template <typename Settings>
void SetText(const Setting<Settings>& setting, const std::string& text, Settings& settings)
{
  try
  {
    setting.set(settings, text);
  }
  catch (const Error& error)
  {
    throw Error(setting.key + ": " + error.what());
  }
}

/// Sets what an option says; the text of a flag is empty.
template <typename Settings>
void SetOption(const Setting<Settings>& setting, const std::string& text, Settings& settings)
{
  const char* flag = setting.usual == "on" ? "off" : "on";
  setting.set(settings, setting.IsFlag() ? flag : text);
}

/// A text as it is written of the value that is read of it: "230km" for "230000m". A wrong text
/// stays as it is.
template <typename Settings>
std::string NormalText(const Setting<Settings>& setting, const std::string& text)
{
  try
  {
    Settings settings;
    setting.set(settings, text);
    return setting.text(settings);
  }
  catch (const Error&)
  {
    return text;
  }
}

/// The options of the program that give these settings, in the order of the table. What has the
/// value of `usual`, what another setting refuses and what changes no result is left out.
template <typename Settings>
std::vector<OptionText> ToTexts(
  const SettingTable<Settings>& table, const Settings& settings, const Settings& usual = {})
{
  std::vector<OptionText> texts;
  for (const Setting<Settings>& setting : table)
  {
    const std::string text = setting.text(settings);
    const bool isUsual = text == setting.text(usual) || (setting.IsFlag() && text == setting.usual);
    if (setting.use != SettingUse::Machine && !isUsual && setting.refusal(settings).empty())
    {
      texts.push_back({setting.Option(), setting.IsFlag() ? "" : text});
    }
  }
  return texts;
}

/// Whether all settings of the table are the same.
template <typename Settings>
bool AreSame(const SettingTable<Settings>& table, const Settings& a, const Settings& b)
{
  return std::all_of(table.begin(), table.end(),
    [&](const Setting<Settings>& setting) { return setting.text(a) == setting.text(b); });
}

/// The rows as a JSON array, an object for each: key, option, kind, choices, least,
/// most, default, excludes, use ("result", "machine", "picture", "program") and says.
std::string SettingsJson(const std::vector<SettingRow>& rows);

} // namespace nexrad
