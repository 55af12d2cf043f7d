// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Scene/Series/VolumeSeries.h"
#include "nexrad/Merging/MergeOptions.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace nexrad::scene
{

/// Merges radar files and folders of them. Throws Error when no input holds a ray, or none at the
/// times that the options name.
std::unique_ptr<VolumeSeries> OpenRadarFiles(const std::vector<std::filesystem::path>& inputs,
  const MergeOptions& options, const Progress& progress = {});

} // namespace nexrad::scene
