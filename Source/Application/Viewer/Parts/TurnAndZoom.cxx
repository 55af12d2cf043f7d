// SPDX-License-Identifier: BSD-3-Clause
#include "Viewer/Parts/TurnAndZoom.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::viewer
{
namespace
{

constexpr double turnOfWidth = 180.0; // degrees, of a drag across the window
constexpr double zoomOfHeight = 4.0;  // factor, of a drag over its height

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

vtkStandardNewMacro(TurnAndZoom);

void TurnAndZoom::OnLeftButtonDown()
{
  this->StartRotate();
}

void TurnAndZoom::OnLeftButtonUp()
{
  this->EndRotate();
}

void TurnAndZoom::OnRightButtonDown()
{
  this->StartDolly();
}

void TurnAndZoom::OnRightButtonUp()
{
  this->EndDolly();
}

void TurnAndZoom::OnMouseMove()
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

} // namespace nexrad::viewer
