// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vtkNew.h>

#include <QLabel>
#include <QPointF>

class vtkNexradEchoPicker;

namespace nexrad::viewer
{

class SceneView;

/// Says what is under the pointer: value, place, height above sea level, and the radar.
class PointerReadout : public QLabel
{
  Q_OBJECT

public:
  /// `view` must outlive it.
  explicit PointerReadout(SceneView& view, QWidget* parent = nullptr);
  ~PointerReadout() override;

  /// Looks again at where the pointer is, as after a new volume.
  void Refresh();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  SceneView& view;
  vtkNew<vtkNexradEchoPicker> picker;
  QPointF place; ///< of the pointer in the view
  bool inside = false;
};

} // namespace nexrad::viewer
