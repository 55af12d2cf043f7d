// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Cutting/SectionDock.h"

#include "Viewer/Cutting/SectionPanel.h"

#include <QAction>

namespace nexrad::viewer
{

SectionDock::SectionDock(const ShownScene& view, QWidget* parent)
  : QDockWidget("Section", parent)
  , panel(new SectionPanel(view, this))
  , draw(new QAction("Draw a &section", this))
{
  this->setObjectName("section dock");
  this->setFeatures(QDockWidget::DockWidgetClosable); // a chart of OpenGL stays in its window
  this->setWidget(panel);
  this->hide();
  draw->setShortcut(QKeySequence("X"));
  draw->setToolTip("Drag on the ground from A to B: the vertical section along that line");
  connect(draw, &QAction::triggered, this,
    [this]
    {
      this->show();
      panel->DrawLine(true);
    });
}

} // namespace nexrad::viewer
