// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

#include <filesystem>

namespace nexrad::application
{

/// Writes a volume as VTK XML image data. The file appears whole or not at all. Throws Error when
/// it cannot be written.
void WriteVti(const std::filesystem::path& path, const GriddedVolume& volume);

/// The grid of such a file. Throws Error when it cannot be read.
GridSpecification ReadVtiGrid(const std::filesystem::path& path);

} // namespace nexrad::application
