// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkInteractorStyle.h>

#include <functional>
#include <string>

namespace nexrad::scene
{

/// What the mouse and the keys ask of the viewer. Dragging with the left button turns and tilts,
/// with the right button, or turning the wheel, zooms. VTK's own keys are off.
class ViewerStyle : public vtkInteractorStyle
{
public:
  static ViewerStyle* New();
  vtkTypeMacro(ViewerStyle, vtkInteractorStyle);

  std::function<void(double degrees, double tilt)> turn; ///< by degrees to the right and upwards
  std::function<void(double factor)> zoom;               ///< above 0
  std::function<void(const std::string& key)> press;     ///< an X key symbol, as "space" or "s"

  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMouseMove() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnKeyPress() override;
  void OnChar() override;

protected:
  ViewerStyle() = default;
  ~ViewerStyle() override = default;

private:
  ViewerStyle(const ViewerStyle&) = delete;
  void operator=(const ViewerStyle&) = delete;
};

} // namespace nexrad::scene
