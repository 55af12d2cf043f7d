// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/TransferFunction/SplinePointsItem.h"

#include <vtkCallbackCommand.h>
#include <vtkContextMouseEvent.h>
#include <vtkNexradTransferFunction.h>
#include <vtkObjectFactory.h>
#include <vtkVector.h>

namespace nexrad::viewer
{

vtkStandardNewMacro(SplinePointsItem);

SplinePointsItem::SplinePointsItem()
{
  this->EnforceValidFunction = false; // a channel of one node is a constant
}

SplinePointsItem::~SplinePointsItem()
{
  if (function)
  {
    function->RemoveObserver(this->Callback);
  }
}

void SplinePointsItem::SetFunction(vtkNexradTransferFunction* shown, int shownChannel)
{
  if (shown == function && shownChannel == channel)
  {
    return;
  }
  if (function)
  {
    function->RemoveObserver(this->Callback);
  }
  function = shown;
  channel = shownChannel;
  this->SetCurrentPoint(-1);
  if (function)
  {
    function->AddObserver(vtkCommand::ModifiedEvent, this->Callback);
  }
  this->ResetBounds();
  this->ComputePoints();
}

vtkIdType SplinePointsItem::GetNumberOfPoints() const
{
  return function ? function->GetNumberOfNodes(channel) : 0;
}

// Midpoint and sharpness, of which splines know nothing, are VTK's usual ones.
void SplinePointsItem::GetControlPoint(vtkIdType index, double* point) const
{
  point[2] = 0.5;
  point[3] = 0.0;
  if (function)
  {
    function->GetNode(channel, static_cast<int>(index), point);
  }
}

void SplinePointsItem::SetControlPoint(vtkIdType index, double* point)
{
  this->StartChanges();
  function->MoveNode(channel, static_cast<int>(index), point[0], point[1]);
  this->EndChanges();
}

vtkIdType SplinePointsItem::AddPoint(double* position)
{
  if (!function)
  {
    return -1;
  }
  const vtkIdType before = this->GetNumberOfPoints();
  this->StartChanges();
  const vtkIdType added = function->AddNode(channel, position[0], position[1]);
  if (this->GetNumberOfPoints() > before)
  {
    this->AddPointId(added);
  }
  this->EndChanges();
  return added;
}

// The last node stays: without any, the channel is 0 everywhere and no curve is left to click on.
vtkIdType SplinePointsItem::RemovePoint(double* position)
{
  const vtkIdType index = this->GetControlPointId(position);
  if (index < 0 || this->GetNumberOfPoints() < 2)
  {
    return -1;
  }
  this->StartChanges();
  function->RemoveNode(channel, static_cast<int>(index));
  this->EndChanges();
  this->SetCurrentPoint(-1);
  return index;
}

bool SplinePointsItem::MouseButtonPressEvent(const vtkContextMouseEvent& mouse)
{
  pressed = true;
  if (mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON)
  {
    const bool taken = this->vtkControlPointsItem::MouseButtonPressEvent(mouse);
    moved();
    return taken;
  }
  double position[2];
  const vtkVector2f at = mouse.GetPos();
  this->TransformScreenToData(
    static_cast<double>(at[0]), static_cast<double>(at[1]), position[0], position[1]);
  const vtkIdType under = this->FindPoint(position);
  if (under >= 0)
  {
    double point[4];
    this->GetControlPoint(under, point);
    this->RemovePoint(point);
    moved();
  }
  return true;
}

bool SplinePointsItem::MouseDoubleClickEvent(const vtkContextMouseEvent& mouse)
{
  return this->MouseButtonPressEvent(mouse);
}

// VTK's own would hold the first and the last node at their heights.
bool SplinePointsItem::MouseMoveEvent(const vtkContextMouseEvent& mouse)
{
  if (!pressed)
  {
    return false;
  }
  if (mouse.GetButton() == vtkContextMouseEvent::LEFT_BUTTON && this->GetCurrentPoint() >= 0)
  {
    vtkVector2f position;
    this->TransformScreenToData(mouse.GetPos(), position);
    this->SetCurrentPointPos(position);
    moved();
  }
  return true;
}

bool SplinePointsItem::MouseButtonReleaseEvent(const vtkContextMouseEvent&)
{
  if (pressed)
  {
    pressed = false;
    finished();
  }
  return true;
}

void SplinePointsItem::emitEvent(unsigned long event, void* parameters)
{
  this->InvokeEvent(event, parameters);
}

vtkMTimeType SplinePointsItem::GetControlPointsMTime()
{
  return function ? function->GetMTime() : this->GetMTime();
}

} // namespace nexrad::viewer
