// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Filters/Series/VolumeSeries.h"
#include "nexrad/Model/Moment.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace nexrad
{

/// True when a path names merged volumes: .nxv, .nxv.series, .vti, or a folder that holds .nxv or
/// .vti files.
bool HoldsVolumes(const std::filesystem::path& path);

/// True when all of the paths name merged volumes, false when none does. Throws Error when some do.
bool AreVolumes(const std::vector<std::filesystem::path>& paths);

/// Which moments of volume files are read, where a file has several.
struct MomentRequest
{
  std::vector<MomentName> moments;   ///< the first is shown; empty: the file's first one
  std::optional<MomentName> colours; ///< read beside them
  bool all = false;                  ///< read the file's other moments as well
};

/// Reads merged volumes from files, from an index of a series, or from folders of them. Throws
/// Error when one of them does not exist or is none; Load, for a moment that a file does not have.
std::unique_ptr<VolumeSeries> OpenVolumeFiles(
  const std::vector<std::filesystem::path>& inputs, const MomentRequest& request = {{}, {}, true});

} // namespace nexrad
