// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/VolumeSeries.h"
#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Model/Moment.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

/// True when all of the paths name merged volumes (.nxv, .nxv.series, .vti, or a folder that holds
/// .nxv or .vti files), false when none does. Throws Error when some do.
bool AreVolumes(const std::vector<std::filesystem::path>& paths);

/// What of volume files is read.
struct VolumeFileRequest
{
  static constexpr std::size_t UsualMemory = std::size_t(256) << 20;
  std::vector<MomentName> moments;         ///< the first is shown; empty: the file's first one
  std::optional<MomentName> colours;       ///< read beside them
  bool all = false;                        ///< read the file's other moments as well
  PlaceUnit boxUnit = PlaceUnit::OfVolume; ///< of the faces of boxes
  bool allVoxels = false; ///< Load reads the smallest voxels, whatever memory they take
  bool fewVoxels = false; ///< of a file in bricks Load reads the largest voxels
  std::size_t textureMemory = UsualMemory; ///< bytes that a picture may take of it
};

/// Reads merged volumes from files, from an index of a series, or from folders of them. Of a file
/// that has its volume in voxels of several sizes, Load reads the smallest ones that fit in a
/// quarter of the texture memory, with at most 2048 voxels along each axis; LoadBox those that fit
/// in the rest. Of codes LoadBox counts only bricks whose voxels differ, but reads at most twice as
/// many as bytes. Throws Error when an input does not exist or is none; Load, for a moment that a
/// file does not have; LoadBox, for a box that moves or lies beside the volume, and for a file
/// whose finest voxels Load reads.
std::unique_ptr<VolumeSeries> OpenVolumeFiles(const std::vector<std::filesystem::path>& inputs,
  const VolumeFileRequest& request = {{}, {}, true});

} // namespace nexrad
