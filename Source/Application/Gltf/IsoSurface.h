// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkPlaneCollection;
class vtkPolyData;

namespace nexrad::scene
{

/// What the surfaces of a merged volume are made of: its values in coordinates of the scene; not a
/// number where a voxel does not count.
///
/// Voxels that count are those with an echo; of reflectivity also those that were scanned and had
/// none, whose value is below that of any surface, so that a surface closes round an echo.
///
/// `volume`: with the arrays of its moment, as values or as codes. Throws Error for one without.
/// `frame` of the volume.
vtkSmartPointer<vtkImageData> MakeCounting(vtkImageData* volume, const SceneFrame& frame);

/// The triangles of the surface of a value, with normals: means of those of the triangles about a
/// corner, by their areas, which point to lower values. The part of it that all normals of `planes`
/// point to. No points where no voxel reaches the value.
///
/// Each corner of a triangle lies between two neighbouring voxels that count, interpolated
/// linearly. Beside voxels that were not scanned, are range folded or filtered, a surface is open:
/// no wall of it stands there. It is open at the faces of the volume too.
vtkSmartPointer<vtkPolyData> MakeSurface(
  vtkImageData* counting, double value, vtkPlaneCollection* planes);

} // namespace nexrad::scene
