// SPDX-License-Identifier: BSD-3-Clause
// What a newcomer meets: the window with nothing open, and settings that must not change, or lose
// what was chosen, behind the user's back.
#include "StormVolume.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "Viewer/WelcomePage.h"
#include "WindowTest.h"
#include "nexrad/Codec/NxvFile.h"

#include <vtkNexradVolumeScene.h>

#include <QAction>
#include <QComboBox>
#include <QCommandLinkButton>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

using Phase = BackgroundSeries::Phase;

namespace
{

class WindowWelcomeTest : public WindowTest
{
protected:
  void SetUp() override { QSettings().remove("recent"); }

  WelcomePage* Page() { return this->Find<WelcomePage>("welcome"); }

  bool WaitForVolume()
  {
    return this->Wait([&] { return window->View()->Scene()->GetVolume() != nullptr; });
  }

  void OpenAndWait(const std::filesystem::path& path)
  {
    window->Open({QString::fromStdString(path.string())});
    ASSERT_TRUE(this->Wait(
      [&]
      {
        const Phase phase = window->Player()->State().phase;
        return phase == Phase::Failed || (phase == Phase::Open && !window->Player()->IsWaiting());
      }));
    this->WaitForPicture();
  }

  std::filesystem::path WriteBad() const
  {
    std::ofstream(folder.Path() / "bad.nxv") << "no volume";
    return folder.Path() / "bad.nxv";
  }

  const QAction* ActionOf(const char* text)
  {
    for (const QAction* action : window->findChildren<QAction*>())
    {
      if (action->text() == text)
      {
        return action;
      }
    }
    ADD_FAILURE() << text;
    return nullptr;
  }

  void DragOnPicture(const QPoint& from, const QPoint& to)
  {
    SceneView* view = window->View();
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view, &move);
    QTest::mouseRelease(view, Qt::LeftButton, {}, to);
  }

  static void TurnWheel(QWidget* over)
  {
    const QPoint middle = over->rect().center();
    QWheelEvent wheel(middle, over->mapToGlobal(middle), {}, {0, -120}, Qt::NoButton,
      Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(over, &wheel);
  }
};

} // namespace

TEST_F(WindowWelcomeTest, WithNothingOpenItSaysWhatCanBeOpened)
{
  this->OpenWindow();
  EXPECT_TRUE(this->Page()->isVisible());
  EXPECT_EQ(this->Page()->size(), window->View()->size());
  for (const char* name : {"welcome files", "welcome folder", "welcome synthetic day"})
  {
    auto* button = this->Find<QCommandLinkButton>(name);
    EXPECT_TRUE(button->isVisible()) << name;
    EXPECT_FALSE(button->accessibleName().isEmpty()) << name;
    EXPECT_FALSE(button->accessibleDescription().isEmpty()) << name;
  }
  EXPECT_TRUE(
    this->Find<QCommandLinkButton>("welcome synthetic day")->description().contains("SYNTHETIC"));
  EXPECT_EQ(this->Find<QLabel>("doing")->text(), "Nothing is open");
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/WindowWelcome.png");
}

// What needs a volume says so, or does nothing.
TEST_F(WindowWelcomeTest, WithNothingOpenThereIsNothingToSet)
{
  this->OpenWindow();
  for (const char* name : {"Moment", "Colours of", "Preset"})
  {
    EXPECT_FALSE(this->Find<QComboBox>(name)->isEnabled()) << name;
    EXPECT_EQ(this->Find<QComboBox>(name)->currentText(), "Nothing open") << name;
  }
  for (const char* text :
    {"&Take a picture", "Save &picture as…", "Save &movie as…", "Draw a &section"})
  {
    EXPECT_FALSE(this->ActionOf(text)->isEnabled()) << text;
  }
  EXPECT_FALSE(this->Find<QDockWidget>("cut dock")->widget()->isEnabled());
  QTest::keyClick(window.get(), Qt::Key_X);
  EXPECT_FALSE(this->Find<QDockWidget>("section dock")->isVisible());
}

TEST_F(WindowWelcomeTest, IsLeftOnceSomethingIsShown)
{
  this->OpenWindow();
  this->OpenAndWait(WriteStormFiles(folder.Path(), 2));
  EXPECT_FALSE(this->Page()->isVisible());
  EXPECT_TRUE(this->Find<QComboBox>("Moment")->isEnabled());
  EXPECT_EQ(this->Find<QComboBox>("Moment")->currentText(), "REF");
  EXPECT_TRUE(this->ActionOf("&Take a picture")->isEnabled());
  EXPECT_TRUE(this->ActionOf("Draw a &section")->isEnabled());
}

TEST_F(WindowWelcomeTest, ItsButtonsOpenFilesByKeys)
{
  this->OpenWindow();
  WriteStormFiles(folder.Path(), 1);
  auto* files = this->Find<QCommandLinkButton>("welcome files");
  ASSERT_TRUE(this->Wait([&] { return QApplication::focusWidget() == files; }));
  QTest::keyClick(files, Qt::Key_Tab);
  EXPECT_EQ(QApplication::focusWidget(), this->Find<QCommandLinkButton>("welcome folder"));
  AnswerDialog(folder.Path() / "20060312T183000Z.nxv");
  QTest::keyClick(files, Qt::Key_Return);
  EXPECT_TRUE(this->WaitForVolume());
  EXPECT_FALSE(this->Page()->isVisible());
}

TEST_F(WindowWelcomeTest, ItsButtonAsksForAFolder)
{
  this->OpenWindow();
  bool asked = false;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &look,
    [&]
    {
      if (auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget()))
      {
        asked = dialog->windowTitle().contains("folder");
        dialog->close();
      }
    });
  look.start(100);
  QTest::mouseClick(this->Find<QCommandLinkButton>("welcome folder"), Qt::LeftButton);
  EXPECT_TRUE(asked);
}

TEST_F(WindowWelcomeTest, TheSyntheticDaySaysThatItIsSimulated)
{
  this->OpenWindow();
  QTest::mouseClick(this->Find<QCommandLinkButton>("welcome synthetic day"), Qt::LeftButton);
  EXPECT_TRUE(this->Page()->isVisible()) << "until its first volume is shown";
  EXPECT_FALSE(this->Find<QCommandLinkButton>("welcome files")->isVisible());
  EXPECT_TRUE(this->Find<QLabel>("welcome text")->text().contains("SYNTHETIC"));
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().fraction > 0.0; }));
  QTest::mouseClick(this->Find<QPushButton>("cancel"), Qt::LeftButton);
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().phase == Phase::Failed; }));
  EXPECT_TRUE(this->Find<QCommandLinkButton>("welcome files")->isVisible());
}

// A file that could not be opened is no file that was opened.
TEST_F(WindowWelcomeTest, OffersWhatWasOpenedBefore)
{
  this->OpenWindow();
  this->OpenAndWait(this->WriteBad());
  const std::filesystem::path storm = WriteStormFiles(folder.Path(), 1);
  this->OpenAndWait(storm);
  this->OpenWindow();
  const auto buttons = window->findChildren<QPushButton*>("welcome recent");
  ASSERT_EQ(buttons.size(), 1);
  EXPECT_EQ(buttons.front()->toolTip().toStdString(), storm.string());
  QTest::mouseClick(buttons.front(), Qt::LeftButton);
  EXPECT_TRUE(this->WaitForVolume());
}

TEST_F(WindowWelcomeTest, WhatCannotBeOpenedShowsNothingOfWhatWasOpen)
{
  this->OpenSteps(2);
  this->OpenAndWait(this->WriteBad());
  EXPECT_TRUE(this->Page()->isVisible());
  EXPECT_EQ(window->View()->Scene()->GetVolume(), nullptr);
  EXPECT_TRUE(this->Find<QLabel>("welcome text")->text().contains("bad.nxv"));
  EXPECT_EQ(window->windowTitle(), "nexrad3d");
  EXPECT_FALSE(this->Find<QComboBox>("Moment")->isEnabled());
  this->OpenAndWait(WriteStormFiles(folder.Path(), 2));
  EXPECT_FALSE(this->Page()->isVisible());
}

// The camera had been moved near a storm, and a section and a crop box were there.
TEST_F(WindowWelcomeTest, AnotherPlaceIsShownAsAWhole)
{
  this->OpenSteps(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  const double zoom = scene->GetZoom();
  GriddedVolume elsewhere = MakeStorm(true);
  elsewhere.grid.centreLongitude -= 5.0; // the faces stay, in metres
  const std::filesystem::path other = folder.Path() / "other.nxv";
  WriteNxv(other, elsewhere);
  GriddedVolume later = MakeStorm(true);
  later.time = *ParseIso8601("2006-03-12T19:30:00");
  const std::filesystem::path same = folder.Path() / "same.nxv";
  WriteNxv(same, later);
  const auto change = [&]
  {
    scene->SetZoom(4.0 * zoom);
    scene->SectionOn();
    scene->CroppingOn();
  };
  change();
  this->OpenAndWait(same);
  EXPECT_EQ(scene->GetZoom(), 4.0 * zoom) << "of another time of the same place";
  EXPECT_TRUE(scene->GetSection());
  this->OpenAndWait(other);
  EXPECT_EQ(scene->GetZoom(), zoom);
  EXPECT_FALSE(scene->GetSection());
  EXPECT_FALSE(scene->GetCropping());
}

TEST_F(WindowWelcomeTest, TheVolumeIsSeenAgainAsBeforeItsMap)
{
  this->OpenSteps(1);
  vtkNexradVolumeScene* scene = window->View()->Scene();
  const double azimuth = scene->GetAzimuth();
  const double tilt = scene->GetTilt();
  this->Choose("View", 2);
  EXPECT_EQ(scene->GetTilt(), 90.0);
  this->Choose("View", -2);
  EXPECT_EQ(scene->GetAzimuth(), azimuth);
  EXPECT_EQ(scene->GetTilt(), tilt);
  EXPECT_FALSE(scene->GetParallelProjection());
  EXPECT_EQ(this->Find<QComboBox>("Projection")->currentText(), "Perspective");
}

TEST_F(WindowWelcomeTest, TheWheelScrollsPastSettings)
{
  this->OpenSteps(1);
  auto* from = this->Find<QDoubleSpinBox>("From");
  auto* slices = this->Find<QComboBox>("Slices");
  QScrollBar* bar =
    qobject_cast<QScrollArea*>(this->Find<QDockWidget>("look")->widget())->verticalScrollBar();
  ASSERT_GT(bar->maximum(), 0);
  window->View()->setFocus();
  TurnWheel(from);
  TurnWheel(slices);
  EXPECT_EQ(from->value(), 250.0);
  EXPECT_EQ(slices->currentText(), "256");
  EXPECT_GT(bar->value(), 0);
  from->setFocus();
  TurnWheel(from);
  EXPECT_EQ(from->value(), 245.0) << "that was clicked";
}

// Hiding the panel of the section ends the drawing of its line: the next drag turns the camera.
TEST_F(WindowWelcomeTest, AHiddenSectionDrawsNoLine)
{
  this->OpenSteps(1);
  QTest::keyClick(window.get(), Qt::Key_X);
  EXPECT_EQ(this->Find<QLabel>("section reading")->text(), "Drag on the ground from A to B.");
  this->Find<QDockWidget>("section dock")->close();
  this->WaitForPicture();
  const double azimuth = window->View()->Scene()->GetAzimuth();
  const QPoint middle = window->View()->rect().center();
  this->DragOnPicture(middle, middle + QPoint(60, 0));
  EXPECT_FALSE(window->View()->Scene()->GetSection());
  EXPECT_NE(window->View()->Scene()->GetAzimuth(), azimuth);
}

TEST_F(WindowWelcomeTest, OneTimeDoesNotPlay)
{
  this->OpenSteps(1);
  EXPECT_FALSE(this->Find<QToolButton>("Play")->isEnabled());
  EXPECT_FALSE(this->Find<QToolButton>("Step on")->isEnabled());
}
