// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Viewer/Cutting/ShownScene.h"

#include <QDockWidget>

class QAction;

namespace nexrad::viewer
{

class SectionPanel;

/// The panel of the vertical section as a part of the window that can be shown and hidden. The line
/// stays on the ground when the panel is hidden.
class SectionDock : public QDockWidget
{
  Q_OBJECT

public:
  /// What `view` points at must outlive it.
  explicit SectionDock(const ShownScene& view, QWidget* parent = nullptr);

  SectionPanel* Panel() const { return panel; }
  /// Shows the panel and lets the next drag draw the line.
  QAction* DrawAction() const { return draw; }

private:
  SectionPanel* panel;
  QAction* draw;
};

} // namespace nexrad::viewer
