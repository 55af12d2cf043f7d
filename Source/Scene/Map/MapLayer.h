// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Map/MapData.h"
#include "Scene/Shapes/Letters.h"
#include "Scene/Shapes/Theme.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkActor;

namespace nexrad::scene
{

/// What the map shows beside its lines.
struct MapContents
{
  std::vector<std::string> sites; ///< radars
  double ringSpacing = 0.0;       ///< m; rings of range at its multiples up to 230 km; 0: none
  bool names = false;             ///< of states and provinces
};

/// Things on the ground are stacked a little above each other, in parts of the frame's width, so
/// that they do not fight for the same depth.
enum class GroundLevel
{
  Ground = -2,  ///< well below the lines: its depth varies within a pixel
  Picture = -1, ///< that lies on the ground
  Counties = 0,
  States = 1,
  Countries = 2,
  Rings = 3,
  Markers = 4,
  Section = 5
};

/// The scene height of what lies on the ground.
double HeightOf(const SceneFrame& frame, GroundLevel level);

/// The level of a line of the map.
GroundLevel LevelOf(MapLineKind kind);

/// Its colour.
const Colour& ColourOf(MapLineKind kind, const Theme& theme);

/// The ground under a volume: a plane with its picture (MakeGroundPicture) as texture.
vtkSmartPointer<vtkActor> MakeGroundActor(const SceneFrame& frame, const Theme& theme);

/// What lies on the ground under a volume: a plane with shaded relief and water, the map's lines
/// cut at the domain's edge (counties on small domains alone), names of towns, and for each radar
/// that the site table knows a marker, with its name as a label, and rings of range. `textSize` in
/// pixels.
SceneLayer MakeMapLayer(
  const SceneFrame& frame, const MapContents& contents, int textSize, const Theme& theme);

} // namespace nexrad::scene
