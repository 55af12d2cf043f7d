// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Cutting/CutOptions.h"
#include "Scene/Frame/SceneFrame.h"

#include <vtkSmartPointer.h>

class vtkImageData;
class vtkPlaneCollection;
class vtkVolumeMapper;

namespace nexrad::scene
{

/// Throws Error for a box whose upper bounds are not above the lower ones, for a plane whose normal
/// is 0, and for numbers that are not finite.
void CheckCut(const CutOptions& cut);

/// Throws Error for cuts in another unit than that of the volume's x and y.
void CheckCutUnit(const CutOptions& cut, vtkImageData* volume);

/// The planes of the scene that the box and the plane are. What all their normals point to is left.
vtkSmartPointer<vtkPlaneCollection> CutPlanesOf(const CutOptions& cut, const SceneFrame& frame);

/// Lets the mapper draw the part of the volume that the box and the plane leave.
void CutVolume(vtkVolumeMapper* mapper, const CutOptions& cut, const SceneFrame& frame);

} // namespace nexrad::scene
