// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/BoxMouse.h"

#include "Viewer/Parts/CameraMouse.h"
#include "Viewer/Parts/Playback.h"
#include "Viewer/Parts/SceneView.h"

#include <vtkImageData.h>
#include <vtkNexradEchoPicker.h>
#include <vtkNexradVolumeScene.h>

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

namespace nexrad::viewer
{

BoxMouse::BoxMouse(SceneView& sceneView, Playback& thePlayback)
  : QObject(&sceneView)
  , view(sceneView)
  , playback(thePlayback)
{
  picker->SetScene(view.Scene());
  view.installEventFilter(this);
  connect(&playback, &Playback::BoxLoaded, this, &BoxMouse::Show);
  connect(&playback, &Playback::Failed, this,
    [this]
    {
      if (!playback.HasBox())
      {
        this->TakeAway();
      }
    });
}

BoxMouse::~BoxMouse() = default;

std::optional<std::array<double, 2>> BoxMouse::GroundAt(const QPointF& place)
{
  const auto [x, y] = ScenePixel(view, place);
  if (picker->PickGround(x, y, view.Scene()->GetRenderer()) == vtkNexradEchoPicker::NOTHING)
  {
    return std::nullopt;
  }
  return std::array<double, 2>{picker->GetPlace()[0], picker->GetPlace()[1]};
}

// Draws the box from the corner where the drag began; beyond the ground, it stays as it was.
void BoxMouse::Mark(const QPointF& place)
{
  if (const auto to = this->GroundAt(place))
  {
    const auto [west, east] = std::minmax((*from)[0], (*to)[0]);
    const auto [south, north] = std::minmax((*from)[1], (*to)[1]);
    faces = {west, east, south, north};
    view.Scene()->MarkBox(west, east, south, north);
    view.DrawSoon();
  }
}

void BoxMouse::Release()
{
  from.reset();
  if (faces[1] > faces[0] && faces[3] > faces[2])
  {
    BoxRequest request;
    request.faces = faces;
    playback.SetBox(request);
  }
  else
  {
    this->TakeAway();
  }
}

void BoxMouse::TakeAway()
{
  if (playback.HasBox())
  {
    playback.SetBox(std::nullopt);
  }
  view.Scene()->SetDetail(nullptr);
  view.Scene()->MarkNoBox();
  view.DrawSoon();
}

void BoxMouse::Show(vtkImageData* box)
{
  view.Scene()->SetDetail(box);
  if (!playback.HasBox() && !from)
  {
    view.Scene()->MarkNoBox();
  }
  view.DrawSoon();
  if (box != nullptr)
  {
    const int* size = box->GetDimensions();
    emit Said(QString("Box of %1 × %2 × %3 voxels; Escape takes it away")
                .arg(size[0])
                .arg(size[1])
                .arg(size[2]));
  }
}

bool BoxMouse::eventFilter(QObject* watched, QEvent* event)
{
  auto* mouse = dynamic_cast<QMouseEvent*>(event);
  if (event->type() == QEvent::MouseButtonPress && mouse->button() == Qt::LeftButton &&
      mouse->modifiers() == Qt::ControlModifier)
  {
    from = this->GroundAt(mouse->localPos());
    faces = {};
    return true;
  }
  if (event->type() == QEvent::MouseMove && from)
  {
    this->Mark(mouse->localPos());
    return true;
  }
  if (event->type() == QEvent::MouseButtonRelease && from && mouse->button() == Qt::LeftButton)
  {
    this->Release();
    return true;
  }
  if (event->type() == QEvent::KeyPress && dynamic_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape)
  {
    from.reset();
    this->TakeAway();
    return true;
  }
  return QObject::eventFilter(watched, event);
}

} // namespace nexrad::viewer
