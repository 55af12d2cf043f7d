// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Grid/GriddedVolume.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::scene
{

/// A map of one value a column, for other programs.
struct GeoMap
{
  GridSpecification grid;         ///< of the volume; its columns are the pixels
  std::vector<float> values;      ///< east fastest, then north
  std::vector<VoxelState> states; ///< where it is not Echo, there is no value
  /// Red, green, blue and opacity of each column, as a picture of the map shows it.
  std::vector<std::array<unsigned char, 4>> colours;
  std::string title; ///< what the values are: "Echo top at 18 dBZ"
  std::string unit;  ///< "m"; may be empty
  Time time{};
  bool synthetic = false; ///< made from simulated files
};

/// The number that pixels without a value have.
constexpr float GeoMapNoValue = -9999.0F;

/// Writes a map as GeoTIFF (OGC 19-008): float32, north up, in the projection of the grid
/// (Documentation/Formats/geotiff.md). Band 1 has the values, band 2 the states; a second page has
/// the colours. The file appears whole or not at all. Throws Error when it cannot be written.
void WriteGeoTiff(const std::filesystem::path& path, const GeoMap& map);

} // namespace nexrad::scene
