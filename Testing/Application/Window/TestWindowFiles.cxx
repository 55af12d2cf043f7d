// SPDX-License-Identifier: BSD-3-Clause
// What is taken out of the window: the command that draws its picture, sessions, volumes and
// movies. The window and the command draw with different OpenGL contexts, which round a few pixels
// of lines differently.
#include "HandMadeVolume.h"
#include "Scans/SyntheticScans.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "WindowPictureTest.h"
#include "nexrad/Codec/NxvFile.h"

#include <vtkNexradTransferFunction.h>
#include <vtkNexradVolumeScene.h>

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QProgressDialog>
#include <QPushButton>
#include <QTimer>
#include <QWheelEvent>
#include <QtTest/QtTest>

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

using namespace nexrad;
using namespace nexrad::viewer;
using namespace nexrad::testing;

namespace
{

class WindowFilesTest : public WindowPictureTest
{
protected:
  // Presses keys that open a dialog of files, and answers it.
  void SaveAs(Qt::Key key, const std::filesystem::path& path)
  {
    AnswerDialog(path);
    QTest::keyClick(window.get(), key, Qt::ControlModifier);
    QApplication::setActiveWindow(window.get()); // there is no window manager
  }

  bool WaitForMovie()
  {
    const bool ended =
      this->Wait([&] { return window->findChild<QProgressDialog*>("movie") == nullptr; });
    QApplication::setActiveWindow(window.get());
    return ended;
  }

  void ChangeSettings()
  {
    this->Choose("Preset", 1);
    this->Choose("Slices", 1);
    this->Choose("Theme", 1);
    this->Enter("Stretch", "5.5");
    this->Enter("Shadow", "0.65");
    this->Enter("From", "200");
    this->Enter("Rings", "50");
    this->Tick("Interpolated");
    this->Tick("Height walls");
    this->Tick("Names");
    this->Turn();
  }

  void Turn()
  {
    SceneView* view = window->View();
    const QPoint from(view->width() / 2, view->height() / 2);
    QTest::mousePress(view, Qt::LeftButton, {}, from);
    QMouseEvent move(
      QEvent::MouseMove, from + QPoint(61, 17), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(view, &move);
    QTest::mouseRelease(view, Qt::LeftButton, {}, from + QPoint(61, 17));
    QWheelEvent wheel(from, view->mapToGlobal(from), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
      Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(view, &wheel);
  }
};

} // namespace

TEST_F(WindowFilesTest, TheCopiedCommandDrawsThePictureOfTheWindow)
{
  this->OpenSteps(2);
  this->Click("Step on");
  this->WaitForPicture();
  EXPECT_AT_MOST(MeanDifference(this->TakePicture(), this->DrawWithoutTheWindow()), contextBound,
    "picture of the window and of the copied command, mean difference of 255", contextReason);
}

TEST_F(WindowFilesTest, TheCopiedCommandHasAllSettings)
{
  this->OpenSteps(1);
  const QImage before = this->TakePicture();
  this->ChangeSettings();
  this->WaitForPicture();
  const QImage picture = this->TakePicture();
  EXPECT_AT_LEAST(MeanDifference(before, picture), 110.0, "picture that settings change, of 255");
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "picture of the window with other settings and of the copied command, of 255", contextReason);
}

TEST_F(WindowFilesTest, TheCopiedCommandHasMaps)
{
  this->OpenSteps(1);
  this->Choose("View", 2);
  this->Choose("Projection", -1);
  this->WaitForPicture();
  EXPECT_AT_MOST(MeanDifference(this->TakePicture(), this->DrawWithoutTheWindow()), contextBound,
    "map of the window and of the copied command, mean difference of 255", contextReason);
}

// Iso-values and colours that were edited are neither of a preset nor of a file.
TEST_F(WindowFilesTest, TheCopiedCommandHasEditedColours)
{
  this->OpenSteps(1);
  const QImage before = this->TakePicture();
  vtkNexradTransferFunction* colours = window->View()->Scene()->GetTransferFunction();
  colours->AddNode(vtkNexradTransferFunction::BLUE, 40.0, 1.0);
  const double values[] = {25.0, 45.0};
  const double opacities[] = {0.5, 0.9};
  colours->SetOpacityToIsoValues(values, opacities, 2);
  window->View()->DrawSoon();
  this->WaitForPicture();
  const QImage picture = this->TakePicture();
  EXPECT_AT_LEAST(MeanDifference(before, picture), 2.0, "picture that colours change, of 255");
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), contextBound,
    "picture with edited colours and of the copied command, mean difference of 255", contextReason);
  this->Reopen();
  EXPECT_EQ(MeanDifference(picture, this->TakePicture()), 0.0);
}

TEST_F(WindowFilesTest, ASessionOpensAsItWas)
{
  this->OpenSteps(3);
  this->ChangeSettings();
  this->Click("Step on");
  window->Player()->SetInterval(40);
  this->WaitForPicture();
  const QImage picture = this->TakePicture();
  this->Reopen();
  EXPECT_EQ(window->Player()->Step(), 1U);
  EXPECT_EQ(window->Player()->State().times.size(), 3U);
  EXPECT_EQ(window->Player()->Interval(), 40);
  EXPECT_EQ(this->Find<QComboBox>("Preset")->currentText(), "storm cores");
  EXPECT_EQ(this->Find<QDoubleSpinBox>("Stretch")->value(), 5.5);
  EXPECT_EQ(MeanDifference(picture, this->TakePicture()), 0.0);
}

// What is open stays open.
TEST_F(WindowFilesTest, AWrongSessionIsOneLine)
{
  this->OpenSteps(2);
  const std::filesystem::path path = folder.Path() / "bad.nxsession";
  std::ofstream(path) << R"({"format": "nexrad3d session", "version": 1, "inputs": ["x"],)"
                      << R"( "options": {"slices": "many"}})";
  window->Open({QString::fromStdString(path.string())});
  auto* list = this->Find<QListWidget>("damage");
  ASSERT_EQ(list->count(), 1);
  const std::string line = list->item(0)->text().toStdString();
  EXPECT_NE(line.find("bad.nxsession: options: --slices"), std::string::npos) << line;
  EXPECT_EQ(window->Player()->State().times.size(), 2U);
}

// Radar files are merged by the command as the window merges them.
TEST_F(WindowFilesTest, TheCopiedCommandMergesRadarFiles)
{
  const Site site = {"KEAX", Position{38.81, -94.264, 333.0}};
  request.input.inputs = {WriteLevel2(
    folder.Path() / "one", {ConstantVolume(site, *ParseIso8601("2006-03-12T18:01:10"), 40.0)})};
  request.input.grid.grid.dimensions = {32, 32, 16};
  // Rays that hold one value are a fault of the receiver.
  request.input.grid.quality.level = QualityLevel::Off;
  this->OpenWindow();
  ASSERT_TRUE(this->Wait([&] { return window->View()->Scene()->GetVolume() != nullptr; }));
  this->WaitForPicture();
  EXPECT_AT_MOST(MeanDifference(this->TakePicture(), this->DrawWithoutTheWindow()), contextBound,
    "picture of a radar file in the window and of the copied command, of 255", contextReason);
}

// A box that follows the storm is in the copied command and in pictures of each time.
TEST_F(WindowFilesTest, TheCopiedCommandAndAMovieHaveTheBox)
{
  const TemporaryFolder radar;
  WriteSyntheticScans(
    radar.Path(), "KEAX", *ParseIso8601("2006-03-12T18:00:00Z"), std::chrono::minutes(12));
  request.input.inputs = {radar.Path()};
  request.input.grid.grid.dimensions = {64, 64, 32};
  request.input.box = BoxRequest{{0.0, 50e3, 0.0, 50e3}};
  request.input.box->followedFrom = *ParseIso8601("2006-03-12T18:05:00Z");
  this->OpenWindow();
  const auto waitForBox = [&]
  {
    ASSERT_TRUE(this->Wait(
      [&] {
        return !window->Player()->IsWaiting() && window->View()->Scene()->GetDetail() != nullptr;
      }));
    this->WaitForPicture();
  };
  waitForBox();
  window->Player()->Move(1);
  waitForBox();
  const QImage second = this->TakePicture();
  EXPECT_AT_MOST(MeanDifference(second, this->DrawWithoutTheWindow()), contextBound,
    "picture of a following box in the window and of the copied command, of 255", contextReason);
  this->SaveAs(Qt::Key_M, folder.Path() / "box.png");
  EXPECT_TRUE(this->WaitForMovie());
  const QImage frame(QString::fromStdString((folder.Path() / "box-20060312T181000Z.png").string()));
  EXPECT_AT_MOST(MeanDifference(second, frame), contextBound,
    "picture of a following box in the window and in a series, of 255", contextReason);
}

TEST_F(WindowFilesTest, SavesTheVolume)
{
  this->OpenSteps(1);
  const std::filesystem::path nxv = folder.Path() / "saved.nxv";
  const std::filesystem::path vti = folder.Path() / "saved.vti";
  this->SaveAs(Qt::Key_E, nxv);
  EXPECT_TRUE(this->Wait([&] { return std::filesystem::exists(nxv); }));
  const GriddedVolume saved = ReadNxv(nxv);
  const GriddedVolume first = ReadNxv(folder.Path() / "20060312T183000Z.nxv");
  EXPECT_EQ(saved.values, first.values);
  EXPECT_EQ(saved.time, first.time);
  EXPECT_EQ(saved.sites, first.sites);
  this->SaveAs(Qt::Key_E, vti);
  EXPECT_TRUE(this->Wait([&] { return std::filesystem::exists(vti); }));
  const QImage picture = this->TakePicture();
  window->Open({QString::fromStdString(vti.string())});
  EXPECT_TRUE(this->Wait([&] { return !window->Player()->IsWaiting(); }));
  this->WaitForPicture();
  EXPECT_AT_MOST(MeanDifference(picture, this->TakePicture()), 9.9e-6,
    "picture of codes and of the values saved from them, mean difference of 255");
}

TEST_F(WindowFilesTest, AVolumeThatCannotBeSavedIsOneLine)
{
  this->OpenSteps(1);
  this->SaveAs(Qt::Key_E, "/dev/full/x.nxv");
  auto* list = this->Find<QListWidget>("damage");
  EXPECT_TRUE(this->Wait([&] { return list->count() == 1; }));
}

// The window can be used in the meantime: it goes to another time.
TEST_F(WindowFilesTest, SavesAMovieWhileTheWindowIsUsed)
{
  this->OpenSteps(3);
  const std::filesystem::path path = folder.Path() / "storm.ogv";
  this->SaveAs(Qt::Key_M, path);
  ASSERT_NE(window->findChild<QProgressDialog*>("movie"), nullptr);
  EXPECT_AT_LEAST(
    this->Changes([&] { this->Click("Step on"); }), 0.04, "pixels that a step changes, part");
  EXPECT_TRUE(this->WaitForMovie());
  const std::string movie = FileContent(path);
  EXPECT_EQ(movie.substr(0, 4), "OggS");
  EXPECT_NE(movie.find("theora"), std::string::npos);
  EXPECT_TRUE(window->Problems().isEmpty());
}

TEST_F(WindowFilesTest, SavesAPictureOfEachTime)
{
  this->OpenSteps(2);
  this->Choose("Preset", 1);
  this->Turn();
  this->WaitForPicture();
  this->SaveAs(Qt::Key_M, folder.Path() / "storm.png");
  EXPECT_TRUE(this->WaitForMovie());
  for (const char* name : {"storm-20060312T183000Z.png", "storm-20060312T183500Z.png"})
  {
    const QImage picture(QString::fromStdString((folder.Path() / name).string()));
    EXPECT_AT_MOST(MeanDifference(this->TakePicture(), picture), contextBound,
      "picture of a series and of the window, mean difference of 255", contextReason);
    this->Click("Step on");
    this->WaitForPicture();
  }
}

TEST_F(WindowFilesTest, ACancelledMovieLeavesNoFile)
{
  this->OpenSteps(6);
  this->SaveAs(Qt::Key_M, folder.Path() / "storm.ogv");
  auto* progress = window->findChild<QProgressDialog*>("movie");
  ASSERT_NE(progress, nullptr);
  EXPECT_TRUE(this->Wait([&] { return progress->value() > 0; }));
  QTest::mouseClick(progress->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_TRUE(this->WaitForMovie());
  for (const auto& entry : std::filesystem::directory_iterator(folder.Path()))
  {
    EXPECT_EQ(entry.path().filename().string().find("storm"), std::string::npos) << entry.path();
  }
}
