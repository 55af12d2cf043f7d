// SPDX-License-Identifier: BSD-3-Clause
// Which radars saw a place, and how old their data are: the arrays that the window shows as maps
// and as colours, and merges again for where the inputs are radar files.
#include "HandMadeVolume.h"
#include "Scene/Plan/PlanLayer.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/ChosenArrays.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "WindowPictureTest.h"
#include "nexrad/Codec/NxvFile.h"

#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>

#include <QComboBox>
#include <QStandardItemModel>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

namespace
{

// 172 km apart; each sees 100 km far, so that both see what is halfway.
const Site east = {"KEAX", Position{38.81, -94.264, 333.0}};
const Site west = {"KTWX", Position{38.997, -96.232, 427.0}};

class WindowCoverageTest : public WindowPictureTest
{
protected:
  vtkNexradVolumeScene* Scene() { return window->View()->Scene(); }

  void OpenFirst(const std::filesystem::path& path)
  {
    request.input.inputs = {path};
    this->OpenWindow({1100, 700});
    ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetVolume() != nullptr; }));
    this->WaitForPicture();
  }

  void OpenTwoRadars()
  {
    const Time start = *ParseIso8601("2006-03-12T18:01:10");
    const std::filesystem::path place = folder.Path() / "radars";
    std::filesystem::create_directory(place);
    WriteLevel2(place / "east", {ConstantVolume(east, start, 40.0)});
    WriteLevel2(place / "west", {ConstantVolume(west, start, 30.0)});
    request.input.grid.grid.dimensions = {64, 64, 16};
    request.input.grid.grid.range = 110e3;
    // Rays that hold one value are a fault of the receiver.
    request.input.grid.quality.level = QualityLevel::Off;
    this->OpenFirst(place);
  }

  void WaitForArray(const char* array)
  {
    EXPECT_TRUE(this->Wait([&] { return HasArray(this->Scene()->GetVolume(), array); }));
    this->WaitForPicture();
  }

  // The colour of the map at a place in degrees.
  QColor ColourAt(const QImage& picture, double latitude, double longitude)
  {
    double place[3] = {0.0, 0.0, 0.0};
    this->Scene()->SetLookAtGeographic(latitude, longitude, 0.0);
    EXPECT_TRUE(this->Scene()->GetLookAt(place));
    this->Scene()->LookAtDomain();
    double pixel[2] = {0.0, 0.0};
    EXPECT_TRUE(this->Scene()->FindPixel(place[0], place[1], pixel));
    return picture.pixelColor(
      static_cast<int>(pixel[0]), picture.height() - 1 - static_cast<int>(pixel[1]));
  }

  // Of 255, from the colour of so many radars of two.
  static double Off(const QColor& colour, std::size_t radars)
  {
    const scene::Colour wanted = scene::ScaleFor(2.0, "REF_radars", {}, {}).bins[radars - 1].colour;
    return 255.0 * std::max({std::abs(colour.redF() - wanted[0]),
                     std::abs(colour.greenF() - wanted[1]), std::abs(colour.blueF() - wanted[2])});
  }

  bool IsOn(const char* box, const char* entry)
  {
    auto* entries = qobject_cast<QStandardItemModel*>(this->Find<QComboBox>(box)->model());
    return entries->item(this->Find<QComboBox>(box)->findText(entry))->isEnabled();
  }

  QString TipOf(const char* box, const char* entry)
  {
    auto* list = this->Find<QComboBox>(box);
    return list->itemData(list->findText(entry), Qt::ToolTipRole).toString();
  }
};

constexpr double half = 0.51; // a colour is rounded to a byte

} // namespace

TEST_F(WindowCoverageTest, RadarFilesAreMergedAgainForAMapOfTheNumberOfRadars)
{
  this->OpenTwoRadars();
  EXPECT_FALSE(HasArray(this->Scene()->GetVolume(), "REF_radars")) << "only when asked for";
  EXPECT_FALSE(this->Find<QComboBox>("Map of")->isEnabled()) << "no map is shown";
  this->Choose("View", 2);
  this->WaitForPicture();
  this->Choose("Map of", 1);
  this->WaitForArray("REF_radars");
  EXPECT_EQ(this->Find<QComboBox>("Map of")->currentText(), "Number of radars");
  const QImage picture = this->TakePicture();
  EXPECT_AT_MOST(Off(this->ColourAt(picture, 38.9, -95.25), 2), half,
    "colour of a map where both radars saw, of 255", "a colour is rounded to a byte");
  EXPECT_AT_MOST(Off(this->ColourAt(picture, 38.6, -93.8), 1), half,
    "colour of a map where one radar saw, of 255", "a colour is rounded to a byte");
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowCoverage.png");
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "map of radars in the window and of the copied command, of 255", contextReason);
  this->Choose("View", -2);
  this->WaitForPicture();
  EXPECT_AT_MOST(MeanDifference(this->TakePicture(), this->DrawWithoutTheWindow()), contextBound,
    "volume with ages in the window and of the copied command, of 255", contextReason);
  EXPECT_TRUE(window->Problems().isEmpty());
}

TEST_F(WindowCoverageTest, TheAgeOfTheDataGivesColours)
{
  this->OpenTwoRadars();
  const QImage before = this->TakePicture();
  this->Choose("Colours of", 2);
  EXPECT_TRUE(this->Wait([&] { return this->Scene()->GetOption("colour-by") == "REF_age"; }));
  this->WaitForArray("REF_age");
  EXPECT_EQ(this->Find<QComboBox>("Colours of")->currentText(), "Age of the data");
  const QImage picture = this->TakePicture();
  EXPECT_AT_LEAST(MeanDifference(before, picture), 1.0, "picture that ages colour, of 255");
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "ages in the window and of the copied command, of 255", contextReason);
}

TEST_F(WindowCoverageTest, VolumesWithoutTheArraysSayWhatWouldMakeThem)
{
  this->OpenSteps(1);
  this->Choose("View", 2);
  for (const char* box : {"Colours of", "Map of"})
  {
    EXPECT_FALSE(this->IsOn(box, "Number of radars"));
    EXPECT_FALSE(this->IsOn(box, "Age of the data"));
    EXPECT_TRUE(this->TipOf(box, "Number of radars").contains("grid --ancillary"));
    this->Choose(box, 1);
    EXPECT_EQ(this->Find<QComboBox>(box)->currentText(), "Same moment");
  }
  EXPECT_TRUE(window->Problems().isEmpty());
}

// One radar saw the western half of the volume, two the eastern one.
TEST_F(WindowCoverageTest, VolumesWithTheArraysShowThemAtAHeight)
{
  GriddedVolume volume = MakeStorm(true);
  volume.method = "beam";
  volume.ancillary.age.assign(volume.values.size(), 60.0F);
  volume.ancillary.weight.assign(volume.values.size(), 1.0F);
  volume.ancillary.nearestSite.assign(volume.values.size(), 0);
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    volume.ancillary.radars.push_back(i % 48 < 24 ? 1 : 2);
  }
  WriteNxv(folder.Path() / "halves.nxv", volume);
  this->OpenFirst(folder.Path() / "halves.nxv");
  this->Choose("View", 6);
  EXPECT_EQ(this->Scene()->GetOption("map"), "3km");
  this->Choose("Map of", 1);
  this->WaitForPicture();
  EXPECT_TRUE(this->IsOn("Map of", "Age of the data"));
  const QImage picture = this->TakePicture();
  EXPECT_AT_MOST(Off(this->ColourAt(picture, 39.4, -91.2), 1), half,
    "colour of a map where one radar saw, of 255", "a colour is rounded to a byte");
  EXPECT_AT_MOST(Off(this->ColourAt(picture, 39.4, -89.3), 2), half,
    "colour of a map where both radars saw, of 255", "a colour is rounded to a byte");
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "map at a height in the window and of the copied command, of 255", contextReason);
  this->Enter("Map height", "7.5");
  EXPECT_EQ(this->Scene()->GetOption("map"), "7500m");
  this->Choose("View", -3);
  EXPECT_EQ(this->Scene()->GetOption("array"), "") << "an echo top is of reflectivity";
}
