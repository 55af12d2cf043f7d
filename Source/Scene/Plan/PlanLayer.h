// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/Theme.h"
#include "Scene/Plan/PlanView.h"
#include "Scene/Scales/ColourScale.h"

#include <vtkSmartPointer.h>

#include <utility>

class vtkImageData;
class vtkProp;

namespace nexrad::scene
{

/// The states of places that were not measured, and what a key says of their colours.
constexpr std::pair<VoxelState, const char*> StateTexts[] = {
  {VoxelState::NotScanned, "grey: not scanned"}, {VoxelState::RangeFolded, "violet: range folded"},
  {VoxelState::Filtered, "brown: filtered"}};

/// A plan view in the colours of a scale, lying on the ground at the scene height `height`: each
/// column of voxels a rectangle of one colour. Where there is no echo, or less than the scale's
/// first value, the ground is seen. `placed` is the volume as the scene has it (SceneFrame).
vtkSmartPointer<vtkProp> MakePlanLayer(const PlanView& view, const ColourScale& scale,
  vtkImageData* placed, double height, const Theme& theme);

/// What the colours without a value mean, for a caption; empty when there are none.
std::string PlanKey(const PlanView& view, const ColourScale& scale);

} // namespace nexrad::scene
