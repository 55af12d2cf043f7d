// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/GriddedVolume.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

namespace nexrad::testing
{

/// A small merged volume over eastern Missouri as the project's filters make them: 48 × 48 × 16
/// voxels of 10 km × 10 km × 1.25 km with a storm of 62 dBZ that stands 15 km high in the south
/// west quarter, and the sites KLSX and KILX. Marked as synthetic when asked.
GriddedVolume MakeStorm(bool synthetic);
vtkSmartPointer<vtkImageData> MakeStormVolume(bool synthetic);

} // namespace nexrad::testing
