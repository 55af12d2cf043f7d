// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/GriddedVolume.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// How REF is stored in a volume file.
enum class NxvEncoding
{
  RunLength,         ///< 7-bit codes, the thesis's stream as it stands
  RunLengthDeflated, ///< the same, deflated
  Float              ///< exact float32 and the states, deflated
};

struct NxvWriteOptions
{
  NxvEncoding encoding = NxvEncoding::RunLength;
  bool thesisRuns = false; ///< write every run from two on (default for the method "thesis")
  double offset = 0.0;     ///< value = offset + scale × code; codes 0…126
  double scale = 1.0;      ///< dBZ a code
};

/// Writes one volume (Documentation/Formats/nxv.md) under a temporary name and renames it. Throws
/// Error when the file cannot be written; nothing half-written stays.
void WriteNxv(const std::filesystem::path& path, const GriddedVolume& volume,
  const NxvWriteOptions& options = {});

/// Reads one volume. Throws Error naming the file and the byte offset for a wrong magic, header,
/// dimension, length, CRC or stream. `maximumBytes` bounds what the voxels may take in memory.
GriddedVolume ReadNxv(
  const std::filesystem::path& path, std::size_t maximumBytes = std::size_t(4) << 30);

/// Reads the header alone: the same volume without values and states.
GriddedVolume ReadNxvHeader(const std::filesystem::path& path);

/// The index of a series: file names relative to the index, with their times. JSON, the form
/// ParaView uses
/// ("file-series-version", "files": [{"name", "time"}]), time in seconds since 1970-01-01 UTC.
using NxvSeries = std::vector<std::pair<std::string, double>>;
void WriteNxvSeries(const std::filesystem::path& path, const NxvSeries& series);
NxvSeries ReadNxvSeries(const std::filesystem::path& path);

} // namespace nexrad
