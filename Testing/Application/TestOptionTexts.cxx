// SPDX-License-Identifier: BSD-3-Clause
// Options that are written from a request, and read again.
#include "ErrorMessage.h"
#include "Options/DrawingOptions.h"

#include "Scene/DrawingSettings.h"
#include "TestData.h"
#include "nexrad/Geometry/Angles.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <ostream>
#include <random>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::application;
using namespace nexrad::testing;

namespace
{

std::vector<OptionText> ReadAndWrite(const std::vector<OptionText>& texts)
{
  scene::DrawingRequest request;
  ParseOptionTexts(texts, request);
  return OptionTextsOf(request);
}

std::string Joined(const std::vector<OptionText>& texts)
{
  std::string line;
  for (const OptionText& text : texts)
  {
    line += text.name + (text.value.empty() ? " " : "=" + text.value + " ");
  }
  return line;
}

// Each option of a picture with a value that is not its default, in the order of the help text.
std::vector<OptionText> AllOptions(const std::string& colours)
{
  return {{"--azimuth", "123.456"}, {"--tilt", "-20.1"}, {"--zoom", "2.5"},
    {"--look-at", "35.3,-97.25,4km"}, {"--parallel", ""}, {"--size", "900x600"},
    {"--mapper", "ray-cast"}, {"--classification", "sampled"}, {"--interpolation", "nearest"},
    {"--slices", "512"}, {"--texture-memory", "64MiB"}, {"--exaggeration", "2.5"},
    {"--frame", "domain"}, {"--preset", "storm cores"}, {"--iso-values", "20:0.3,40"},
    {"--colours", colours}, {"--opacities", colours}, {"--opacity-distance", "10km"},
    {"--theme", "dark"}, {"--colour-by", "VEL"}, {"--shadow", "0.7"}, {"--occlusion", "0.5"},
    {"--light", "-30,20"}, {"--rings", "50km"}, {"--no-walls", ""}, {"--names", ""},
    {"--crop", "-50km,20km,-40km,60km,0km,15km"}, {"--clip", "-20km,0km,90,5km,-30"},
    {"--section", "-20km,0km,30km,1500m"}, {"--box", "-50km,10km,-40500m,20km"},
    {"--follow-from", "2006-03-12T18:05:00.000Z"}};
}

const std::vector<OptionText> mapOptions = {{"--azimuth", "170"}, {"--tilt", "60"},
  {"--map", "2500m"}, {"--array", "REF_age"}, {"--perspective", ""}};

} // namespace

TEST(OptionTexts, CutsAreInDegreesOnGeographicAxes)
{
  const std::vector<OptionText> options = {{"--crop", "-98deg,-97.25deg,35deg,36deg,0km,15km"},
    {"--clip", "-97.5deg,35.5deg,90,5km,-30"}, {"--section", "-98deg,35deg,-97deg,35.5deg"}};
  EXPECT_EQ(Joined(ReadAndWrite(options)), Joined(options));
  scene::DrawingRequest request;
  ParseOptionTexts(options, request);
  EXPECT_EQ(request.scene.cut.unit, PlaceUnit::Degrees);
  // 30 degrees downward over 111 km a degree
  EXPECT_NEAR(request.scene.cut.plane->normal[2] * MetresPerDegree, -0.5, 1e-9);
}

TEST(OptionTexts, BoxesAreInTheUnitOfTheAxes)
{
  const std::vector<OptionText> options = {{"--box", "-98deg,-97.25deg,35deg,36deg"}};
  EXPECT_EQ(Joined(ReadAndWrite(options)), Joined(options));
  scene::DrawingRequest request;
  request.input.box = BoxRequest{{-98.0, -97.25, 35.0, 36.0}}; // as the mouse makes it
  request.input.grid.grid.axes = GridAxes::Geographic;
  EXPECT_EQ(Joined(OptionTextsOf(request)), Joined(options) + "--axes=geographic ");
  request.input.grid.grid.axes = GridAxes::Projected;
  EXPECT_EQ(Joined(OptionTextsOf(request)), "--box=-98m,-97.25m,35m,36m ");
}

// What the mouse makes may be next to nothing, or large; the options have no exponents.
TEST(OptionTexts, NumbersAreWrittenInFull)
{
  scene::DrawingRequest request;
  request.input.box = BoxRequest{{-3.6e-12, 1e-5, 0.1, 1'234'567'890'123.0}};
  scene::DrawingRequest read;
  ParseOptionTexts(OptionTextsOf(request), read);
  ASSERT_TRUE(read.input.box);
  EXPECT_EQ(read.input.box->faces, request.input.box->faces);
  EXPECT_EQ(read.input.boxUnit, PlaceUnit::Metres);
}

TEST(OptionTexts, DefaultsAreLeftOut)
{
  EXPECT_EQ(Joined(OptionTextsOf(scene::DrawingRequest())), "");
  EXPECT_EQ(Joined(ReadAndWrite({{"--slices", "0"}})), "");
  EXPECT_EQ(Joined(ReadAndWrite({{"--map", "composite"}})), "--map=composite ");
  EXPECT_EQ(Joined(ReadAndWrite({{"--map", "vil-density"}})), "--map=vil-density:18 ");
}

TEST(OptionTexts, ALookIsWrittenAsTheOptionsThatItSets)
{
  EXPECT_EQ(Joined(ReadAndWrite({{"--look", "classic"}})),
    "--slices=256 --exaggeration=8 --frame=domain --opacity-distance=5km --theme=dark --shadow=0 "
    "--occlusion=0 ");
}

TEST(OptionTexts, AllOptionsAreWrittenAsTheyWereRead)
{
  const TemporaryFolder folder;
  const std::string colours = folder.Path() / "my colours.csv";
  std::ofstream(colours) << "dbz,colour\n";
  const std::vector<OptionText> options = AllOptions(colours);
  EXPECT_EQ(Joined(ReadAndWrite(options)), Joined(options));
  EXPECT_EQ(Joined(ReadAndWrite(mapOptions)), Joined(mapOptions));
}

// Each row of the table that is neither a flag nor a choice has a text in AllOptions.
TEST(OptionTexts, WhatIsWrittenOfRandomOptionsIsReadAsTheSame)
{
  const TemporaryFolder folder;
  const std::string colours = folder.Path() / "colours.csv";
  std::ofstream(colours) << "dbz,colour\n";
  std::vector<OptionText> known = AllOptions(colours);
  known.insert(known.end(), mapOptions.begin() + 2, mapOptions.end());
  std::map<std::string, std::string> texts = {{"--look", "classic"}};
  for (const OptionText& text : known)
  {
    texts[text.name] = text.value;
  }
  std::mt19937 random(2006);
  for (int i = 0; i < 300; ++i)
  {
    scene::DrawingOptions options;
    for (const Setting<scene::DrawingOptions>& setting : scene::DrawingSettings())
    {
      if (!setting.IsFlag() && setting.value.kind != "choice")
      {
        ASSERT_EQ(texts.count(setting.Option()), 1U) << setting.key;
      }
      if (random() % 3 == 0 && (setting.key != "array" || options.scene.plan))
      {
        const auto text = texts.find(setting.Option());
        SetOption(setting, text != texts.end() ? text->second : setting.TextOf(1.0), options);
      }
    }
    scene::DrawingRequest request;
    static_cast<scene::DrawingOptions&>(request) = options;
    scene::DrawingRequest read;
    ParseOptionTexts(OptionTextsOf(request), read);
    EXPECT_TRUE(read.camera == options.camera) << Joined(OptionTextsOf(request));
    EXPECT_EQ(read.size, options.size);
    for (const Setting<scene::DrawingOptions>& setting : scene::DrawingSettings())
    {
      if (setting.refusal(options).empty())
      {
        EXPECT_EQ(setting.text(read), setting.text(options)) << setting.key;
      }
    }
  }
}

TEST(OptionTexts, OptionsOfMergingStayAsTheyWereGiven)
{
  const std::vector<OptionText> options = {{"--time", "2006-03-12T18:35:00.000Z"},
    {"--dims", "64x64x32"}, {"--bounds", "-98,34,-96,36"}, {"--no-sharpening", ""},
    {"--moment", "REF,VEL"}};
  EXPECT_EQ(Joined(ReadAndWrite(options)), Joined(options));
}

// The window shows another moment with the options that it was opened with.
TEST(OptionTexts, OptionsThatAreNotOfTheMomentsAreLeftOut)
{
  const std::vector<OptionText> given = {
    {"--dims", "64x64x32"}, {"--no-sharpening", ""}, {"--overlap", "maximum"}};
  scene::DrawingRequest request;
  ParseOptionTexts(given, request);
  request.input.momentNamed = true;
  const auto textOf = [&](MomentName moment)
  {
    request.input.grid.moments = {moment};
    return Joined(OptionTextsOf(request));
  };
  EXPECT_EQ(
    textOf(MomentName::REF), "--dims=64x64x32 --overlap=maximum --no-sharpening --moment=REF ");
  EXPECT_EQ(textOf(MomentName::ZDR), "--dims=64x64x32 --overlap=maximum --moment=ZDR ");
  EXPECT_EQ(textOf(MomentName::VEL), "--dims=64x64x32 --moment=VEL ");
}

TEST(OptionTexts, WrongOptionsAreNamed)
{
  const std::vector<std::pair<OptionText, std::string>> cases = {
    {{"--colour", "red"}, "--colour: there is no such option"},
    {{"input", "x"}, "input: there is no such option"},
    {{"--texture-memory", "8MiB"},
      "--texture-memory: '8MiB' is too little for a volume; write 16MiB or more"},
    {{"--slices", "-1"}, "--slices: '-1' is no number from 0 to 16384"},
    {{"--theme", "blue"}, "--theme: 'blue' is no theme"}, {{"--dims", "1"}, "--dims"},
    {{"--crop", "-98deg,20km,35deg,36deg,0,15km"}, "--crop: '20km': some places"},
    {{"--box", "-98deg,20km,35deg,36deg"}, "--box: '20km': some places"},
    {{"--box", "-98,-97,35,36"}, "--box: '-98' has no unit; write -98km, -98m or -98deg"},
    {{"--box", "-98deg,-97deg,35deg"}, "--box: '-98deg,-97deg,35deg' is no box; write its west"},
    {{"--box", "-97deg,-98deg,35deg,36deg"}, "is no box: -98deg is not above -97deg"},
    {{"--crop", "xdeg,-97deg,35deg,36deg,0,15km"}, "--crop: 'xdeg' is no place"}};
  for (const auto& [option, words] : cases)
  {
    const std::string error = MessageOf([&] { ReadAndWrite({option}); });
    EXPECT_NE(error.find(words), std::string::npos) << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
}

TEST(OptionTexts, TheCommandIsQuotedForAShell)
{
  EXPECT_EQ(QuoteForShell("/data/a-b_c.nxv"), "/data/a-b_c.nxv");
  EXPECT_EQ(QuoteForShell("storm cores"), "'storm cores'");
  EXPECT_EQ(QuoteForShell("it's $HOME"), "'it'\\''s $HOME'");
  EXPECT_EQ(QuoteForShell(""), "''");
  scene::DrawingRequest request;
  request.input.inputs = {"/my data/x.nxv"};
  request.scene.preset = "storm cores";
  request.scene.light.direction.azimuth = -20.0;
  EXPECT_EQ(RenderCommandOf(request, "a.png"),
    "nexrad3d render '/my data/x.nxv' -o a.png --preset 'storm cores' --light=-20,45");
}
