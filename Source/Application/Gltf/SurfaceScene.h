// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/SceneOptions.h"

#include <filesystem>

class vtkImageData;

namespace nexrad::scene
{

/// Writes the surfaces of a merged volume as binary glTF (Documentation/Formats/gltf.md): those of
/// the options' iso-values (without any, of those of the preset "iso-values"), over the ground with
/// the lines of the map, rings of range and the radars. Heights are stretched as a scene with these
/// options stretches them. Draws nothing, and needs no display. Throws Error for what a scene
/// cannot show, for another moment than REF without iso-values, and when the file cannot be
/// written.
void WriteSurfaces(
  const std::filesystem::path& path, vtkImageData* volume, const SceneOptions& options);

} // namespace nexrad::scene
