// SPDX-License-Identifier: BSD-3-Clause
// The command that the window copies, in cases in which it could be another picture than that of
// the window.
#include "HandMadeVolume.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/ChosenArrays.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "WindowPictureTest.h"
#include "nexrad/Codec/NxvFile.h"

#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>

#include <QCheckBox>
#include <QDockWidget>
#include <QSpinBox>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <string>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

namespace
{

class WindowCommandTest : public WindowPictureTest
{
protected:
  vtkNexradVolumeScene* Scene() { return window->View()->Scene(); }

  // In a window that is large enough for all of them.
  void OpenCuts()
  {
    window->resize(1200, 900);
    this->Find<QDockWidget>("cut dock")->raise();
    this->WaitForPicture();
  }
};

} // namespace

// The handles are on the screen, and on no picture.
TEST_F(WindowCommandTest, PicturesHaveNoHandles)
{
  this->OpenSteps(1);
  this->OpenCuts();
  this->Tick("Crop");
  this->WaitForPicture();
  this->Tick("Clip");
  this->WaitForPicture();
  EXPECT_TRUE(this->Find<QCheckBox>("Handles")->isChecked());
  const QImage screen = this->WaitForPicture();
  const QImage picture = this->TakePicture();
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "cut volume in the window and of the copied command, of 255", contextReason);
  EXPECT_EQ(Difference(screen, this->WaitForPicture()), 0.0) << "the screen has them again";
  this->Tick("Handles");
  this->WaitForPicture();
  EXPECT_AT_LEAST(
    Difference(screen, this->WaitForPicture()), 0.01, "pixels of the handles on the screen, part");
  EXPECT_EQ(MeanDifference(picture, this->TakePicture()), 0.0);
}

// Another moment than that for which the options of merging were given.
TEST_F(WindowCommandTest, TheCommandOfAnotherMomentIsNotRefused)
{
  HandMadeVolume volume = ConstantVolume(
    {"KEAX", Position{38.81, -94.264, 333.0}}, *ParseIso8601("2006-03-12T18:01:10"), 40.0);
  HandMadeMoment velocity = volume.sweeps.front().moments.front();
  velocity.name = MomentName::VEL;
  velocity.word = [](int ray, int) { return ReflectivityWord(ray % 40 - 20.0); };
  volume.sweeps.front().moments.push_back(velocity);
  request.input.inputs = {WriteLevel2(folder.Path() / "one", {volume})};
  request.input.grid.grid.dimensions = {32, 32, 16};
  request.input.grid.beam.sharpen = false;
  // Rays that hold one value are a fault of the receiver.
  request.input.grid.quality.level = QualityLevel::Off;
  this->OpenWindow();
  ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetVolume() != nullptr; }));
  this->WaitForPicture();
  EXPECT_NE(this->CopyCommand().find("--no-sharpening"), std::string::npos);
  this->Choose("Moment", 1);
  EXPECT_TRUE(this->Wait([&] { return HasArray(this->Scene()->GetVolume(), "VEL"); }));
  this->WaitForPicture();
  EXPECT_AT_MOST(MeanDifference(this->TakePicture(), this->DrawWithoutTheWindow()), contextBound,
    "another moment in the window and of the copied command, of 255", contextReason);
}

// The opacities of reflectivity, and the colours of velocity.
TEST_F(WindowCommandTest, EditedOpacitiesStayWithTheColoursOfAnotherArray)
{
  request.input.inputs = {WriteTwoMoments(folder.Path())};
  this->OpenWindow();
  ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetVolume() != nullptr; }));
  this->WaitForPicture();
  this->Choose("Colours of", 1);
  ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetOption("colour-by") == "VEL"; }));
  this->WaitForPicture();
  const QImage before = this->TakePicture();
  QTest::keyClick(window.get(), Qt::Key_T);
  this->WaitForPicture();
  this->Find<QSpinBox>("Point")->setValue(4);
  this->Enter("Level of the point", "0.9");
  QTest::keyClick(window.get(), Qt::Key_T);
  this->WaitForPicture();
  const QImage picture = this->TakePicture();
  EXPECT_AT_LEAST(MeanDifference(before, picture), 0.5, "picture that an opacity changes, of 255");
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "edited opacities with colours of velocity and of the copied command, of 255", contextReason);
  this->Reopen();
  EXPECT_EQ(MeanDifference(picture, this->TakePicture()), 0.0);
}

// A volume on axes of longitude and latitude, as the thesis has them.
TEST_F(WindowCommandTest, CutsOfAVolumeInDegreesAreInDegrees)
{
  GriddedVolume volume = MakeStorm(true);
  volume.grid.axes = GridAxes::Geographic;
  volume.grid.spacing = {0.1, 0.09, 1'250.0};
  volume.grid.origin = {-92.35, 36.885, 625.0};
  WriteNxv(folder.Path() / "degrees.nxv", volume);
  request.input.inputs = {folder.Path() / "degrees.nxv"};
  this->OpenWindow();
  ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetVolume() != nullptr; }));
  const QImage whole = this->TakePicture();
  this->OpenCuts();
  this->Tick("Crop");
  this->WaitForPicture();
  this->Enter(
    "East face of the crop box, km east or north of the centre, or degrees on geographic axes",
    "-90.625");
  EXPECT_EQ(this->Scene()->GetCropBounds()[1], -90.625);
  this->Tick("Clip");
  this->WaitForPicture();
  this->Enter("A point of the clip plane: km north of the centre", "38.3");
  this->Enter("Elevation of that direction in degrees, for heights that are not stretched; 0: the "
              "plane is vertical",
    "3");
  QTest::keyClick(window.get(), Qt::Key_X);
  this->WaitForPicture();
  this->Enter("How far east the end A is", "-91.5");
  this->Enter("How far north the end A is", "38.4");
  this->Enter("How far east the end B is", "-90.2");
  this->Enter("How far north the end B is", "38.5");
  this->WaitForPicture();
  const QImage picture = this->TakePicture();
  EXPECT_NE(this->CopyCommand().find("-90.625deg"), std::string::npos);
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "cuts in degrees in the window and of the copied command, of 255", contextReason);
  this->Reopen();
  EXPECT_EQ(MeanDifference(picture, this->TakePicture()), 0.0);
}

// The cuts of a volume in degrees are none of a volume in metres.
TEST_F(WindowCommandTest, CutsInAnotherUnitAreLeftOut)
{
  request.scene.cut.unit = PlaceUnit::Degrees;
  request.scene.cut.box = {-91.0, -90.0, 38.0, 39.0, 0.0, 15'000.0};
  this->OpenSteps(1);
  EXPECT_FALSE(this->Scene()->GetCropping());
  ASSERT_EQ(window->Problems().size(), 1);
  EXPECT_TRUE(window->Problems().front().contains("in degrees, and the volume is in metres"));
}
