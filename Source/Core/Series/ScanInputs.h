// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/ScannedFile.h"
#include "nexrad/System/Progress.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace nexrad
{

/// Decodes each input once, a few at a time on as many threads, and says what volumes there are. A
/// file belongs to the site that stands in it, whatever its name. Of two volumes of one site with
/// the same first ray the one with more rays stays. Damage, and what was left out, is in
/// `problems`; `progress` is called from this thread alone. Empty when `progress` asked to stop.
/// Throws Error as FindInputFiles does.
std::optional<SeriesScan> ScanInputs(const std::vector<std::filesystem::path>& inputs,
  const SeriesOptions& options = {}, const VolumeVisitor& visitor = {},
  const Progress& progress = {});

/// Decodes each file and says what it holds, in their order. A file that is gone is left out and
/// named in its problems.
std::optional<std::vector<ScannedFile>> ScanEach(const std::vector<std::filesystem::path>& paths,
  const SeriesOptions& options = {}, const VolumeVisitor& visitor = {},
  const Progress& progress = {});

} // namespace nexrad
