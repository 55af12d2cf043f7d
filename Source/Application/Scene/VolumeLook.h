// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "SceneOptions.h"

#include <vtkSmartPointer.h>

class vtkVolumeMapper;
class vtkVolumeProperty;

namespace nexrad::scene
{

/// A mapper of that kind. `slices`: number of slices, or of samples along the longest ray through
/// the volume, whose length is `diagonal` in scene units.
vtkSmartPointer<vtkVolumeMapper> MakeVolumeMapper(MapperChoice choice, int slices, double diagonal);

/// Colours from the table, and an opacity that grows with the reflectivity: weak echo is a veil,
/// cores are dense. Nothing shows below the table's first value.
vtkSmartPointer<vtkVolumeProperty> MakeVolumeProperty(const ColourTable& table);

} // namespace nexrad::scene
