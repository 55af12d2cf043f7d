// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkInteractorStyle.h>

#include <functional>

namespace nexrad::viewer
{

/// What dragging with the mouse asks of the view: with the left button it turns and tilts, with the
/// right button it zooms. VTK's own keys are off.
class TurnAndZoom : public vtkInteractorStyle
{
public:
  static TurnAndZoom* New();
  vtkTypeMacro(TurnAndZoom, vtkInteractorStyle);

  std::function<void(double degrees, double tilt)> turn; ///< by degrees to the right and upwards
  std::function<void(double factor)> zoom;               ///< above 0

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMouseMove() override;
  void OnChar() override {}

protected:
  TurnAndZoom() = default;
  ~TurnAndZoom() override = default;

private:
  TurnAndZoom(const TurnAndZoom&) = delete;
  void operator=(const TurnAndZoom&) = delete;
};

} // namespace nexrad::viewer
