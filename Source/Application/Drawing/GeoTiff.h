// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/SceneOptions.h"

#include <filesystem>

class vtkImageData;

namespace nexrad::scene
{

/// Writes the map of a volume that the options ask for as GeoTIFF (OGC 19-008): float32, north up,
/// in the projection of the grid (Documentation/Formats/geotiff.md). Band 1 has the values, band 2
/// the states; a second page has the colours. Draws nothing, and needs no display. The file appears
/// whole or not at all. Throws Error when it cannot be written.
void WriteGeoTiff(
  const std::filesystem::path& path, vtkImageData* volume, const SceneOptions& options);

} // namespace nexrad::scene
