// SPDX-License-Identifier: BSD-3-Clause
// The table of the settings of the merge: what is written of settings is read as the same settings.
#include "ErrorMessage.h"
#include "nexrad/Merging/MergeSettings.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <random>

using namespace nexrad;
using nexrad::testing::MessageOf;

namespace
{

// Texts of settings that are no flags and no choices, none of them the default.
const std::map<std::string, std::vector<std::string>> someTexts = {
  {"step", {"90s", "1h", "0.001s", "5min"}},
  {"begin", {"2006-03-12T18:00", "1999-05-03T23:56:21.123"}},
  {"end", {"2017-08-26T03:00"}},
  {"max-gap", {"0", "45min", "12.345s"}},
  {"dims", {"1x2x3", "512x512x256"}},
  {"range", {"500m", "0.1m", "123.456789km", "230km"}},
  {"bounds", {"-97,36,-86,43", "-98.123456789,34,-97.5,34.25"}},
  {"height", {"-100m,12km", "1km,2km", "0,0.3m"}},
  {"moment", {"VEL", "REF,VEL,SW", "KDP,AZSHEAR"}},
  {"despeckle", {"1", "26"}},
  {"site", {"KLSX"}},
  {"memory", {"512MiB", "1000", "3GiB", "1KiB"}},
  {"storm-motion", {"12,-7.5", "0,0"}},
  {"bias", {"auto", "KLSX:2,KILX:-1.5", "KEAX:0.1"}},
  {"overlap-length", {"1km", "33333.3m"}},
  {"motion", {"none", "0,0", "-12.25,0.3"}},
};

std::vector<std::string> TextsOf(const Setting<MergeOptions>& setting)
{
  if (setting.IsFlag())
  {
    return {setting.usual == "on" ? "off" : "on"};
  }
  if (setting.value.kind == "choice")
  {
    std::vector<std::string> names = setting.value.choices;
    names.erase(std::find(names.begin(), names.end(), setting.usual));
    return names;
  }
  const auto texts = someTexts.find(setting.key);
  return texts == someTexts.end() ? std::vector<std::string>{setting.Default()} : texts->second;
}

void SetOptions(const std::vector<OptionText>& texts, MergeOptions& options)
{
  for (const auto& [name, value] : texts)
  {
    const auto setting = std::find_if(MergeSettings().begin(), MergeSettings().end(),
      [&name = name](const Setting<MergeOptions>& each) { return each.Option() == name; });
    ASSERT_NE(setting, MergeSettings().end()) << name;
    SetOption(*setting, value, options);
  }
}

MergeOptions RandomOptions(std::mt19937& random)
{
  MergeOptions options;
  for (const Setting<MergeOptions>& setting : MergeSettings())
  {
    const std::vector<std::string> texts = TextsOf(setting);
    if (random() % 3 == 0)
    {
      setting.set(options, texts[random() % texts.size()]);
    }
  }
  return options;
}

} // namespace

TEST(MergeSettings, WhatIsWrittenIsReadAsTheSame)
{
  std::mt19937 random(2006);
  for (int i = 0; i < 1000; ++i)
  {
    const MergeOptions options = RandomOptions(random);
    MergeOptions read;
    SetOptions(ToTexts(MergeSettings(), options), read);
    for (const Setting<MergeOptions>& setting : MergeSettings())
    {
      if (setting.use == SettingUse::Result && setting.refusal(options).empty())
      {
        EXPECT_EQ(setting.text(read), setting.text(options)) << setting.key;
        EXPECT_EQ(setting.refusal(read), "") << setting.key;
      }
    }
  }
}

TEST(MergeSettings, EachTextIsReadAsTheSameSettings)
{
  for (const Setting<MergeOptions>& setting : MergeSettings())
  {
    for (const std::string& text : TextsOf(setting))
    {
      MergeOptions options;
      setting.set(options, text);
      EXPECT_EQ(
        setting.text(options) == setting.usual, AreSame(MergeSettings(), options, MergeOptions()))
        << setting.key << ' ' << text;
      MergeOptions again;
      setting.set(again, setting.text(options));
      EXPECT_TRUE(AreSame(MergeSettings(), options, again)) << setting.key << ' ' << text;
    }
  }
}

TEST(MergeSettings, ValuesAreThoseOfTheTexts)
{
  MergeOptions options;
  SetOptions(
    {{"--height", "1,2km"}, {"--moment", "VEL,REF"}, {"--no-sharpening", ""}, {"--motion", "1,2"},
      {"--bias", "KLSX:2"}, {"--overlap", "mean"}, {"--max-gap", "2min"}},
    options);
  EXPECT_EQ(options.grid.bottom, 1000.0);
  EXPECT_EQ(options.grid.top, 2000.0);
  EXPECT_EQ(options.moments, (std::vector<MomentName>{MomentName::VEL, MomentName::REF}));
  EXPECT_FALSE(options.beam.sharpen);
  EXPECT_EQ(options.motion->north, 2.0);
  EXPECT_EQ(options.beam.biases, (RadarBiases{{"KLSX", 2.0}}));
  EXPECT_EQ(options.beam.strategy, OverlapStrategy::Mean);
  EXPECT_EQ(options.maximumGap, std::chrono::minutes(2));
}

TEST(MergeSettings, DefaultsAreLeftOut)
{
  EXPECT_TRUE(ToTexts(MergeSettings(), MergeOptions()).empty());
}

TEST(MergeSettings, WhatIsWrongIsNamed)
{
  const auto message = [](const char* key, const char* text)
  {
    return MessageOf(
      [&]
      {
        MergeOptions options;
        SetText(*FindSetting(MergeSettings(), key), text, options);
      });
  };
  EXPECT_EQ(FindSetting(MergeSettings(), "colour"), nullptr);
  EXPECT_EQ(message("overlap", "median"),
    "overlap: 'median' is no strategy; write mean, nearest, maximum or distance");
  EXPECT_EQ(message("despeckle", "27"), "despeckle: '27' is no number from 0 to 26");
  EXPECT_EQ(message("despeckle", ""), "despeckle: '' is no number from 0 to 26");
  EXPECT_EQ(message("site", "klsx"),
    "site: 'klsx' is no radar that is known here; write four capital letters, as in KLSX");
}

TEST(SettingsJson, SaysWhereASettingActs)
{
  const std::map<SettingUse, std::string> uses = {{SettingUse::Result, "result"},
    {SettingUse::Machine, "machine"}, {SettingUse::Picture, "picture"},
    {SettingUse::Program, "program"}};
  for (const auto& [use, name] : uses)
  {
    SettingRow row;
    row.key = "key";
    row.use = use;
    EXPECT_EQ(nlohmann::json::parse(SettingsJson({row})).at(0).at("use"), name);
  }
}
