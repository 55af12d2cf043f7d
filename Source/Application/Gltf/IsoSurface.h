// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkImageData;
class vtkPlaneCollection;
class vtkPolyData;

namespace nexrad::scene
{

/// Makes the surfaces of values of a merged volume.
///
/// Voxels that count are those with an echo; of reflectivity also those that were scanned and had
/// none, whose value is below that of any surface, so that a surface closes round an echo. Each
/// corner of a triangle lies between two neighbouring voxels that count, interpolated linearly.
/// Beside voxels that were not scanned, are range folded or filtered, a surface is open: no wall of
/// it stands there. It is open at the faces of the volume too.
class SurfaceMaker
{
public:
  /// `volume`: with the arrays of its moment, as values or as codes. Throws Error for one without.
  /// `frame` of the volume.
  SurfaceMaker(vtkImageData* volume, const SceneFrame& frame);
  ~SurfaceMaker();
  SurfaceMaker(const SurfaceMaker&) = delete;
  SurfaceMaker& operator=(const SurfaceMaker&) = delete;

  /// The triangles of the surface in coordinates of the scene, with normals: means of those of the
  /// triangles about a corner, by their areas, which point to lower values. The part of it that all
  /// normals of `planes` point to. No points where no voxel reaches the value.
  vtkSmartPointer<vtkPolyData> Make(double value, vtkPlaneCollection* planes) const;

private:
  vtkNew<vtkImageData> counting; ///< values; not a number where a voxel does not count
};

} // namespace nexrad::scene
