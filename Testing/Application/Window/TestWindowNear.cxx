// SPDX-License-Identifier: BSD-3-Clause
// The window where the mouse points: moving near, and the readout of what is there.
#include "Options/SessionFile.h"
#include "Scans/SyntheticScans.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "WindowTest.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkNexradEchoPicker.h>
#include <vtkNexradVolumeScene.h>
#include <vtkRenderer.h>

#include <QAction>
#include <QCheckBox>
#include <QDockWidget>
#include <QLabel>
#include <QMouseEvent>
#include <QRegularExpression>
#include <QStatusBar>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

namespace
{

class NearWindow : public WindowTest
{
protected:
  SceneView* View() { return window->View(); }
  vtkNexradVolumeScene* Scene() { return window->View()->Scene(); }

  // Sends what a mouse does at a place of the view. QTest would move the pointer of the screen,
  // which other windows share.
  void Mouse(QEvent::Type type, const QPoint& place, Qt::MouseButton button,
    Qt::KeyboardModifiers keys = Qt::NoModifier)
  {
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, place, moves ? Qt::NoButton : button,
      type == QEvent::MouseButtonRelease ? Qt::NoButton : button, keys);
    QCoreApplication::sendEvent(this->View(), &event);
  }

  void Drag(const QPoint& from, const QPoint& to, Qt::MouseButton button,
    Qt::KeyboardModifiers keys = Qt::NoModifier)
  {
    this->Mouse(QEvent::MouseButtonPress, from, button, keys);
    this->Mouse(QEvent::MouseMove, (from + to) / 2, button, keys);
    this->Mouse(QEvent::MouseMove, to, button, keys);
    this->Mouse(QEvent::MouseButtonRelease, to, button, keys);
    this->WaitForPicture();
  }

  void Wheel(const QPoint& place, int notches)
  {
    QWheelEvent event(place, this->View()->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(this->View(), &event);
    this->WaitForPicture();
  }

  // Where the storm is seen, in m east and north of the domain's centre, and its height.
  std::array<double, 3> PlaceAt(const QPoint& place)
  {
    vtkNew<vtkNexradEchoPicker> picker;
    picker->SetScene(this->Scene());
    const auto [x, y] = ScenePixel(*this->View(), place);
    EXPECT_NE(picker->Pick(x, y, 0.0, this->Scene()->GetRenderer()), vtkNexradEchoPicker::NOTHING);
    return {picker->GetPlace()[0], picker->GetPlace()[1], picker->GetPlace()[2]};
  }

  static double Distance(const std::array<double, 3>& a, const std::array<double, 3>& b)
  {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  }

  QPoint Middle() { return {this->View()->width() / 2, this->View()->height() / 2}; }

  // A place of the picture where the storm is seen.
  QPoint Storm() { return this->Middle() + QPoint(-70, 30); }
};

// On a storm of two times, seen as surfaces: what is seen at a place is one echo.
class NearStorm : public NearWindow
{
protected:
  void SetUp() override
  {
    request.scene.preset = "iso-values";
    this->OpenSteps(2);
    // Places are found to a pixel, so the bounds are those of one size of the picture.
    window->resize(window->width() + 524 - this->View()->width(),
      window->height() + 518 - this->View()->height());
    this->WaitForPicture();
  }
};

// On two volumes of a radar of the synthetic day.
class NearRadar : public NearWindow
{
protected:
  void SetUp() override
  {
    WriteSyntheticScans(
      folder.Path(), "KEAX", *ParseIso8601("2006-03-12T18:00:00Z"), std::chrono::minutes(12));
    request.input.inputs = {folder.Path()};
    request.input.grid.grid.dimensions = {128, 128, 64};
    this->OpenWindow();
    ASSERT_TRUE(this->Wait([this] { return this->Scene()->GetVolume() != nullptr; }));
    this->WaitForPicture();
  }

  vtkImageData* WaitForBox()
  {
    EXPECT_TRUE(this->Wait(
      [this] { return !window->Player()->IsWaiting() && this->Scene()->GetDetail() != nullptr; }));
    return this->Scene()->GetDetail();
  }

  // Where the box is, m east and north of the domain's centre.
  std::array<double, 2> MiddleOfBox()
  {
    const double* middle = this->WaitForBox()->GetCenter();
    return {middle[0], middle[1]};
  }

  QString Status() { return window->statusBar()->currentMessage(); }
  QAction* Action(const char* name) { return this->Find<QAction>(name); }

  void DragBox()
  {
    this->Drag(this->Middle() + QPoint(-40, 20), this->Middle() + QPoint(40, -20), Qt::LeftButton,
      Qt::ControlModifier);
  }
};

} // namespace

TEST_F(NearStorm, TheMiddleButtonAndShiftMoveTheScene)
{
  const QImage first = this->WaitForPicture();
  const auto storm = this->PlaceAt(this->Storm());
  const QPoint to = this->Storm() + QPoint(150, 40);
  this->Drag(this->Storm(), to, Qt::MiddleButton);
  EXPECT_AT_MOST(Distance(this->PlaceAt(to), storm), 690.0,
    "distance of the echo under the pointer from that which was dragged there, m");
  EXPECT_AT_LEAST(
    Difference(first, this->WaitForPicture()), 0.16, "pixels that moving the scene changes, part");
  this->Drag(to, this->Storm(), Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_AT_MOST(
    Difference(first, this->WaitForPicture()), 0.012, "pixels that differ when moved back, part");
}

TEST_F(NearStorm, TheWheelZoomsTowardsThePointer)
{
  const auto storm = this->PlaceAt(this->Storm());
  this->Wheel(this->Storm(), 8);
  EXPECT_NEAR(this->Scene()->GetZoom(), std::pow(1.1, 8), 1e-6);
  EXPECT_AT_MOST(Distance(this->PlaceAt(this->Storm()), storm), 1100.0,
    "distance of the echo under the pointer from that before zooming, m");
}

TEST_F(NearStorm, ADoubleClickCentresAndTurningKeepsTheCentre)
{
  const QImage first = this->WaitForPicture();
  const auto storm = this->PlaceAt(this->Storm());
  this->Mouse(QEvent::MouseButtonPress, this->Storm(), Qt::LeftButton);
  this->Mouse(QEvent::MouseButtonRelease, this->Storm(), Qt::LeftButton);
  this->Mouse(QEvent::MouseButtonDblClick, this->Storm(), Qt::LeftButton);
  this->Mouse(QEvent::MouseButtonRelease, this->Storm(), Qt::LeftButton);
  this->Wheel(this->Middle(), 8);
  std::array<double, 3> place{};
  EXPECT_AT_MOST(Distance(this->PlaceAt(this->Middle()), storm), 8000.0,
    "distance of the echo in the middle from that which was clicked twice, m");
  const double azimuth = this->Scene()->GetAzimuth();
  this->Drag(this->Middle(), this->Middle() + QPoint(60, 0), Qt::LeftButton);
  EXPECT_NE(this->Scene()->GetAzimuth(), azimuth);
  ASSERT_TRUE(this->Scene()->GetLookAt(place.data()));
  EXPECT_AT_MOST(Distance(place, storm), 240.0,
    "distance of the place that the camera turns about from the echo that was clicked, m");
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowNear.png");
  QTest::keyClick(window.get(), Qt::Key_R);
  EXPECT_FALSE(this->Scene()->GetLookAt(place.data()));
  EXPECT_AT_MOST(
    Difference(first, this->WaitForPicture()), 0.001, "pixels that differ after a reset, part");
}

TEST_F(NearStorm, TheReadoutSaysWhatIsUnderThePointer)
{
  auto* readout = this->Find<QLabel>("readout");
  this->Mouse(QEvent::MouseMove, this->Storm(), Qt::NoButton);
  const QString echo = readout->text();
  EXPECT_TRUE(echo.contains("dBZ (REF), 38.") && echo.contains(" km above sea level, KLSX "))
    << echo.toStdString();
  window->Player()->Move(1);
  this->WaitForPicture();
  EXPECT_NE(readout->text(), echo) << "the storm of the next time is elsewhere";
  this->Mouse(QEvent::MouseMove, this->Middle() + QPoint(130, 60), Qt::NoButton);
  EXPECT_TRUE(readout->text().contains("on the map")) << readout->text().toStdString();
  QEvent leaves(QEvent::Leave);
  QCoreApplication::sendEvent(this->View(), &leaves);
  EXPECT_EQ(readout->text(), "");
}

TEST_F(NearRadar, ADraggedBoxIsMergedAgainInFinerVoxels)
{
  const double coarse = this->Scene()->GetVolume()->GetSpacing()[0];
  EXPECT_AT_LEAST(this->Changes(
                    [&]
                    {
                      this->DragBox();
                      EXPECT_TRUE(
                        this->Wait([&] { return this->Scene()->GetDetail() != nullptr; }));
                    }),
    0.0045, "pixels that a box changes, part");
  vtkImageData* box = this->Scene()->GetDetail();
  ASSERT_NE(box, nullptr);
  EXPECT_LT(box->GetSpacing()[0], 0.5 * coarse);
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowBox.png");
  QTest::keyClick(this->View(), Qt::Key_Escape);
  EXPECT_EQ(this->Scene()->GetDetail(), nullptr);
  EXPECT_FALSE(window->Player()->HasBox());
}

TEST_F(NearRadar, AnotherSeriesHasNoBox)
{
  this->DragBox();
  ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetDetail() != nullptr; }));
  const TemporaryFolder other;
  window->Open({QString::fromStdString(WriteStormFiles(other.Path(), 1).string())});
  EXPECT_EQ(this->Scene()->GetDetail(), nullptr);
  EXPECT_FALSE(window->Player()->HasBox());
  EXPECT_TRUE(this->Wait([&] { return !window->Player()->IsWaiting(); }));
  EXPECT_TRUE(window->Problems().isEmpty());
}

TEST_F(NearRadar, TheBoxIsMergedAgainForEachTime)
{
  this->DragBox();
  ASSERT_TRUE(this->Wait([&] { return this->Scene()->GetDetail() != nullptr; }));
  ASSERT_GE(window->Player()->State().times.size(), 2U);
  const auto timeOf = [](vtkImageData* image)
  { return image->GetFieldData()->GetArray("TimeValue")->GetTuple1(0); };
  const double first = timeOf(this->Scene()->GetDetail());
  window->Player()->Move(1);
  ASSERT_TRUE(this->Wait(
    [&] { return !window->Player()->IsWaiting() && this->Scene()->GetDetail() != nullptr; }));
  EXPECT_NE(timeOf(this->Scene()->GetDetail()), first);
  EXPECT_EQ(timeOf(this->Scene()->GetDetail()), timeOf(this->Scene()->GetVolume()));
}

TEST_F(NearRadar, TheMenuMakesABoxAndTakesItAway)
{
  auto* make = this->Find<QToolButton>("Make a box");
  const QPoint from = this->Middle() + QPoint(-40, 20);
  const QPoint to = this->Middle() + QPoint(40, -20);
  this->Action("Make a box")->trigger();
  EXPECT_TRUE(make->isChecked());
  QTest::keyClick(this->View(), Qt::Key_Escape);
  EXPECT_FALSE(make->isChecked()) << "Escape leaves";
  this->Drag(from, to, Qt::LeftButton);
  EXPECT_FALSE(window->Player()->HasBox()) << "this turns the scene";

  QTest::keyClick(window.get(), Qt::Key_B);
  EXPECT_TRUE(make->isChecked());
  this->Mouse(QEvent::MouseButtonPress, from, Qt::LeftButton);
  this->Mouse(QEvent::MouseMove, to, Qt::LeftButton);
  EXPECT_TRUE(QRegularExpression("^Box [0-9.]+ × [0-9.]+ km$").match(this->Status()).hasMatch())
    << this->Status().toStdString();
  this->Mouse(QEvent::MouseButtonRelease, to, Qt::LeftButton);
  EXPECT_FALSE(make->isChecked());
  this->WaitForBox();
  const QString text = this->Find<QLabel>("The box")->text();
  EXPECT_TRUE(text.contains(" km\n") && text.contains(" voxels\n2006-03-12 18:"))
    << text.toStdString();
  this->Action("Remove the box")->trigger();
  EXPECT_EQ(this->Scene()->GetDetail(), nullptr);
  EXPECT_FALSE(window->Player()->HasBox());
  EXPECT_FALSE(this->Action("Remove the box")->isEnabled());
}

// Both take the next drag on the ground.
TEST_F(NearRadar, MakingABoxAndDrawingASectionSwitchEachOtherOff)
{
  auto* make = this->Find<QToolButton>("Make a box");
  auto* draw = this->Find<QToolButton>("Draw the line");
  const auto drag = [this]
  {
    this->WaitForPicture(); // the panel of the section makes the view smaller
    this->Drag(this->Middle() + QPoint(-40, 20), this->Middle() + QPoint(40, -20), Qt::LeftButton);
  };
  this->Action("Make a box")->trigger();
  EXPECT_TRUE(make->isChecked());
  QTest::keyClick(window.get(), Qt::Key_X);
  EXPECT_TRUE(draw->isChecked());
  EXPECT_FALSE(make->isChecked());
  drag();
  EXPECT_TRUE(this->Scene()->GetSection());
  EXPECT_FALSE(window->Player()->HasBox());
  this->Scene()->SectionOff();

  QTest::keyClick(window.get(), Qt::Key_X);
  EXPECT_TRUE(draw->isChecked());
  this->Action("Make a box")->trigger();
  EXPECT_TRUE(make->isChecked());
  EXPECT_FALSE(draw->isChecked());
  drag();
  EXPECT_FALSE(this->Scene()->GetSection());
  EXPECT_TRUE(window->Player()->HasBox());
}

TEST_F(NearRadar, TheBoxFollowsTheStormWhenItIsSwitchedOn)
{
  this->DragBox();
  const auto first = this->MiddleOfBox();
  window->Player()->Move(1);
  EXPECT_EQ(this->MiddleOfBox(), first) << "it stays on the ground";
  window->Player()->Move(-1);
  this->WaitForBox();
  auto* follows = this->Find<QCheckBox>("Follow the storm");
  follows->click();
  EXPECT_EQ(this->MiddleOfBox(), first);
  window->Player()->Move(1);
  const auto second = this->MiddleOfBox();
  // The storms of the synthetic day move 4 to 9 km in five minutes, towards the north-east.
  EXPECT_AT_LEAST(second[0] - first[0], 2200.0, "way of a following box to the east, m");
  EXPECT_AT_LEAST(second[1] - first[1], 1800.0, "way of a following box to the north, m");
  this->Find<QDockWidget>("box dock")->raise();
  this->WaitForPicture();
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowFollowingBox.png");
  window->Player()->Move(-1);
  EXPECT_EQ(this->MiddleOfBox(), first);
  window->Player()->Move(1);
  EXPECT_EQ(this->MiddleOfBox(), second);
  follows->click();
  EXPECT_EQ(this->MiddleOfBox(), second) << "it stays where it is";
  window->Player()->Move(-1);
  EXPECT_EQ(this->MiddleOfBox(), second);
}

TEST_F(NearRadar, ASessionKeepsTheBoxAndWhatItFollows)
{
  this->DragBox();
  this->WaitForBox();
  this->Find<QCheckBox>("Follow the storm")->click();
  window->Player()->Move(1);
  const auto middle = this->MiddleOfBox();
  const TemporaryFolder other;
  const auto path = other.Path() / "box.nxsession";
  application::WriteSession(path, window->Shown());
  QTest::keyClick(this->View(), Qt::Key_Escape);
  EXPECT_EQ(this->Scene()->GetDetail(), nullptr);
  window->Open({QString::fromStdString(path.string())});
  EXPECT_EQ(this->MiddleOfBox(), middle);
  EXPECT_TRUE(this->Find<QCheckBox>("Follow the storm")->isChecked());
  EXPECT_TRUE(window->Problems().isEmpty());
}

TEST_F(NearStorm, ABoxOfVolumeFilesIsRefusedInOneLine)
{
  this->Drag(this->Middle() + QPoint(-40, 60), this->Middle() + QPoint(40, 20), Qt::LeftButton,
    Qt::ControlModifier);
  EXPECT_TRUE(this->Wait([&] { return !window->Problems().isEmpty(); }));
  EXPECT_TRUE(window->Problems().join("").contains("from radar files alone"));
  EXPECT_FALSE(window->Player()->HasBox());
}

// A volume that is in its file in finer voxels than are shown: those are read where the picture
// rests, and a box of the user goes before them.
TEST_F(NearWindow, VoxelsAreAsFineAsThePixelsOnceThePictureRests)
{
  request.input.inputs = {WriteLargeStorm(folder.Path())};
  this->OpenWindow();
  ASSERT_TRUE(this->Wait([this] { return this->Scene()->GetVolume() != nullptr; }));
  const auto finest = [this]
  {
    vtkImageData* detail = this->Scene()->GetDetail();
    return detail != nullptr && detail->GetSpacing()[0] < 230.0;
  };
  EXPECT_GT(this->Scene()->GetVolume()->GetSpacing()[0], 450.0);
  this->Wheel(this->Middle(), 24);
  ASSERT_TRUE(this->Wait(finest));
  EXPECT_FALSE(window->Player()->HasBox());
  const double west = this->Scene()->GetDetail()->GetBounds()[0];
  this->Drag(this->Middle(), this->Middle() + QPoint(120, 0), Qt::MiddleButton);
  ASSERT_TRUE(this->Wait(
    [&] { return finest() && this->Scene()->GetDetail()->GetBounds()[0] < west - 1'000.0; }))
    << "what is seen now";
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowLarge.png");

  this->Drag(this->Middle() + QPoint(-40, 20), this->Middle() + QPoint(40, -20), Qt::LeftButton,
    Qt::ControlModifier);
  ASSERT_TRUE(window->Player()->HasBox());
  ASSERT_TRUE(this->Wait(
    [&]
    {
      return finest() && this->Scene()->GetDetail()->GetDimensions()[0] < 400 &&
             !window->Player()->Seen();
    }));
  QTest::keyClick(this->View(), Qt::Key_Escape);
  EXPECT_FALSE(window->Player()->HasBox());
  EXPECT_TRUE(this->Wait([&] { return window->Player()->Seen() && finest(); }));
}
