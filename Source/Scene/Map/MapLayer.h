// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Elements/Label.h"
#include "Scene/Elements/Theme.h"
#include "Scene/Frame/SceneFrame.h"

#include <string>
#include <vector>

namespace nexrad::scene
{

/// What the map shows beside its lines.
struct MapContents
{
  std::vector<std::string> sites; ///< radars
  double ringSpacing = 0.0;       ///< m; rings of range at its multiples up to 230 km; 0: none
  bool names = false;             ///< of states and provinces
};

/// The scene height of a picture that lies on the ground, under the map's lines.
double PictureHeight(const SceneFrame& frame);

/// The scene height of the line of a section, over them.
double SectionHeight(const SceneFrame& frame);

/// What lies on the ground under a volume: a plane, the map's lines cut at the domain's edge, and
/// for each radar that the site table knows a marker, with its name as a label, and rings of range.
/// `textSize` in pixels.
SceneLayer MakeMapLayer(
  const SceneFrame& frame, const MapContents& contents, int textSize, const Theme& theme);

} // namespace nexrad::scene
