// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Codec/NxvFile.h"
#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/Merging/MemoryNeed.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Merging/TimeMerge.h"

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace nexrad::application
{

/// Files that merged volumes are written to.
enum class VolumeFormat
{
  Nxv,   ///< this project's compressed volumes (Documentation/Formats/nxv.md)
  NetCDF ///< NetCDF that follows the CF conventions (Documentation/Formats/netcdf.md)
};

/// How volumes are written.
struct VolumeFiles
{
  VolumeFormat format = VolumeFormat::Nxv;
  std::optional<NxvEncoding> encoding; ///< of VolumeFormat::Nxv; default: see WriteNxv
  /// Merged volumes of more voxels, by the method beam, are made and written band after band, in
  /// bricks (NxvBandWriter); of VolumeFormat::Nxv.
  std::size_t largestWhole = std::size_t(1) << 27;
  std::string history; ///< of VolumeFormat::NetCDF: the command that makes the volumes
};

/// ".nxv" or ".nc".
const char* ExtensionOf(VolumeFormat format);

/// "20060312T180500Z.nxv"; of one radar alone "KEAX_20060312T180500Z.nxv".
std::filesystem::path VolumeFileName(
  Time time, VolumeFormat format = VolumeFormat::Nxv, const std::string& radar = {});

/// Throws Error when a folder has `.nxv` files, beside those that a run is going to write or
/// replace (`own`, by name), whose grid is not that of the run: together they would look like one
/// series. Files that cannot be read are passed over; so is a folder that does not exist.
void RequireSameGrid(const std::filesystem::path& folder, const std::set<std::string>& own,
  const GridSpecification& grid);

/// All that decides what the volumes of a command contain, beside its inputs, as text: the command,
/// a line for each further word of it, and the settings.
std::string RecipeOf(const std::string& command, const MergeOptions& options);

/// Writes the index of volumes in its folder, by their names.
void WriteVolumeIndex(const std::filesystem::path& path, const std::vector<std::string>& files,
  const std::vector<Time>& times);

/// Whether merged volumes are made and written band after band, in bricks.
bool AreInBricks(const VolumeFiles& files, const MergeOptions& options);

/// Whether the codes of a merge can be written as they are (BeamMergeOptions::codes).
bool AreCodes(const VolumeFiles& files, const MergeOptions& options);

/// Packs each band into the bricks of a file.
TakeBand PackInto(NxvBandWriter& bricks);

/// What becomes of the merged volumes that are written: the one before is there, and what is
/// made of it for its file; of volumes in bricks there is one band.
VolumeUse UseOfWriting(const VolumeFiles& files, const MergeOptions& options);

} // namespace nexrad::application
