// SPDX-License-Identifier: BSD-3-Clause
// The command that the window copies, in cases in which it could be another picture than that of
// the window.
#include "HandMadeVolume.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/ChosenArrays.h"
#include "Viewer/Parts/Playback.h"
#include "Viewer/Parts/SceneView.h"
#include "WindowPictureTest.h"

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
  request.merging = {{"--dims", "32x32x16"}, {"--no-sharpening", ""}};
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
  ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetColorArray() == "VEL"; }));
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
