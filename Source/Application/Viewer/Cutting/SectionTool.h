// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Viewer/Cutting/ShownScene.h"

#include <QObject>

#include <vtkWeakPointer.h>

#include <array>
#include <vector>

class vtkObject;
class vtkRenderWindowInteractor;

namespace nexrad::viewer
{

/// Lets the mouse draw the line of a section on the ground of a scene, and move its ends. While it
/// does, the camera stands still.
class SectionTool : public QObject
{
  Q_OBJECT

public:
  /// What `view` points at must outlive it.
  explicit SectionTool(const ShownScene& view, QObject* parent);
  ~SectionTool() override;

  /// Whether the next drag with the left button draws a new line.
  void SetDrawing(bool on);
  bool IsDrawing() const { return drawing; }

signals:
  /// The line of the scene was drawn or moved.
  void Moved();
  /// A new line was drawn: drawing is off again.
  void Drawn();

private:
  bool Press(vtkObject*, unsigned long, void*);
  bool Move(vtkObject*, unsigned long, void*);
  bool Release(vtkObject*, unsigned long, void*);
  int EndAt(const std::array<double, 2>& pixel) const;
  void Drag();

  ShownScene view;
  vtkWeakPointer<vtkRenderWindowInteractor> mouse; ///< goes before this object does
  std::vector<unsigned long> tags;
  bool drawing = false;
  int dragged = -1; ///< the end that follows the mouse: 0 A, 1 B; −1 none
};

} // namespace nexrad::viewer
