// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/ViewerStyle.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::scene
{
namespace
{

constexpr double turnOfWidth = 180.0; // degrees, of a drag across the window
constexpr double zoomOfHeight = 4.0;  // factor, of a drag over its height
constexpr double zoomOfWheel = 1.1;   // factor, of one click

// From the place before to that now, as parts of the window.
std::array<double, 2> Dragged(vtkRenderWindowInteractor* interactor)
{
  const int* now = interactor->GetEventPosition();
  const int* before = interactor->GetLastEventPosition();
  const int* size = interactor->GetSize();
  return {static_cast<double>(now[0] - before[0]) / std::max(size[0], 1),
    static_cast<double>(now[1] - before[1]) / std::max(size[1], 1)};
}

} // namespace

vtkStandardNewMacro(ViewerStyle);

void ViewerStyle::OnLeftButtonDown()
{
  this->StartRotate();
}

void ViewerStyle::OnLeftButtonUp()
{
  this->EndRotate();
}

void ViewerStyle::OnRightButtonDown()
{
  this->StartDolly();
}

void ViewerStyle::OnRightButtonUp()
{
  this->EndDolly();
}

void ViewerStyle::OnMouseMove()
{
  const std::array<double, 2> way = Dragged(this->Interactor);
  if (this->State == VTKIS_ROTATE)
  {
    this->turn(way[0] * turnOfWidth, -way[1] * turnOfWidth);
  }
  else if (this->State == VTKIS_DOLLY)
  {
    this->zoom(std::pow(zoomOfHeight, way[1]));
  }
}

void ViewerStyle::OnMouseWheelForward()
{
  this->zoom(zoomOfWheel);
}

void ViewerStyle::OnMouseWheelBackward()
{
  this->zoom(1.0 / zoomOfWheel);
}

void ViewerStyle::OnKeyPress()
{
  const char* key = this->Interactor->GetKeySym();
  this->press(key != nullptr ? key : "");
}

void ViewerStyle::OnChar() {}

} // namespace nexrad::scene
