// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Plan/PlanView.h"
#include "Scene/Scales/ColourScale.h"
#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkProp;

namespace nexrad::scene
{

/// The scale of a plan: of echo tops in km, of liquid in kg/m² and of its density in g/m³ one that
/// is the same for all volumes, else that for the map of its array.
ColourScale ScaleFor(const PlanView& view, const PlanOptions& plan,
  const std::vector<std::string>& sites, const ColourScale& moment);

/// The scale for one of a volume's arrays: for the moment, its own; for an ancillary array, one
/// that reaches to the largest value: age in minutes, weight, a colour for each number of radars
/// and for each of the volume's sites.
ColourScale ScaleFor(double largest, const std::string& array,
  const std::vector<std::string>& sites, const ColourScale& moment);

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
