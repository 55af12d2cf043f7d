// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/PointerReadout.h"

#include "Viewer/SceneView.h"

#include <vtkNexradEchoPicker.h>
#include <vtkNexradVolumeScene.h>

#include <QMouseEvent>

namespace nexrad::viewer
{

PointerReadout::PointerReadout(SceneView& sceneView, QWidget* parent)
  : QLabel(parent)
  , view(sceneView)
{
  this->setObjectName("readout");
  this->setAccessibleName("What is under the pointer");
  this->setToolTip("Under the pointer: value in the unit of the moment, latitude and longitude in "
                   "degrees, height above sea level in km; the nearest radar, the distance from it "
                   "in km and the direction in degrees clockwise from north");
  this->setTextInteractionFlags(Qt::TextSelectableByMouse);
  picker->SetScene(view.Scene());
  view.setMouseTracking(true);
  view.installEventFilter(this);
  connect(&view, &SceneView::VolumeShown, this, &PointerReadout::Refresh);
  connect(&view, &SceneView::CameraMoved, this, &PointerReadout::Refresh);
}

PointerReadout::~PointerReadout() = default;

void PointerReadout::Refresh()
{
  if (inside)
  {
    const auto [x, y] = ScenePixel(view, place);
    picker->Pick(x, y, 0.0, view.Scene()->GetRenderer());
    this->setText(QString::fromStdString(picker->GetText()));
  }
}

bool PointerReadout::eventFilter(QObject* watched, QEvent* event)
{
  if (event->type() == QEvent::MouseMove)
  {
    place = static_cast<QMouseEvent*>(event)->localPos();
    inside = true;
    this->Refresh();
  }
  else if (event->type() == QEvent::Leave)
  {
    inside = false;
    this->clear();
  }
  return QLabel::eventFilter(watched, event);
}

} // namespace nexrad::viewer
