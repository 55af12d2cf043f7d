// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Settings/ValueTypes.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Settings that are described once: options of the program, texts, comparison, and the options of
/// VTK classes, Python and ParaView are all made of a table of rows (MergeSettings.h,
/// DrawingSettings.h).
namespace nexrad
{

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

/// Sets what the options say. Throws Error, with the name of the option, for one that the table
/// does not have and for a text that is wrong.
template <typename Settings>
void FromTexts(
  const SettingTable<Settings>& table, const std::vector<OptionText>& texts, Settings& settings)
{
  for (const auto& [name, value] : texts)
  {
    const auto found = std::find_if(table.begin(), table.end(),
      [&name = name](const Setting<Settings>& setting) { return setting.Option() == name; });
    if (found == table.end())
    {
      throw Error(name + ": there is no such option");
    }
    try
    {
      SetOption(*found, value, settings);
    }
    catch (const Error& error)
    {
      throw Error(name + ": " + error.what());
    }
  }
}

/// Whether all settings of the table are the same.
template <typename Settings>
bool AreSame(const SettingTable<Settings>& table, const Settings& a, const Settings& b)
{
  return std::all_of(table.begin(), table.end(),
    [&](const Setting<Settings>& setting) { return setting.text(a) == setting.text(b); });
}

/// The rows as a JSON array, an object for each: key, option, kind, choices, least,
/// most, default, excludes, use ("result", "machine", "library", "picture", "program") and says.
std::string SettingsJson(const std::vector<SettingRow>& rows);

} // namespace nexrad
