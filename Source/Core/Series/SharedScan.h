// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Series/ScannedFile.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace nexrad
{

/// Scans the files of this process. Empty when it was asked to stop.
using FileScanner =
  std::function<std::optional<std::vector<ScannedFile>>(const std::vector<std::filesystem::path>&)>;

/// Scans `paths` by several processes, each a part of neighbouring times or sites by what the
/// files' headers say, and gives each of them all files in the order of `paths`. Empty everywhere
/// when one process was asked to stop. Throws Error everywhere when one of them fails.
std::optional<std::vector<ScannedFile>> ScanTogether(
  const std::vector<std::filesystem::path>& paths, const Processes& processes, ScanOrder order,
  const FileScanner& scan);

/// What a process tells the others of the files that it scanned, as bytes.
std::string PackScannedFiles(const std::vector<ScannedFile>& files);

/// The same back again. Throws Error when the bytes are none of PackScannedFiles.
std::vector<ScannedFile> UnpackScannedFiles(const std::string& bytes);

} // namespace nexrad
