// SPDX-License-Identifier: BSD-3-Clause
// What is taken out of the window: the command that draws its picture, and sessions.
#include "ProgramRun.h"
#include "StormVolume.h"
#include "Tolerance.h"
#include "Viewer/MainWindow.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"
#include "WindowTest.h"

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

// Mean over all pixels and colours of the absolute difference, 0 to 255.
double MeanDifference(const QImage& a, const QImage& b)
{
  if (a.size() != b.size() || a.isNull())
  {
    return 255.0;
  }
  qint64 sum = 0;
  for (int y = 0; y < a.height(); ++y)
  {
    for (int x = 0; x < a.width(); ++x)
    {
      const QRgb first = a.pixel(x, y);
      const QRgb second = b.pixel(x, y);
      sum += std::abs(qRed(first) - qRed(second)) + std::abs(qGreen(first) - qGreen(second)) +
             std::abs(qBlue(first) - qBlue(second));
    }
  }
  return static_cast<double>(sum) / (3.0 * a.width() * a.height());
}

// Types a name into the next dialog of files, and accepts it.
void AnswerDialog(const std::filesystem::path& path)
{
  QTimer::singleShot(300, qApp,
    [path]
    {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
      ASSERT_NE(name, nullptr);
      name->clear();
      QTest::keyClicks(name, QString::fromStdString(path.string()));
      QTest::keyClick(name, Qt::Key_Enter);
    });
}

class WindowFilesTest : public WindowTest
{
protected:
  QImage TakePicture()
  {
    QTest::keyClick(window.get(), Qt::Key_S);
    EXPECT_FALSE(window->Pictures().empty());
    return QImage(QString::fromStdString(window->Pictures().back().string()));
  }

  // Runs the command that the window copies, in a folder of its own.
  QImage DrawWithoutTheWindow()
  {
    QTest::keyClick(window.get(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    const std::string command = QApplication::clipboard()->text().toStdString();
    const std::filesystem::path program = Nexrad3dPath();
    const TemporaryFolder place;
    const ProgramRun run = RunProgram(
      "/bin/sh", {"-c", "cd " + place.Path().string() +
                          " && PATH=" + program.parent_path().string() + ":$PATH && " + command});
    EXPECT_EQ(run.status, 0) << command << '\n' << run.errors;
    std::string picture = run.output.substr(run.output.rfind('\n', run.output.size() - 2) + 1);
    picture.erase(picture.find_last_not_of('\n') + 1);
    return QImage(QString::fromStdString((place.Path() / picture).string()));
  }

  void Enter(const char* box, const char* number)
  {
    auto* spin = this->Find<QDoubleSpinBox>(box);
    spin->setFocus();
    spin->selectAll();
    QTest::keyClicks(spin, QString(number) + "\t");
  }

  void Tick(const char* box)
  {
    QTest::mouseClick(this->Find<QCheckBox>(box), Qt::LeftButton, {}, {8, 8});
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
  EXPECT_AT_MOST(MeanDifference(this->TakePicture(), this->DrawWithoutTheWindow()), 1e-9,
    "picture of the window and of the copied command, mean difference of 255");
}

TEST_F(WindowFilesTest, TheCopiedCommandHasAllSettings)
{
  this->OpenSteps(1);
  const QImage before = this->TakePicture();
  this->ChangeSettings();
  this->WaitForPicture();
  const QImage picture = this->TakePicture();
  EXPECT_AT_LEAST(MeanDifference(before, picture), 50.0, "picture that settings change, of 255");
  EXPECT_AT_MOST(MeanDifference(picture, this->DrawWithoutTheWindow()), 1e-9,
    "picture of the window with other settings and of the copied command, of 255");
}
