// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// The index of a series: file names relative to the index, with their times. JSON, the form
/// ParaView uses
/// ("file-series-version", "files": [{"name", "time"}]), time in seconds since 1970-01-01 UTC.
using NxvSeries = std::vector<std::pair<std::string, double>>;
/// Writes an index under a temporary name and renames it. Throws Error when it cannot.
void WriteNxvSeries(const std::filesystem::path& path, const NxvSeries& series);
/// Reads an index, in the order of the file. Throws Error for a file that is none.
NxvSeries ReadNxvSeries(const std::filesystem::path& path);

} // namespace nexrad
