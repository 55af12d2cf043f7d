// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Box/BoxDock.h"

#include "Viewer/Box/BoxMouse.h"
#include "Viewer/Box/BoxPanel.h"
#include "Viewer/Parts/Playback.h"
#include "Viewer/Parts/SceneView.h"

#include <QDockWidget>
#include <QMainWindow>

namespace nexrad::viewer
{

BoxMouse* MakeBoxDock(QMainWindow& window, SceneView& view, Playback& playback, QDockWidget* behind)
{
  auto* box = new BoxMouse(view, playback);
  auto* dock = new QDockWidget("Box", &window);
  dock->setObjectName("box dock");
  dock->setWidget(new BoxPanel(*box, dock));
  window.addDockWidget(Qt::RightDockWidgetArea, dock);
  window.tabifyDockWidget(behind, dock);
  behind->raise();
  return box;
}

} // namespace nexrad::viewer
