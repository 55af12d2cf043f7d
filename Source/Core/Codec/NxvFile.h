// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Gridding/GriddedVolume.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace nexrad
{

/// How the moment is stored in a volume file.
enum class NxvEncoding
{
  RunLength,         ///< 7-bit codes, the thesis's stream as it stands
  RunLengthDeflated, ///< the same, deflated
  Float              ///< exact float32 and the states, deflated
};

struct NxvWriteOptions
{
  /// Default: RunLength for REF, Float for the other moments, whose values the default codes do not
  /// fit.
  std::optional<NxvEncoding> encoding;
  /// Write every run from two on, not from six on. Default: true for the method "thesis".
  std::optional<bool> thesisRuns;
  double offset = 0.0;   ///< value = offset + scale × code; codes 0…126
  double scale = 1.0;    ///< dBZ a code
  double maximum = 80.0; ///< dBZ; what is above is stored as this. The codes end at 126 as well
};

/// Writes one volume (Documentation/Formats/nxv.md) under a temporary name and renames it. Throws
/// Error when the file cannot be written; nothing half-written stays.
///
/// The 7-bit codes keep three states: an echo, no echo, not scanned. When a voxel is range folded
/// the states go into the file beside them as an array of their own.
void WriteNxv(const std::filesystem::path& path, const GriddedVolume& volume,
  const NxvWriteOptions& options = {});

/// Reads one volume. Throws Error naming the file and the byte offset for a wrong magic, header,
/// dimension, length, CRC or stream. `maximumBytes` bounds what the voxels may take in memory.
/// Arrays beside the moment and its states are checked and passed over.
GriddedVolume ReadNxv(
  const std::filesystem::path& path, std::size_t maximumBytes = std::size_t(4) << 30);

/// Reads the header alone: the same volume without values and states.
GriddedVolume ReadNxvHeader(const std::filesystem::path& path);

/// Writes the moment's bare run-length stream (Formulas T8), without any header. `encoding` of the
/// options has no effect. Range folded becomes no echo.
void WriteRaw(const std::filesystem::path& path, const GriddedVolume& volume,
  const NxvWriteOptions& options = {});

/// Reads a bare stream. What it does not hold (grid, time, fill, …) comes from `description`,
/// offset and scale from the options. Throws Error for a stream that does not give exactly the
/// grid's voxels, or a grid larger than `maximumBytes`.
GriddedVolume ReadRaw(const std::filesystem::path& path, GriddedVolume description,
  const NxvWriteOptions& options = {}, std::size_t maximumBytes = std::size_t(4) << 30);

/// The index of a series: file names relative to the index, with their times. JSON, the form
/// ParaView uses
/// ("file-series-version", "files": [{"name", "time"}]), time in seconds since 1970-01-01 UTC.
using NxvSeries = std::vector<std::pair<std::string, double>>;
/// Writes an index under a temporary name and renames it. Throws Error when it cannot.
void WriteNxvSeries(const std::filesystem::path& path, const NxvSeries& series);
/// Reads an index, in the order of the file. Throws Error for a file that is none.
NxvSeries ReadNxvSeries(const std::filesystem::path& path);

} // namespace nexrad
