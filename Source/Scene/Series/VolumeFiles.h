// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Series/VolumeSeries.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace nexrad::scene
{

/// True when a path names merged volumes: .nxv, .nxv.series, .vti, or a folder that holds .nxv or
/// .vti files.
bool HoldsVolumes(const std::filesystem::path& path);

/// True when all of the paths name merged volumes, false when none does. Throws Error when some do.
bool AreVolumes(const std::vector<std::filesystem::path>& paths);

/// Reads merged volumes from files, from an index of a series, or from folders of them. Throws
/// Error when one of them does not exist or is none.
std::unique_ptr<VolumeSeries> OpenVolumeFiles(const std::vector<std::filesystem::path>& inputs);

} // namespace nexrad::scene
