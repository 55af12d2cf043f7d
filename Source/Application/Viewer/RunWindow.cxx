// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/RunWindow.h"

#include "Drawing/PictureWindow.h"
#include "Scene/VolumeAppearance.h"
#include "Viewer/MainWindow.h"

#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include <clocale>

namespace nexrad::viewer
{

scene::ViewReport RunWindow(const scene::ViewRequest& request)
{
  scene::RequireDisplay();
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setOrganizationName("nexrad3d");
  QCoreApplication::setApplicationName("nexrad3d");
  int count = 1;
  char name[] = "nexrad3d";
  char* arguments[] = {name, nullptr};
  QApplication application(count, arguments);
  // Qt takes the user's locale, in which numbers in files may have a comma.
  std::setlocale(LC_NUMERIC, "C");
  MainWindow window(request);
  window.show();
  QApplication::exec();
  scene::ViewReport report;
  report.pictures = window.Pictures();
  report.notes = scene::LinesPassedOver(request.scene);
  for (const QString& line : window.Problems())
  {
    report.problems.push_back(line.toStdString());
  }
  return report;
}

} // namespace nexrad::viewer
