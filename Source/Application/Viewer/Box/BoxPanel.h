// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;

namespace nexrad::viewer
{

class BoxMouse;

/// The box in finer voxels as buttons, a switch, and what it is: its size, voxels and time.
class BoxPanel : public QWidget
{
  Q_OBJECT

public:
  /// `box` must outlive it.
  explicit BoxPanel(BoxMouse& box, QWidget* parent = nullptr);

private:
  QToolButton* ButtonOf(QAction* action);
  void Follow();

  BoxMouse& box;
  QLabel* text = nullptr;
};

} // namespace nexrad::viewer
