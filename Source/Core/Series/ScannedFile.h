// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/SiteSeries.h"

#include <filesystem>
#include <utility>
#include <vector>

namespace nexrad
{

/// What one input file holds.
struct ScannedFile
{
  std::vector<std::pair<Site, SeriesVolume>> volumes;
  std::vector<InputProblem> problems;
};

/// Decodes one file and says what it holds; what is wrong goes to the problems.
ScannedFile ScanFile(
  const std::filesystem::path& path, const SeriesOptions& options, const VolumeVisitor& visitor);

/// The order of a site's volumes: by their first rays; of two that share it the one that stays,
/// with more rays, first.
bool IsBefore(const SeriesVolume& a, const SeriesVolume& b);

/// Puts what the files hold together by sites. `problems` are those known before.
SeriesScan CollectSeries(std::vector<InputProblem> problems, const std::vector<ScannedFile>& files);

} // namespace nexrad
