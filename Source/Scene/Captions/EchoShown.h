// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Plan/PlanView.h"
#include "Scene/Scales/ColourScale.h"

#include <array>
#include <optional>
#include <string>

class vtkImageData;
class vtkNexradTransferFunction;

namespace nexrad::scene
{

/// What a picture of a volume that shows nothing, or next to nothing, says: that there is no echo
/// above the value from which it is shown (nothing where no such value is), and what there is;
/// empty where something is to be seen. `box`: the part that is shown, west, east, south, north,
/// bottom and top in the units of the volume; empty: all. `look`: its colours and opacities.
/// `biologicalShare`: of the echo, 0…1. `namesOptions`: presets are named as options of the
/// program, else as settings.
std::string WordsForNothing(vtkImageData* volume, const std::optional<std::array<double, 6>>& box,
  vtkNexradTransferFunction* look, double biologicalShare, bool namesOptions);

/// What a map that shows nothing, or next to nothing, says: that it has no value above the first
/// of its scale, or none at all, and what there is in the volume that it is of. Empty where
/// something is to be seen.
std::string WordsForMap(const PlanView& view, const PlanOptions& plan, const ColourScale& scale,
  vtkImageData* volume, double biologicalShare, bool namesOptions);

} // namespace nexrad::scene
