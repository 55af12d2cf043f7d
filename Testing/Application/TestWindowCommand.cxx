// SPDX-License-Identifier: BSD-3-Clause
// The command that the window copies, in cases in which it could be another picture than that of
// the window.
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/Parts/Playback.h"
#include "Viewer/Parts/SceneView.h"
#include "WindowPictureTest.h"

#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>

#include <QCheckBox>
#include <QDockWidget>
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
