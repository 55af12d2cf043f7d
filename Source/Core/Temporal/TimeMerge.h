// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/GriddedVolume.h"
#include "Gridding/PolarVolume.h"
#include "Model/Progress.h"
#include "Temporal/PolarCache.h"
#include "Temporal/SiteSeries.h"

#include <optional>
#include <string_view>
#include <vector>

namespace nexrad
{

/// How rays become voxels.
enum class MergeMethod
{
  Thesis ///< Formulas T1–T7
};

/// "thesis".
const char* ToString(MergeMethod method);
/// Empty when the text names no method.
std::optional<MergeMethod> ParseMergeMethod(std::string_view text);

/// One merged volume that is asked for.
struct MergeRequest
{
  GridSpecification grid;
  Time time{};
  Duration maximumGap = std::chrono::minutes(15); ///< a volume that starts farther from `time` does
                                                  ///< not count
  MergeMethod method = MergeMethod::Thesis;
};

/// Merges volumes of any number of sites, in any order: for each site those just before (or at) and
/// just after the time. A site with none in reach takes no part; without any, no voxel is scanned.
/// Empty when `progress` asked to stop. Throws Error as the method does.
std::optional<GriddedVolume> MergeVolumes(const std::vector<const PolarVolume*>& volumes,
  const MergeRequest& request, const Progress& progress = {});

/// The same for a scanned series: only the volumes about the time are brought into memory.
std::optional<GriddedVolume> MergeSeries(const SeriesScan& scan, PolarCache& cache,
  const MergeRequest& request, const Progress& progress = {});

} // namespace nexrad
