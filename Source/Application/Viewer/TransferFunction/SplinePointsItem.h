// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkControlPointsItem.h>
#include <vtkSmartPointer.h>

#include <functional>

class vtkNexradTransferFunction;

namespace nexrad::viewer
{

/// The nodes of one channel of a transfer function in a chart, which the mouse adds, moves and
/// removes: the left button moves a node, or adds one where there is none, and the middle and the
/// right button remove one.
class SplinePointsItem : public vtkControlPointsItem
{
public:
  static SplinePointsItem* New();
  vtkTypeMacro(SplinePointsItem, vtkControlPointsItem);

  /// Called while a button of the mouse is down in the item, after each change of the nodes.
  std::function<void()> moved = [] {};
  /// Called when that button is released.
  std::function<void()> finished = [] {};

  void SetFunction(vtkNexradTransferFunction* shown, int shownChannel);
  bool IsPressed() const { return pressed; }

  vtkIdType AddPoint(double* position) override;
  vtkIdType RemovePoint(double* position) override;
  vtkIdType GetNumberOfPoints() const override;
  void GetControlPoint(vtkIdType index, double* point) const override;
  void SetControlPoint(vtkIdType index, double* point) override;

  bool MouseButtonPressEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseDoubleClickEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseMoveEvent(const vtkContextMouseEvent& mouse) override;
  bool MouseButtonReleaseEvent(const vtkContextMouseEvent& mouse) override;

protected:
  SplinePointsItem();
  ~SplinePointsItem() override;

  void emitEvent(unsigned long event, void* parameters) override;
  vtkMTimeType GetControlPointsMTime() override;

private:
  vtkSmartPointer<vtkNexradTransferFunction> function;
  int channel = 3;
  bool pressed = false;
};

} // namespace nexrad::viewer
