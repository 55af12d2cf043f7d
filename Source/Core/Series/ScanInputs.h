// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/ScannedFile.h"
#include "nexrad/System/Processes.h"
#include "nexrad/System/Progress.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
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

/// What the files that one of several processes scans have in common.
enum class ScanOrder
{
  ByTime,      ///< neighbouring times
  ByLongitude, ///< neighbouring sites from west to east, and their times
  ByLatitude   ///< neighbouring sites from south to north, and their times
};

/// Places in a list of files, in the order of the radars and times in their headers.
std::vector<std::size_t> OrderByHeaders(
  const std::vector<std::filesystem::path>& paths, ScanOrder order);

/// What a process finds in some of the files, by their places in a list; empty when it was asked to
/// stop.
using FileFinder =
  std::function<std::optional<std::vector<ScannedFile>>(const std::vector<std::size_t>& places)>;

/// What files hold, found by several processes, which all call it with the same files. Each finds
/// it of a part of neighbouring times or sites by what the files' headers say. All get the same
/// result: empty when one of them was asked to stop. Throws Error everywhere when one of them
/// fails.
std::optional<std::vector<ScannedFile>> FindTogether(
  const std::vector<std::filesystem::path>& paths, const Processes& processes, ScanOrder order,
  const FileFinder& find);

/// ScanEach by several processes (FindTogether): each finds most volumes of its part of the day, or
/// of the country, among those that it visited.
std::optional<std::vector<ScannedFile>> ScanTogether(
  const std::vector<std::filesystem::path>& paths, const Processes& processes, ScanOrder order,
  const SeriesOptions& options = {}, const VolumeVisitor& visitor = {},
  const Progress& progress = {});

/// What a process tells the others of the files that it scanned, as bytes.
std::string PackScannedFiles(const std::vector<ScannedFile>& files);

/// The same back again. Throws Error when the bytes are none of PackScannedFiles.
std::vector<ScannedFile> UnpackScannedFiles(const std::string& bytes);

} // namespace nexrad
