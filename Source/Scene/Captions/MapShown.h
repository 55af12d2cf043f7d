// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Captions/EchoShown.h"
#include "Scene/Plan/PlanView.h"
#include "Scene/Scales/ColourScale.h"

#include <string>

class vtkImageData;

namespace nexrad::scene
{

/// The values of a map's columns, and how many of them have a colour of its scale.
EchoShown FindMapShown(const PlanView& view, const ColourScale& scale);

/// What a map that shows nothing, or next to nothing, says: that it has no value above the first
/// of its scale, or none at all, and what there is in the volume that it is of. Empty where
/// something is to be seen.
std::string WordsForMap(const PlanView& view, const PlanOptions& plan, const ColourScale& scale,
  vtkImageData* volume, double biologicalShare, PresetWords presets);

} // namespace nexrad::scene
