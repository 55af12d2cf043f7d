// SPDX-License-Identifier: BSD-3-Clause
#include "Sheets/PictureSheet.h"
#include "Sheets/SweepLayers.h"
#include "Sheets/TimesSheet.h"

#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"

#include <vtkImageData.h>
#include <vtkStructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace nexrad;
using namespace nexrad::scene;

namespace
{

using Pixel = std::array<int, 3>;

vtkSmartPointer<vtkImageData> MakePicture(int width, int height, const Pixel& colour)
{
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(width, height, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (int channel = 0; channel < 3; ++channel)
      {
        picture->SetScalarComponentFromDouble(x, y, 0, channel, colour[channel]);
      }
    }
  }
  return picture;
}

void SetPixel(vtkImageData* picture, int x, int y, const Pixel& colour)
{
  for (int channel = 0; channel < 3; ++channel)
  {
    picture->SetScalarComponentFromDouble(x, y, 0, channel, colour[channel]);
  }
}

template <typename Test>
int CountPixels(vtkImageData* picture, const Test& test)
{
  int count = 0;
  const int* size = picture->GetDimensions();
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto* bytes = static_cast<unsigned char*>(picture->GetScalarPointer(x, y, 0));
      count += test(Pixel{bytes[0], bytes[1], bytes[2]}) ? 1 : 0;
    }
  }
  return count;
}

std::vector<Time> StepsFrom(const char* first, int count)
{
  std::vector<Time> times;
  for (int i = 0; i < count; ++i)
  {
    times.push_back(*ParseIso8601(first) + std::chrono::minutes(5 * i));
  }
  return times;
}

} // namespace

// Two of six pixels are covered: one is the same, one differs by 10, 20 and 30.
TEST(PictureDifference, IsTheMeanOverTheCoveredPixels)
{
  const auto without = MakePicture(3, 2, {5, 5, 5});
  const auto reference = MakePicture(3, 2, {5, 5, 5});
  SetPixel(reference, 0, 0, {100, 100, 100});
  SetPixel(reference, 2, 1, {5, 5, 50});
  const auto picture = MakePicture(3, 2, {5, 5, 5});
  SetPixel(picture, 0, 0, {110, 80, 130});
  SetPixel(picture, 2, 1, {5, 5, 50});
  SetPixel(picture, 1, 1, {200, 200, 200}); // covered by this picture alone
  const PictureDifference difference = CompareCovered(picture, reference, without);
  EXPECT_DOUBLE_EQ(difference.mean, 60.0 / 6.0);
  EXPECT_DOUBLE_EQ(difference.covered, 2.0 / 6.0);
  EXPECT_EQ(CompareCovered(reference, reference, without).mean, 0.0);
  EXPECT_EQ(CompareCovered(picture, without, without).mean, 0.0);
}

// The picture: a red, a green and a blue rectangle, two above and one below, under white letters.
TEST(PictureSheet, ShowsEachPictureWhole)
{
  const Pixel colours[] = {{200, 10, 10}, {10, 200, 10}, {10, 10, 200}};
  std::vector<SheetPanel> panels;
  for (const Pixel& colour : colours)
  {
    panels.push_back({MakePicture(120, 80, colour), "a label"});
  }
  const auto sheet = MakeSheet("A title", panels, 2);
  EXPECT_AT_LEAST(sheet->GetDimensions()[0], 240, "width of the sheet, pixels");
  EXPECT_AT_MOST(sheet->GetDimensions()[0], 300, "width of the sheet, pixels");
  EXPECT_AT_LEAST(sheet->GetDimensions()[1], 160, "height of the sheet, pixels");
  EXPECT_AT_MOST(sheet->GetDimensions()[1], 260, "height of the sheet, pixels");
  for (const Pixel& colour : colours)
  {
    const auto isIt = [&colour](const Pixel& pixel) { return pixel == colour; };
    EXPECT_EQ(CountPixels(sheet, isIt), 120 * 80);
  }
  const auto isLetter = [](const Pixel& pixel)
  { return *std::min_element(pixel.begin(), pixel.end()) > 140; };
  EXPECT_AT_LEAST(CountPixels(sheet, isLetter), 200, "pixels of letters");
  const auto* bytes =
    static_cast<unsigned char*>(sheet->GetScalarPointer(20, sheet->GetDimensions()[1] - 70, 0));
  EXPECT_EQ(bytes[0], 200); // the first stands above on the left
}

// The thesis's four times, where the series has them.
TEST(TimesSheet, ShowsTheThesissTimesOrSomeFromFirstToLast)
{
  const Duration step = std::chrono::minutes(5);
  const std::vector<std::size_t> ofDay =
    ChooseTimesOfDay(StepsFrom("2006-03-12T00:02", 288), step); // 00:02, 00:07, 00:12 …
  EXPECT_EQ(ofDay, (std::vector<std::size_t>{2, 74, 218, 278}));
  // 00:10 has no step, but the first is nearer than a step.
  EXPECT_EQ(ChooseTimesOfDay(StepsFrom("2006-03-12T00:15", 280), step),
    (std::vector<std::size_t>{0, 71, 215, 275}));
  EXPECT_EQ(ChooseTimesOfDay(StepsFrom("2005-08-21T02:45", 6), step),
    (std::vector<std::size_t>{0, 1, 3, 5}));
  EXPECT_EQ(
    ChooseTimesOfDay(StepsFrom("2005-08-21T02:45", 2), step), (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(
    ChooseTimesOfDay(StepsFrom("2005-08-21T02:45", 1), step), (std::vector<std::size_t>{0}));
}

// Volume coverage pattern 21 has nine elevations; the two lowest are scanned twice, the second
// time for velocity. Echo is counted anew from the words of the file.
TEST(SweepLayers, AreTheElevationsOfThePatternWithTheirEcho)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto file = data / "level2" / "run-kbgm-20050821" / "KBGM20050821_030047.gz";
  const RadarVolume volume = ReadLevel2(file);
  SeriesVolume entry;
  entry.file = file;
  entry.start = volume.sweeps.front().rays.front().time;
  entry.end = volume.sweeps.back().rays.back().time;
  SweepReach reach;
  reach.centre = {42.2, -75.98};
  const std::vector<SweepLayer> layers = ReadSweepLayers(entry, reach);
  const double elevations[] = {0.5, 1.45, 2.4, 3.35, 4.3, 6.0, 9.9, 14.6, 19.5};
  ASSERT_EQ(layers.size(), 9U);
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    EXPECT_WITHIN(layers[i].elevation, elevations[i], 0.2,
      "elevation of a layer against the pattern's, degrees");
    const double* bounds = layers[i].grid->GetBounds();
    EXPECT_LT(bounds[1], 230'500.0);
    EXPECT_LT(bounds[5], 20'500.0);
  }
  EXPECT_EQ(layers[0].gates, 231U); // 0 to 230 km, one a kilometre
  std::size_t echoes = 0;
  const Sweep& lowest = volume.sweeps.front();
  EXPECT_EQ(layers[0].rays, lowest.rays.size());
  for (const Ray& ray : lowest.rays)
  {
    const MomentRow& row = ray.Row(MomentName::REF);
    for (int gate = 0; gate < row.gates; ++gate)
    {
      const int range = row.firstGate + gate * row.gateSpacing;
      const unsigned raw = row.Raw(static_cast<std::size_t>(gate));
      const bool echo = raw >= 2 && (raw - 2) * 0.5 - 32.0 >= 5.0; // ICD 2620002, message 1
      echoes += range >= 0 && range <= 230'000 && echo ? 1 : 0;
    }
  }
  EXPECT_EQ(layers[0].echoes, echoes);
  entry.end = entry.start - std::chrono::seconds(1); // another volume than the one in the file
  entry.start -= std::chrono::minutes(5);
  EXPECT_TRUE(ReadSweepLayers(entry, reach).empty());
}
