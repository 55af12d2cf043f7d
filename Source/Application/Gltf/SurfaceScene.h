// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gltf/Glb.h"
#include "Scene/SceneOptions.h"

class vtkImageData;

namespace nexrad::scene
{

/// What a binary glTF file shows of a merged volume (Documentation/Formats/gltf.md): the surfaces
/// of the options' iso-values (without any, of those of the preset "iso-values"), over the ground
/// with the lines of the map, rings of range and the radars. Heights are stretched as a scene with
/// these options stretches them. Throws Error as RadarScene::SetVolume does, and for another moment
/// than REF without iso-values.
GlbScene MakeSurfaceScene(vtkImageData* volume, const SceneOptions& options);

} // namespace nexrad::scene
