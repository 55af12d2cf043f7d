// SPDX-License-Identifier: BSD-3-Clause
#include "WindowTest.h"

#include "StormVolume.h"
#include "Viewer/Playback.h"
#include "Viewer/SceneView.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLineEdit>
#include <QSettings>
#include <QSurfaceFormat>
#include <QTimer>
#include <QToolButton>
#include <QVTKOpenGLNativeWidget.h>
#include <QtTest/QtTest>

#include <algorithm>
#include <cstdlib>

using namespace nexrad::viewer;

namespace nexrad::testing
{

std::unique_ptr<QApplication> WindowTest::application;
std::unique_ptr<QTemporaryDir> WindowTest::settings;

double Difference(const QImage& a, const QImage& b)
{
  qint64 different = 0;
  for (int y = 0; y < a.height(); ++y)
  {
    for (int x = 0; x < a.width(); ++x)
    {
      const QRgb first = a.pixel(x, y);
      const QRgb second = b.pixel(x, y);
      const int most = std::max({std::abs(qRed(first) - qRed(second)),
        std::abs(qGreen(first) - qGreen(second)), std::abs(qBlue(first) - qBlue(second))});
      different += most > 8 ? 1 : 0;
    }
  }
  return static_cast<double>(different) / static_cast<double>(a.width() * a.height());
}

void AnswerDialog(const std::filesystem::path& path)
{
  constexpr int mostTries = 200;
  auto* asks = new QTimer(qApp);
  QObject::connect(asks, &QTimer::timeout, asks,
    [asks, path, tries = 0]() mutable
    {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      auto* name = dialog != nullptr ? dialog->findChild<QLineEdit*>("fileNameEdit") : nullptr;
      if (name == nullptr || !name->isVisible())
      {
        return; // not yet
      }
      name->setText(QString::fromStdString(path.string()));
      QMetaObject::invokeMethod(dialog, "accept"); // may do nothing while the folder is read
      if (dialog->isVisible() && ++tries == mostTries)
      {
        ADD_FAILURE() << "the dialog stays open: " << path;
        dialog->reject();
      }
      if (!dialog->isVisible())
      {
        asks->stop();
        asks->deleteLater();
      }
    });
  asks->start(100);
}

void WindowTest::SetUpTestSuite()
{
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  static int count = 1;
  static char name[] = "TestWindow";
  static char* arguments[] = {name, nullptr};
  application = std::make_unique<QApplication>(count, arguments);
  QCoreApplication::setOrganizationName("nexrad3d-test");
  settings = std::make_unique<QTemporaryDir>();
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings->path());
}

void WindowTest::TearDownTestSuite()
{
  application.reset();
}

void WindowTest::OpenSteps(int steps)
{
  request.input.inputs = {WriteStormFiles(folder.Path(), steps)};
  this->OpenWindow();
  ASSERT_TRUE(this->Wait(
    [&]
    {
      const auto& loaded = window->Player()->State().loaded;
      return static_cast<int>(std::count(loaded.begin(), loaded.end(), true)) == steps;
    }));
  this->WaitForPicture();
}

void WindowTest::OpenWindow(const std::array<int, 2>& size)
{
  request.size = size;
  request.pictures = folder.Path();
  scene::UseClassicLook(request.scene); // tests reach for the faces of the domain
  window = std::make_unique<MainWindow>(request);
  window->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
  QApplication::setActiveWindow(window.get()); // there is no window manager
}

bool WindowTest::Wait(const std::function<bool()>& condition)
{
  return QTest::qWaitFor(condition, 60'000);
}

QImage WindowTest::WaitForPicture()
{
  QSize before;
  for (int same = 0; same < 3; same = window->View()->size() == before ? same + 1 : 0)
  {
    before = window->View()->size(); // the panels beside the picture may take their places late
    QTest::qWait(30);
  }
  return window->View()->grabFramebuffer();
}

void WindowTest::Click(const char* button)
{
  QTest::mouseClick(this->Find<QToolButton>(button), Qt::LeftButton);
}

void WindowTest::Choose(const char* name, int down)
{
  auto* box = this->Find<QComboBox>(name);
  for (int i = 0; i < std::abs(down); ++i)
  {
    QTest::keyClick(box, down > 0 ? Qt::Key_Down : Qt::Key_Up);
  }
}

double WindowTest::Changes(const std::function<void()>& action)
{
  const QImage before = this->WaitForPicture();
  action();
  return Difference(before, this->WaitForPicture());
}

} // namespace nexrad::testing
