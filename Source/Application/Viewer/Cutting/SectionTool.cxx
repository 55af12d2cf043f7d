// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Cutting/SectionTool.h"

#include "Scene/Frame/VolumeInformation.h"

#include <vtkCommand.h>
#include <vtkImageData.h>
#include <vtkNexradVolumeScene.h>
#include <vtkRenderWindowInteractor.h>

#include <QVTKOpenGLNativeWidget.h>

#include <algorithm>
#include <cmath>

namespace nexrad::viewer
{
namespace
{

constexpr double reach = 12.0; // pixels from an end at which the mouse takes it

std::array<double, 2> MouseOf(const ShownScene& view)
{
  const int* position = view.widget->interactor()->GetEventPosition();
  return {static_cast<double>(position[0]), static_cast<double>(position[1])};
}

// The ground under the mouse, at the edge of the volume when the mouse is beyond it.
bool FindPlace(const ShownScene& view, std::array<double, 2>& place)
{
  vtkImageData* volume = view.scene->GetVolume();
  const std::array<double, 2> pixel = MouseOf(view);
  if (volume == nullptr || !view.scene->FindGround(pixel[0], pixel[1], place.data()))
  {
    return false;
  }
  const std::array<double, 6> faces = scene::FacesOf(volume);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    place[axis] = std::clamp(place[axis], faces[2 * axis], faces[2 * axis + 1]);
  }
  return true;
}

void SetEnd(vtkNexradVolumeScene* scene, int end, std::array<double, 2> place)
{
  if (end == 0)
  {
    scene->SetSectionA(place.data());
  }
  else
  {
    scene->SetSectionB(place.data());
  }
}

} // namespace

SectionTool::SectionTool(const ShownScene& sceneView, QObject* parent)
  : QObject(parent)
  , view(sceneView)
  , mouse(sceneView.widget->interactor())
{
  constexpr float beforeTheStyle = 0.6F;
  tags = {
    mouse->AddObserver(vtkCommand::LeftButtonPressEvent, this, &SectionTool::Press, beforeTheStyle),
    mouse->AddObserver(vtkCommand::MouseMoveEvent, this, &SectionTool::Move, beforeTheStyle),
    mouse->AddObserver(
      vtkCommand::LeftButtonReleaseEvent, this, &SectionTool::Release, beforeTheStyle)};
}

SectionTool::~SectionTool()
{
  for (const unsigned long tag : tags)
  {
    if (mouse)
    {
      mouse->RemoveObserver(tag);
    }
  }
}

void SectionTool::SetDrawing(bool on)
{
  drawing = on;
  view.widget->setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
}

// The end of the line that is near a pixel; −1: none.
int SectionTool::EndAt(const std::array<double, 2>& pixel) const
{
  vtkNexradVolumeScene* scene = view.scene;
  int nearest = -1;
  double least = reach * view.widget->devicePixelRatioF();
  for (int end = 0; scene->GetSection() && end < 2; ++end)
  {
    const double* place = end == 0 ? scene->GetSectionA() : scene->GetSectionB();
    double at[2];
    if (!scene->FindPixel(place[0], place[1], at))
    {
      continue;
    }
    const double distance = std::hypot(at[0] - pixel[0], at[1] - pixel[1]);
    nearest = distance < least ? end : nearest;
    least = std::min(least, distance);
  }
  return nearest;
}

bool SectionTool::Press(vtkObject*, unsigned long, void*)
{
  dragged = this->EndAt(MouseOf(view));
  std::array<double, 2> place{};
  if (drawing && FindPlace(view, place))
  {
    vtkNexradVolumeScene* scene = view.scene;
    scene->SectionOn();
    SetEnd(scene, 0, place);
    SetEnd(scene, 1, place);
    dragged = 1;
  }
  return dragged >= 0; // then the camera does not hear of it
}

bool SectionTool::Move(vtkObject*, unsigned long, void*)
{
  if (dragged < 0)
  {
    return false;
  }
  this->Drag();
  return true;
}

bool SectionTool::Release(vtkObject*, unsigned long, void*)
{
  if (dragged < 0)
  {
    return false;
  }
  this->Drag();
  dragged = -1;
  if (drawing)
  {
    this->SetDrawing(false);
    emit Drawn();
  }
  return true;
}

void SectionTool::Drag()
{
  std::array<double, 2> place{};
  if (FindPlace(view, place))
  {
    SetEnd(view.scene, dragged, place);
    view.drawSoon();
    emit Moved();
  }
}

} // namespace nexrad::viewer
