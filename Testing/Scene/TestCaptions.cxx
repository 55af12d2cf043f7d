// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Captions/Captions.h"
#include "Scene/Captions/EchoShown.h"
#include "Scene/Plan/PlanLayer.h"
#include "Scene/VolumeAppearance.h"
#include "StormVolume.h"
#include "TestData.h"
#include "Tolerance.h"

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradTransferFunction.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkProp.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::scene;

namespace
{

using Words = std::vector<std::string>;

// The western half is scanned by the first radar alone, 90 s before the volume's time, and the next
// quarter by the second alone, 400 s from it; the rest by both, or not at all.
GriddedVolume MakeAgedStorm()
{
  GriddedVolume volume = nexrad::testing::MakeStorm(false);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    const std::size_t column = i % 48;
    const bool first = column < 24;
    const bool second = column >= 24 && column < 36;
    volume.ancillary.age.push_back(first ? 90.0F : second ? 400.0F : 3000.0F);
    volume.ancillary.radars.push_back(first || second ? 1 : 2);
    volume.ancillary.nearestSite.push_back(first ? 0 : 1);
    if (column == 47)
    {
      volume.states[i] = VoxelState::NotScanned;
    }
  }
  return volume;
}

CaptionTexts MakeTexts(bool synthetic)
{
  CaptionTexts texts;
  texts.title = "Reflectivity";
  texts.note = "Height above mean sea level, stretched 8 times";
  texts.information = ReadVolumeInformation(nexrad::testing::MakeStormVolume(synthetic));
  return texts;
}

} // namespace

// Bins of 10 s: the median is right to 5 s.
TEST(DataAge, IsOfVoxelsThatOneRadarScannedAlone)
{
  GriddedVolume volume = MakeAgedStorm();
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  const auto ages = AgesOfData(image, "REF", 2);
  ASSERT_EQ(ages.size(), 2U);
  EXPECT_WITHIN(ages[0].value_or(0.0), 90.0 / 60.0, 5.0 / 60.0 + 1e-9, "median age, min");
  EXPECT_WITHIN(ages[1].value_or(0.0), 400.0 / 60.0, 5.0 / 60.0 + 1e-9, "median age, min");
  // A radar that scanned nothing alone has none.
  volume.ancillary.radars.assign(volume.values.size(), 2);
  vtkNexradVolumeToImage(volume, image);
  const auto none = AgesOfData(image, "REF", 2);
  ASSERT_EQ(none.size(), 2U);
  EXPECT_FALSE(none[0] || none[1]);
}

// A file's codes have no array of states: their table says what was not scanned.
TEST(DataAge, IsTheSameOfCodes)
{
  const nexrad::testing::TemporaryFolder folder;
  const std::string path = folder.Path() / "a.nxv";
  WriteNxv(path, MakeAgedStorm());
  vtkNew<vtkImageData> values;
  vtkNexradReadVolumeFile(path, {}, false, values);
  vtkNew<vtkImageData> codes;
  vtkNexradReadVolumeFile(path, {}, true, codes);
  ASSERT_FALSE(codes->GetPointData()->HasArray("REF_state"));
  const auto ages = AgesOfData(codes, "REF", 2);
  ASSERT_EQ(ages.size(), 2U);
  EXPECT_EQ(ages, AgesOfData(values, "REF", 2));
}

TEST(DataAge, OfOneRadarNeedsTheAgeAlone)
{
  GriddedVolume volume = MakeAgedStorm();
  volume.ancillary.radars.clear();
  volume.ancillary.nearestSite.clear();
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  EXPECT_TRUE(AgesOfData(image, "REF", 2).empty()) << "whose age it is is unknown";
  const auto ages = AgesOfData(image, "REF", 1);
  ASSERT_EQ(ages.size(), 1U);
  EXPECT_WITHIN(ages[0].value_or(0.0), 90.0 / 60.0, 5.0 / 60.0 + 1e-9, "median age, min")
    << "24 of 47 columns";
  EXPECT_TRUE(AgesOfData(nexrad::testing::MakeStormVolume(false), "REF", 1).empty());
}

TEST(Captions, SayTimeRadarsAndAges)
{
  CaptionTexts texts = MakeTexts(false);
  EXPECT_EQ(TimeText(texts.information), "2006-03-12 18:30:00 UTC");
  EXPECT_EQ(TimeText({}), "time unknown");
  EXPECT_EQ(SiteWords(texts), (Words{"KLSX", "KILX"}));
  texts.ages = {0.3, 6.6};
  EXPECT_EQ(SiteWords(texts), (Words{"Age", "of", "the", "data:", "KLSX < 1 min,", "KILX 7 min"}));
  texts.ages = {std::nullopt, 1.0};
  EXPECT_EQ(SiteWords(texts).back(), "KILX 1 min");
  EXPECT_EQ(SiteWords(texts)[4], "KLSX,");
}

TEST(Captions, SayThatMostEchoIsBiological)
{
  GriddedVolume volume = nexrad::testing::MakeStorm(false);
  volume.biologicalShare = 0.877F;
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  CaptionTexts texts = MakeTexts(false);
  texts.information = ReadVolumeInformation(image);
  EXPECT_EQ(SiteWords(texts), (Words{"KLSX", "KILX;", "88", "%", "of", "the", "echo", "is",
                                "biological", "(birds,", "insects)"}));
  texts.information.biologicalShare = 0.49;
  EXPECT_EQ(SiteWords(texts), (Words{"KLSX", "KILX"}));
  texts.information.biologicalShare = 0.9;
  texts.information.sites.clear();
  EXPECT_TRUE(SiteWords(texts).empty());
}

namespace
{

// The storm with other values: those of its voxels that have echo, less something.
GriddedVolume WeakerStorm(float less)
{
  GriddedVolume volume = nexrad::testing::MakeStorm(false);
  for (float& value : volume.values)
  {
    value -= less;
  }
  return volume;
}

std::string SaidOf(const GriddedVolume& volume, const std::string& preset,
  const std::optional<std::array<double, 6>>& box = {}, double biological = 0.0)
{
  SceneOptions options;
  options.preset = preset;
  const auto look = MakeTransferFunction(options, ToString(volume.moment));
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  return WordsForNothing(image, box, look, biological, true);
}

} // namespace

TEST(Captions, SayWhatThereIsWhereNothingIsToBeSeen)
{
  EXPECT_EQ(SaidOf(WeakerStorm(0.0F), ""), "");
  EXPECT_EQ(SaidOf(WeakerStorm(0.0F), "hail"), "") << "of 62 dBZ";
  const std::string clear = SaidOf(WeakerStorm(59.0F), "");
  EXPECT_EQ(clear.substr(0, 22), "No echo above 5 dBZ; c") << clear;
  EXPECT_NE(clear.find("clear-air echo up to "), std::string::npos) << clear;
  EXPECT_NE(clear.find(": --preset \"clear air\""), std::string::npos) << clear;
  const std::string birds = SaidOf(WeakerStorm(59.0F), "", {}, 0.8);
  EXPECT_NE(birds.find("biological echo up to "), std::string::npos) << birds;
  const std::string weak = SaidOf(WeakerStorm(30.0F), "hail");
  EXPECT_EQ(weak.find("No echo above 45 dBZ; echo up to "), 0U) << weak;
  EXPECT_NE(weak.find("--preset \"all echo\""), std::string::npos) << weak;
  const std::string veil = SaidOf(WeakerStorm(55.5F), "");
  EXPECT_EQ(veil.find("Hardly any echo above 5 dBZ; echo up to "), 0U) << veil;
  EXPECT_NE(veil.find("--preset \"clear air\""), std::string::npos) << veil;
  GriddedVolume none = WeakerStorm(0.0F);
  none.states.assign(none.states.size(), VoxelState::NoEcho);
  EXPECT_EQ(SaidOf(none, ""), "No echo");
  none.states.front() = VoxelState::Filtered;
  EXPECT_EQ(SaidOf(none, ""), "No echo: quality control took out all that there was");
  none.states.assign(none.states.size(), VoxelState::NotScanned);
  EXPECT_EQ(SaidOf(none, ""), "Nothing was scanned here");
}

// The storm stands in the south west.
TEST(Captions, SayThatACropShowsNothing)
{
  const std::array<double, 6> northEast = {100e3, 230e3, 100e3, 230e3, 0.0, 20e3};
  EXPECT_EQ(SaidOf(WeakerStorm(0.0F), "", northEast), "No echo");
  EXPECT_EQ(SaidOf(WeakerStorm(0.0F), "", std::array{-240e3, 0.0, -240e3, 0.0, 0.0, 20e3}), "");
}

namespace
{

std::string SaidOfMap(const GriddedVolume& volume, PlanLevel level = PlanLevel::Composite,
  double height = 3'000.0, double threshold = 18.0)
{
  const PlanOptions plan = {level, height, "", threshold};
  const std::string array = ToString(volume.moment);
  const auto look = MakeTransferFunction(SceneOptions(), array);
  vtkNew<vtkImageData> image;
  vtkNexradVolumeToImage(volume, image);
  const PlanView view = MakePlanView(SourceOf(image), plan);
  const ColourScale scale = ScaleFor(view, plan, volume.sites, ScaleOf(array, look));
  return WordsForMap(view, plan, scale, image, static_cast<double>(volume.biologicalShare), true);
}

} // namespace

// The storm of 62 dBZ, and the same less 59 dB.
TEST(Captions, SayWhatThereIsWhereAMapShowsNothing)
{
  const GriddedVolume storm = WeakerStorm(0.0F);
  const GriddedVolume weak = WeakerStorm(59.0F);
  for (const PlanLevel level : {PlanLevel::Composite, PlanLevel::Lowest, PlanLevel::Height,
         PlanLevel::EchoTop, PlanLevel::Liquid, PlanLevel::LiquidDensity})
  {
    EXPECT_EQ(SaidOfMap(storm, level), "");
    EXPECT_NE(SaidOfMap(weak, level), "");
  }
  const std::string clear = SaidOfMap(weak);
  EXPECT_EQ(clear.find("No echo above 5 dBZ; clear-air echo up to "), 0U) << clear;
  EXPECT_NE(clear.find(": --preset \"clear air\""), std::string::npos) << clear;
  const std::string top = SaidOfMap(weak, PlanLevel::EchoTop);
  EXPECT_EQ(top.find("No echo top: no echo of 18 dBZ; clear-air echo up to "), 0U) << top;
  const std::string density = SaidOfMap(weak, PlanLevel::LiquidDensity);
  EXPECT_EQ(density.find("No VIL density: no echo of 18 dBZ; clear-air echo up to "), 0U)
    << density;
  EXPECT_EQ(SaidOfMap(weak, PlanLevel::Liquid),
    "No vertically integrated liquid above 0.5 kg/m²; values up to 0.033 kg/m²");
  EXPECT_EQ(SaidOfMap(WeakerStorm(45.0F), PlanLevel::LiquidDensity, 0.0, 0.0),
    "No VIL density above 0.25 g/m³; values up to 0.018 g/m³");
}

TEST(Captions, SayWhyAMapHasNoValue)
{
  GriddedVolume volume = WeakerStorm(0.0F);
  const std::string high = SaidOfMap(volume, PlanLevel::Height, 19'000.0);
  EXPECT_EQ(high.find("No echo at this height; echo up to "), 0U) << high;
  for (std::size_t voxel = 0; voxel < 48 * 48; ++voxel)
  {
    volume.states[voxel] = VoxelState::NoEcho;
  }
  const std::string low = SaidOfMap(volume, PlanLevel::Lowest);
  EXPECT_EQ(low.find("No echo in the lowest voxels; echo up to "), 0U) << low;
  volume.states.assign(volume.states.size(), VoxelState::NoEcho);
  EXPECT_EQ(SaidOfMap(volume), "No echo");
  EXPECT_EQ(SaidOfMap(volume, PlanLevel::LiquidDensity), "No echo");
  volume.states.front() = VoxelState::Filtered;
  EXPECT_EQ(
    SaidOfMap(volume, PlanLevel::Liquid), "No echo: quality control took out all that there was");
  volume.states.assign(volume.states.size(), VoxelState::NotScanned);
  EXPECT_EQ(SaidOfMap(volume), "Nothing was scanned here");
  EXPECT_EQ(SaidOfMap(volume, PlanLevel::EchoTop), "Nothing was scanned here");
}

// A hundred names would take half of the picture.
TEST(Captions, CountManyRadars)
{
  CaptionTexts texts;
  texts.information.sites.assign(17, "KLSX");
  EXPECT_EQ(SiteWords(texts), (std::vector<std::string>{"17", "radars"}));
  texts.ages.assign(17, std::nullopt);
  texts.ages[3] = 4.2;
  texts.ages[5] = 0.3;
  const std::vector<std::string> expected = {
    "17", "radars,", "age", "of", "the", "data:", "<", "1", "to", "4", "min"};
  EXPECT_EQ(SiteWords(texts), expected);
  texts.information.sites.pop_back();
  EXPECT_EQ(SiteWords(texts).front(), "Age") << "sixteen are named";
}

TEST(Captions, SayWhereAVolumeEnds)
{
  GriddedVolume volume = nexrad::testing::MakeStorm(false);
  volume.notes = {"KLSX: volume ends at 6.4°, cut off"};
  const nexrad::testing::TemporaryFolder folder;
  const std::string path = folder.Path() / "a.nxv";
  WriteNxv(path, volume);
  vtkNew<vtkImageData> image;
  vtkNexradReadVolumeFile(path, {}, false, image);
  CaptionTexts texts = MakeTexts(false);
  texts.information = ReadVolumeInformation(image);
  EXPECT_EQ(SiteWords(texts),
    (Words{"KLSX", "KILX;", "KLSX:", "volume", "ends", "at", "6.4°,", "cut", "off"}));
}

// A file tells it as well, with the other moments of its volume.
TEST(Captions, LearnOfFilesThatMostEchoIsBiological)
{
  const nexrad::testing::TemporaryFolder folder;
  const std::string path = folder.Path() / "a.nxv";
  GriddedVolume volume = nexrad::testing::MakeStorm(false);
  volume.biologicalShare = 0.877F;
  WriteNxv(path, volume);
  vtkNew<vtkImageData> image;
  vtkNexradReadVolumeFile(path, {}, false, image);
  EXPECT_WITHIN(
    ReadVolumeInformation(image).biologicalShare, 0.877, 1e-4, "biological share of a file");
  WriteNxv(path, nexrad::testing::MakeStorm(false));
  vtkNexradReadVolumeFile(path, {}, false, image);
  EXPECT_EQ(ReadVolumeInformation(image).biologicalShare, 0.0);
}

// Time and radars, the note, SYNTHETIC: in narrow pictures as well they are off each other and in
// the picture.
TEST(Captions, AreOffEachOtherInEveryPicture)
{
  const Theme& theme = ThemeOf(ThemeChoice::Light);
  CaptionTexts texts = MakeTexts(true);
  texts.information.sites.assign(20, "KLSX");
  texts.ages.assign(20, 12.0);
  for (const std::array<int, 2> size :
    {std::array<int, 2>{1280, 720}, {640, 360}, {300, 600}, {250, 200}})
  {
    TextPictures pictures;
    const int letters = std::max(9, std::min(size[1] / 45, size[0] / 50));
    const double right = size[0] - 4.0 * letters;
    const CaptionLayer layer = MakeCaptions(texts, size, right, letters, theme, pictures);
    ASSERT_EQ(layer.taken.size(), 4U);
    ASSERT_EQ(layer.props.size(), 4U);
    EXPECT_FALSE(layer.overScene);
    for (std::size_t i = 0; i < layer.taken.size(); ++i)
    {
      EXPECT_GE(layer.taken[i].left, 0.0) << size[0] << ' ' << i;
      EXPECT_LE(layer.taken[i].right, size[0]) << size[0] << ' ' << i;
      EXPECT_LE(layer.taken[i].top, size[1]) << size[0] << ' ' << i;
      for (std::size_t j = 0; size[0] > 250 && j < i; ++j)
      {
        EXPECT_EQ(layer.taken[i].Shared(layer.taken[j]), 0.0) << size[0] << ' ' << i << ' ' << j;
      }
    }
  }
}

// The words of an empty picture stand over the scene: it need not stay off them, but labels do.
TEST(Captions, TellWhereTheWordsOfAnEmptyPictureStand)
{
  const std::array<int, 2> size = {1280, 720};
  CaptionTexts texts = MakeTexts(false);
  texts.nothing = "No echo above 5 dBZ; clear-air echo up to 3 dBZ";
  TextPictures pictures;
  const CaptionLayer layer =
    MakeCaptions(texts, size, 1200.0, 16, ThemeOf(ThemeChoice::Light), pictures);
  EXPECT_EQ(layer.taken.size(), 3U);
  ASSERT_TRUE(layer.overScene);
  EXPECT_EQ(layer.overScene->top, 432.0);
  EXPECT_WITHIN(0.5 * (layer.overScene->left + layer.overScene->right), 600.0, 1.0,
    "middle of the words, pixels", "a pixel is the least that can be wrong");
  EXPECT_WITHIN(layer.overScene->top - layer.overScene->bottom, 2.0 * 1.25 * 24.0, 12.0,
    "height of two lines, pixels");
}
