// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Viewer/Cutting/ShownScene.h"

#include <QObject>

#include <vtkNew.h>

#include <vector>

class vtkBoxRepresentation;
class vtkBoxWidget2;
class vtkImplicitPlaneRepresentation;
class vtkImplicitPlaneWidget2;

namespace nexrad::viewer
{

/// The crop box and the clip plane in the scene, with handles for the mouse: the balls move faces
/// of the box, the plane is moved along its arrow and turned by it.
class CutHandles : public QObject
{
  Q_OBJECT

public:
  /// What `view` points at must outlive it.
  explicit CutHandles(const ShownScene& view, QObject* parent = nullptr);
  ~CutHandles() override;

  /// Shows the handles of what the scene cuts, or none, where the scene has its box and its plane.
  /// True when they changed, so that the scene must be drawn.
  bool Follow(bool shown);

signals:
  /// The mouse changed the box or the plane of the scene.
  void Moved();
  /// The mouse let go of the box or the plane.
  void Settled();

private:
  /// Where the handles are to be in the scene: the box, or the plane's origin and normal with the
  /// box about it; empty: not shown.
  std::vector<double> BoxPlace() const;
  std::vector<double> PlanePlace() const;
  void TakeBox();
  void TakePlane();

  ShownScene view;
  vtkNew<vtkBoxWidget2> box;
  vtkNew<vtkBoxRepresentation> boxShape;
  vtkNew<vtkImplicitPlaneWidget2> plane;
  vtkNew<vtkImplicitPlaneRepresentation> planeShape;
  std::vector<double> boxPlace;   ///< that is shown
  std::vector<double> planePlace; ///< that is shown
};

} // namespace nexrad::viewer
