// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Pointing/ViewRay.h"
#include "Scene/Pointing/VoxelReader.h"

#include <optional>

class vtkNexradTransferFunction;

namespace nexrad::scene
{

/// The echo that a ray shows.
struct SeenEcho
{
  double distance = 0.0; ///< along the ray, in scene units
  double value = 0.0;    ///< there, in the unit of the moment
};

/// The place of the ray in front of which half of what is seen along it lies: half of the opacity
/// of the whole ray. Nothing when the ray's opacity is below `leastVisible`. (vtkVolumePicker finds
/// the first place whose opacity exceeds a threshold, however thin the echo is, and knows no
/// codes.)
///
/// `detail`: a finer volume that is drawn in place of a part of `voxels`; nullptr for none.
///
/// Samples lie half a voxel apart. Surfaces count at the iso-values that lie between two samples.
std::optional<SeenEcho> FindEcho(const VoxelReader& voxels, const VoxelReader* detail,
  const SceneFrame& frame, vtkNexradTransferFunction* transferFunction, const ViewRay& ray);

/// The least opacity of a ray that shows echo: less is hardly seen.
constexpr double leastVisible = 0.1;

} // namespace nexrad::scene
