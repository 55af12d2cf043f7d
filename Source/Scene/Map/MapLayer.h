// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/ColourTable.h"
#include "Scene/Frame/SceneFrame.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkProp;

namespace nexrad::scene
{

constexpr Colour groundColour = {0.075, 0.09, 0.11};

/// The scene height of a picture that lies on the ground, under the map's lines.
double PictureHeight(const SceneFrame& frame);

/// What lies on the ground under a volume: a dark plane, the map's lines cut at the domain's edge,
/// and for each radar that the site table knows a marker with its name and rings of range.
/// `ringSpacing` in m: rings at its multiples up to 230 km; 0 draws none. `textSize` in pixels.
std::vector<vtkSmartPointer<vtkProp>> MakeMapLayer(
  const SceneFrame& frame, const std::vector<std::string>& sites, double ringSpacing, int textSize);

} // namespace nexrad::scene
