// SPDX-License-Identifier: BSD-3-Clause
// The window with menus, time line and settings: what clicks, keys and drops do to it.
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "WindowTest.h"

#include <vtkNexradVolumeScene.h>

#include <QAbstractSpinBox>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QListWidget>
#include <QMimeData>
#include <QMouseEvent>
#include <QPushButton>
#include <QSlider>
#include <QSpinBox>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

using Phase = BackgroundSeries::Phase;

TEST_F(WindowTest, OpensWithTheFirstTimeAndItsSettings)
{
  this->OpenSteps(3);
  EXPECT_EQ(window->Player()->State().phase, Phase::Open);
  EXPECT_EQ(window->Player()->Step(), 0U);
  EXPECT_NE(window->View()->Scene()->GetVolume(), nullptr);
  EXPECT_EQ(this->Find<QSlider>("time")->maximum(), 2);
  EXPECT_EQ(this->Find<QComboBox>("Preset")->currentText(), "all echo");
  EXPECT_TRUE(window->Problems().isEmpty());
  window->grab().save(QString(NEXRAD_TEST_OUTPUT_DIR) + "/Window.png");
}

TEST_F(WindowTest, ButtonsAndKeysStepThroughTheTimes)
{
  this->OpenSteps(3);
  EXPECT_AT_LEAST(
    this->Changes([&] { this->Click("Step on"); }), 0.002, "pixels that a step changes, part");
  EXPECT_EQ(window->Player()->Step(), 1U);
  QTest::keyClick(window.get(), Qt::Key_Right);
  EXPECT_EQ(window->Player()->Step(), 2U);
  QTest::keyClick(window.get(), Qt::Key_Right);
  EXPECT_EQ(window->Player()->Step(), 0U) << "round";
  this->Click("Step back");
  EXPECT_EQ(window->Player()->Step(), 2U);
  this->Find<QSlider>("time")->setFocus();
  QTest::keyClick(this->Find<QSlider>("time"), Qt::Key_Home);
  EXPECT_EQ(window->Player()->Step(), 0U);
}

TEST_F(WindowTest, PlaysInItsIntervalAndStopsAtTheEndWithoutLooping)
{
  this->OpenSteps(4);
  this->Click("Loop");
  auto* interval = this->Find<QSpinBox>("interval");
  interval->setFocus();
  interval->selectAll();
  QTest::keyClicks(interval, "40\t");
  EXPECT_EQ(window->Player()->Interval(), 40);
  this->Click("Play");
  EXPECT_TRUE(window->Player()->IsPlaying());
  EXPECT_TRUE(this->Wait([&] { return !window->Player()->IsPlaying(); }));
  EXPECT_EQ(window->Player()->Step(), 3U);
  EXPECT_FALSE(this->Find<QToolButton>("Play")->isChecked());
}

TEST_F(WindowTest, PlaysOverAndOver)
{
  this->OpenSteps(3);
  window->Player()->SetInterval(16);
  QTest::keyClick(window.get(), Qt::Key_Space);
  int wraps = 0;
  std::size_t last = 0;
  EXPECT_TRUE(this->Wait(
    [&]
    {
      wraps += window->Player()->Step() < last ? 1 : 0;
      last = window->Player()->Step();
      return wraps >= 2 && window->Player()->StepsPerSecond() > 0.0;
    }));
  QTest::keyClick(window.get(), Qt::Key_Space);
  EXPECT_FALSE(window->Player()->IsPlaying());
}

TEST_F(WindowTest, SettingsChangeThePicture)
{
  this->OpenSteps(1);
  EXPECT_AT_LEAST(this->Changes([&] { this->Choose("Preset", 1); }), 0.01,
    "pixels that the preset of the cores changes, part");
  EXPECT_EQ(window->View()->Scene()->GetPreset(), "storm cores");
  this->Choose("Slices", 1);
  EXPECT_EQ(window->View()->Scene()->GetOption("slices"), "512");
  EXPECT_AT_LEAST(
    this->Changes([&] { this->Choose("Theme", 1); }), 0.5, "pixels that the theme changes, part");
  EXPECT_AT_LEAST(this->Changes([&] { this->Choose("Projection", 1); }), 0.02,
    "pixels that parallel projection changes, part");
  auto* stretch = this->Find<QDoubleSpinBox>("Stretch");
  EXPECT_AT_LEAST(this->Changes(
                    [&]
                    {
                      stretch->setFocus();
                      stretch->selectAll();
                      QTest::keyClicks(stretch, "2\t");
                    }),
    0.02, "pixels that the stretch changes, part");
  EXPECT_EQ(window->View()->Scene()->GetOption("exaggeration"), "2");
  auto* walls = this->Find<QCheckBox>("Height walls");
  EXPECT_AT_LEAST(this->Changes(
                    [&] {
                      QTest::mouseClick(walls, Qt::LeftButton, {}, {8, 8});
                    }),
    0.001, "pixels that the walls change, part");
}

TEST_F(WindowTest, ASeriesThatGrowsOnDiskIsFollowed)
{
  this->OpenSteps(2);
  auto* slider = this->Find<QSlider>("time");
  WriteStormFiles(folder.Path(), 3);
  EXPECT_TRUE(this->Wait([&] { return slider->maximum() == 2; }));
  EXPECT_EQ(window->Player()->Step(), 0U) << "the time that is shown stays";
  window->Player()->GoTo(2);
  WriteStormFiles(folder.Path(), 5);
  EXPECT_TRUE(this->Wait([&] { return slider->maximum() == 4; }));
  EXPECT_EQ(window->Player()->Step(), 4U) << "from the newest time to the newest";
  EXPECT_TRUE(this->Wait([&] { return !window->Player()->IsWaiting(); }));
  EXPECT_TRUE(window->Problems().isEmpty());
}

// Whose echo hides what is behind it: the depths that this needs have the picture's size.
TEST_F(WindowTest, TheVolumeStaysWhereTheWindowIsResized)
{
  this->OpenSteps(1);
  this->Choose("Preset", 1);
  this->WaitForPicture();
  window->resize(1000, 700);
  const QImage resized = this->WaitForPicture();
  const double presets = this->Changes([this] { this->Choose("Preset", 1); });
  EXPECT_AT_LEAST(presets, 0.006, "pixels that another preset changes, part");
  this->Choose("Preset", -1);
  EXPECT_AT_MOST(Difference(resized, this->WaitForPicture()), 0.001,
    "pixels that differ when the preset is chosen again, part");
}

TEST_F(WindowTest, AMapIsSeenFromAboveAndTheSettingsSayIt)
{
  this->OpenSteps(1);
  this->Choose("View", 1);
  EXPECT_EQ(window->View()->Scene()->GetTilt(), 90.0);
  EXPECT_EQ(this->Find<QComboBox>("Projection")->currentText(), "Parallel");
}

TEST_F(WindowTest, TheMouseTurnsAndZooms)
{
  this->OpenSteps(1);
  SceneView* view = window->View();
  const double azimuth = view->Scene()->GetAzimuth();
  const QPoint from(view->width() / 2, view->height() / 2);
  EXPECT_AT_LEAST(this->Changes(
                    [&]
                    {
                      QTest::mousePress(view, Qt::LeftButton, {}, from);
                      // QTest would move the pointer of the screen, which other windows share.
                      QMouseEvent move(QEvent::MouseMove, from + QPoint(60, 0), Qt::NoButton,
                        Qt::LeftButton, Qt::NoModifier);
                      QCoreApplication::sendEvent(view, &move);
                      QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(60, 0));
                    }),
    0.05, "pixels that turning changes, part");
  EXPECT_NE(view->Scene()->GetAzimuth(), azimuth);
  QTest::keyClick(window.get(), Qt::Key_R);
  EXPECT_EQ(view->Scene()->GetAzimuth(), azimuth);
}

TEST_F(WindowTest, TakesPicturesOfWhatItShows)
{
  this->OpenSteps(1);
  for (int i = 0; i < 2; ++i)
  {
    QTest::keyClick(window.get(), Qt::Key_S);
  }
  ASSERT_EQ(window->Pictures().size(), 2U);
  EXPECT_NE(window->Pictures()[0], window->Pictures()[1]);
  const QImage written(QString::fromStdString(window->Pictures()[0].string()));
  const QImage shown = this->WaitForPicture();
  ASSERT_EQ(written.size(), shown.size());
  EXPECT_AT_MOST(Difference(written, shown), 0.03,
    "pixels of a written picture that differ from the window, part"); // of lines
}

TEST_F(WindowTest, WhatIsDroppedIsOpened)
{
  this->OpenWindow();
  EXPECT_FALSE(window->Player()->HasSeries());
  QMimeData files;
  files.setUrls(
    {QUrl::fromLocalFile(QString::fromStdString(WriteStormFiles(folder.Path(), 2).string()))});
  QDragEnterEvent enter({10, 10}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({10, 10}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &drop);
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().times.size() == 2; }));
}

TEST_F(WindowTest, WhatCannotBeOpenedIsListed)
{
  const std::filesystem::path bad = folder.Path() / "bad.nxv";
  std::ofstream(bad) << "no volume";
  request.input.inputs = {bad};
  this->OpenWindow();
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().phase == Phase::Failed; }));
  auto* list = this->Find<QListWidget>("damage");
  ASSERT_EQ(list->count(), 1);
  EXPECT_TRUE(list->item(0)->text().contains("bad.nxv")) << list->item(0)->text().toStdString();
  EXPECT_TRUE(list->isVisible());
}

TEST_F(WindowTest, OpensSomethingElseWhileItPlays)
{
  this->OpenSteps(3);
  window->Player()->SetInterval(16);
  window->Player()->Play(true);
  const TemporaryFolder other;
  window->Open({QString::fromStdString(WriteStormFiles(other.Path(), 2).string())});
  EXPECT_FALSE(window->Player()->IsPlaying());
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().times.size() == 2; }));
  EXPECT_TRUE(this->Wait([&] { return !window->Player()->IsWaiting(); }));
}

TEST_F(WindowTest, ClosesWhileItReads)
{
  this->OpenWindow();
  window->OpenSyntheticDay();
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().fraction > 0.0; }));
  EXPECT_EQ(window->Player()->State().phase, Phase::Opening);
  window.reset();
}

TEST_F(WindowTest, CancelStopsTheOpening)
{
  this->OpenWindow();
  window->OpenSyntheticDay();
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().fraction > 0.0; }));
  QTest::mouseClick(this->Find<QPushButton>("cancel"), Qt::LeftButton);
  EXPECT_TRUE(this->Wait([&] { return window->Player()->State().phase == Phase::Failed; }));
}

TEST_F(WindowTest, HelpNamesAllKeys)
{
  this->OpenWindow();
  QTest::keyClick(window.get(), Qt::Key_F1);
  const QString text = this->Find<QTextBrowser>("help")->toPlainText();
  int keys = 0;
  for (const QAction* action : window->findChildren<QAction*>())
  {
    const QString shortcut = action->shortcut().toString(QKeySequence::NativeText);
    EXPECT_TRUE(text.contains(shortcut)) << shortcut.toStdString();
    keys += shortcut.isEmpty() ? 0 : 1;
  }
  EXPECT_GE(keys, 10);
  EXPECT_TRUE(text.contains("left button, drag"));
}

// Screen readers say these names.
TEST_F(WindowTest, WidgetsHaveNamesAndToolTips)
{
  this->OpenSteps(1);
  int inputs = 0;
  for (const QWidget* widget : window->findChildren<QWidget*>())
  {
    const bool isInput = qobject_cast<const QComboBox*>(widget) != nullptr ||
                         qobject_cast<const QSlider*>(widget) != nullptr ||
                         qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
    if (isInput)
    {
      ++inputs;
      const std::string name = widget->objectName().toStdString();
      EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
      EXPECT_FALSE(widget->toolTip().isEmpty()) << name;
    }
  }
  EXPECT_GE(inputs, 14);
}

TEST_F(WindowTest, FitsALaptopScreen)
{
  this->OpenSteps(1);
  EXPECT_LE(window->minimumSizeHint().width(), 1024);
  EXPECT_LE(window->minimumSizeHint().height(), 640);
}
