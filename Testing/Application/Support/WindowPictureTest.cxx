// SPDX-License-Identifier: BSD-3-Clause
#include "WindowPictureTest.h"

#include "ProgramRun.h"
#include "Viewer/Playback.h"

#include <QCheckBox>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QtTest/QtTest>

#include <cstdlib>
#include <string>

using namespace nexrad::viewer;

namespace nexrad::testing
{

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

QImage WindowPictureTest::TakePicture()
{
  QTest::keyClick(window.get(), Qt::Key_S);
  EXPECT_FALSE(window->Pictures().empty());
  return QImage(QString::fromStdString(window->Pictures().back().string()));
}

std::string WindowPictureTest::CopyCommand()
{
  QTest::keyClick(window.get(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
  return QApplication::clipboard()->text().toStdString();
}

QImage WindowPictureTest::DrawWithoutTheWindow()
{
  const std::string command = this->CopyCommand();
  const std::filesystem::path program = Nexrad3dPath();
  const TemporaryFolder place;
  const ProgramRun run = RunProgram(
    "/bin/sh", {"-c", "cd " + place.Path().string() + " && PATH=" + program.parent_path().string() +
                        ":$PATH && " + command});
  EXPECT_EQ(run.status, 0) << command << '\n' << run.errors;
  std::string picture = run.output.substr(run.output.rfind('\n', run.output.size() - 2) + 1);
  picture.erase(picture.find_last_not_of('\n') + 1);
  return QImage(QString::fromStdString((place.Path() / picture).string()));
}

void WindowPictureTest::Enter(const char* box, const char* number)
{
  auto* spin = this->Find<QDoubleSpinBox>(box);
  spin->setFocus();
  spin->selectAll();
  QTest::keyClicks(spin, QString(number) + "\t");
}

void WindowPictureTest::Tick(const char* box)
{
  QTest::mouseClick(this->Find<QCheckBox>(box), Qt::LeftButton, {}, {8, 8});
}

void WindowPictureTest::Reopen()
{
  const std::filesystem::path path = folder.Path() / "day.nxsession";
  AnswerDialog(path);
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(std::filesystem::exists(path));
  viewer::ViewRequest reopened;
  reopened.input.inputs = {path};
  request = reopened;
  this->OpenWindow({960, 640});
  ASSERT_TRUE(this->Wait([&] { return window->Player()->HasSeries(); }));
  ASSERT_TRUE(this->Wait([&] { return !window->Player()->IsWaiting(); }));
  this->WaitForPicture();
}

} // namespace nexrad::testing
