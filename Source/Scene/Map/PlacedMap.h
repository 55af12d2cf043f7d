// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Map/MapData.h"
#include "nexrad/Grid/MakeGrid.h"

#include <array>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// A line on the ground: x and y of its points in the scene.
using GroundLine = std::vector<std::array<double, 2>>;

/// The west, east, south and north edge of the domain in the scene.
std::array<double, 4> Rectangle(const SceneFrame& frame);

/// Whether a place lies in a rectangle (west, east, south, north).
bool IsWithin(const std::array<double, 2>& place, const std::array<double, 4>& rectangle);

/// The parts of a line that lie over a rectangle (west, east, south, north).
std::vector<GroundLine> ClipLine(const GroundLine& line, const std::array<double, 4>& rectangle);

/// Longitudes and latitudes that the domain can touch, and some more. Needs HasMap.
GeographicBounds ReachOf(const SceneFrame& frame);

/// The parts of the map's lines (EmbeddedMapLines) that lie over the domain, indexed by
/// MapLineKind. None where the frame has no map.
std::array<std::vector<GroundLine>, 3> PlaceMapLines(const SceneFrame& frame);

/// Whether counties are drawn: only where the domain is small enough to tell them apart.
bool ShowsCounties(const SceneFrame& frame);

/// A radar on the ground.
struct PlacedSite
{
  std::string name;
  std::array<double, 2> place{}; ///< x and y in the scene
  bool within = false;           ///< whether it lies in the domain
  double spread = 0.0;           ///< as of its Label
};

/// Those of the radars that the site table knows. None where the frame has no map. Where there are
/// many, the first for spread is the nearest to the middle of the domain, and each next one the
/// farthest from all before it: so radars with a spread longer than some length are farther apart
/// than that.
std::vector<PlacedSite> PlaceSites(const SceneFrame& frame, const std::vector<std::string>& sites);

/// Rings of range about a radar at a place of the scene: circles at the multiples of `spacing` in m
/// up to 230 km. None where the spacing is 0. They may leave the domain.
std::vector<GroundLine> PlaceRings(const std::array<double, 2>& place, double spacing);

} // namespace nexrad::scene
