// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QPoint>

#include <array>

class QMouseEvent;
class QWheelEvent;
class vtkNexradNavigator;

namespace nexrad::viewer
{

class SceneView;

/// Brings the camera near with the mouse: dragging with the middle button, or with the left one and
/// Shift, moves the scene; the wheel zooms towards the pointer; a double click moves what is there
/// into the middle.
class CameraMouse : public QObject
{
  Q_OBJECT

public:
  /// `view` must outlive it.
  explicit CameraMouse(SceneView& view);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool Press(const QMouseEvent& event);
  void Zoom(const QWheelEvent& event);

  SceneView& view;
  vtkNexradNavigator* navigator;
  Qt::MouseButton panning = Qt::NoButton; ///< the button that is held for it
};

/// A place of the view as VTK counts: pixels of the screen from the lower left corner.
std::array<double, 2> ScenePixel(const SceneView& view, const QPointF& place);

} // namespace nexrad::viewer
