// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/Label.h"
#include "Scene/Elements/Theme.h"
#include "Scene/Frame/SceneFrame.h"
#include "nexrad/Products/VerticalSection.h"

namespace nexrad::scene
{

/// The line of a section on the ground, with discs at its ends, and their names A and B. `height`:
/// of the ground in the scene.
SceneLayer MakeSectionMark(const SectionLine& line, const SceneFrame& frame, double height,
  int textSize, const Theme& theme);

} // namespace nexrad::scene
