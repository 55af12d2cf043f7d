// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gltf/Glb.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/SceneOptions.h"

#include <string>
#include <vector>

namespace nexrad::scene
{

/// What lies on the ground under the surfaces of a volume: a plane, the lines of the map, the line
/// of a section, rings of range, a marker for each radar that the site table knows, and south of
/// the domain the caption and, of simulated data, the word SYNTHETIC. In the colours of the theme;
/// none of it is lit.
std::vector<GlbMesh> MakeGroundMeshes(const SceneFrame& frame, const VolumeInformation& information,
  const SceneOptions& options, const std::string& caption);

} // namespace nexrad::scene
