// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/CameraMouse.h"

#include "Viewer/Parts/SceneView.h"

#include <vtkNexradNavigator.h>

#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>

namespace nexrad::viewer
{
namespace
{

constexpr double zoomOfNotch = 1.1; // factor, of one notch of the wheel
constexpr double notch = 120.0;     // eighths of a degree

} // namespace

CameraMouse::CameraMouse(SceneView& sceneView)
  : QObject(&sceneView)
  , view(sceneView)
  , navigator(sceneView.Navigator())
{
  view.installEventFilter(this);
}

bool CameraMouse::eventFilter(QObject* watched, QEvent* event)
{
  switch (event->type())
  {
  case QEvent::MouseButtonPress:
    return this->Press(*static_cast<QMouseEvent*>(event));
  case QEvent::MouseMove:
    if (panning != Qt::NoButton)
    {
      const auto [x, y] = ScenePixel(view, static_cast<QMouseEvent*>(event)->localPos());
      navigator->Pan(x, y);
      view.ShowMove();
      return true;
    }
    return false;
  case QEvent::MouseButtonRelease:
    if (panning != Qt::NoButton && static_cast<QMouseEvent*>(event)->button() == panning)
    {
      panning = Qt::NoButton;
      return true;
    }
    return false;
  case QEvent::MouseButtonDblClick:
    if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton)
    {
      const auto [x, y] = ScenePixel(view, static_cast<QMouseEvent*>(event)->localPos());
      navigator->CentreOn(x, y);
      view.ShowMove();
      return true;
    }
    return false;
  case QEvent::Wheel:
    this->Zoom(*static_cast<QWheelEvent*>(event));
    return true;
  default:
    return QObject::eventFilter(watched, event);
  }
}

bool CameraMouse::Press(const QMouseEvent& event)
{
  const bool left = event.button() == Qt::LeftButton && event.modifiers() == Qt::ShiftModifier;
  if (panning != Qt::NoButton || (!left && event.button() != Qt::MiddleButton))
  {
    return false;
  }
  panning = event.button();
  const auto [x, y] = ScenePixel(view, event.localPos());
  navigator->Grab(x, y);
  return true;
}

void CameraMouse::Zoom(const QWheelEvent& event)
{
  const auto [x, y] = ScenePixel(view, event.position());
  navigator->ZoomAt(x, y, std::pow(zoomOfNotch, event.angleDelta().y() / notch));
  view.ShowMove();
}

std::array<double, 2> ScenePixel(const SceneView& view, const QPointF& place)
{
  const double ratio = view.devicePixelRatioF();
  return {ratio * place.x(), ratio * (view.height() - 1 - place.y())};
}

} // namespace nexrad::viewer
