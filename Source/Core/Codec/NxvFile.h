// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"

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
  RadarSteps,        ///< codes of 8 or 16 bits in the radar's own steps (MomentCode.h), deflated
  RunLength,         ///< 7-bit codes, the thesis's stream as it stands
  RunLengthDeflated, ///< the same, deflated
  Float              ///< exact float32 and the states, deflated
};

struct NxvWriteOptions
{
  /// Default: RunLength for REF of the method "thesis", else RadarSteps.
  std::optional<NxvEncoding> encoding;
  /// Write every run from two on, not from six on. Default: true for the method "thesis".
  std::optional<bool> thesisRuns;

  // Of the 7-bit codes.
  double offset = 0.0;   ///< value = offset + scale × code; codes 0…126
  double scale = 1.0;    ///< dBZ a code
  double maximum = 80.0; ///< dBZ; what is above is stored as this. The codes end at 126 as well
};

/// Writes one volume (Documentation/Formats/nxv.md) under a temporary name and renames it. Throws
/// Error when the file cannot be written; nothing half-written stays.
///
/// All codes keep three states: an echo, no echo, not scanned. When a voxel is range folded
/// the states go into the file beside them as an array of their own. Companions follow when the
/// volume has them: numbers and sites as they are; ages and weights in 255 steps, of 1 s and 0.01
/// or as many more (2, 5, 10, … times) as the largest value needs, but exact when Float is asked
/// for.
void WriteNxv(const std::filesystem::path& path, const GriddedVolume& volume,
  const NxvWriteOptions& options = {});

struct NxvReadOptions
{
  std::size_t maximumBytes = std::size_t(4) << 30; ///< what the voxels may take in memory, with
                                                   ///< what the caller makes of them
  std::size_t bytesBesides = 0; ///< that the caller makes of each voxel, as of an image or picture
  std::vector<std::string> leaveOut = {}; ///< names of companion arrays not to read
};

/// Reads one volume. Throws Error naming the file and the byte offset for a wrong magic, header,
/// dimension, length, CRC or stream, and for a companion array of a wrong type or with a value that
/// it cannot have. Arrays beside the moment, its states and its companions are checked and passed
/// over. `memory` is a volume that is no longer needed: its arrays become those of the result.
GriddedVolume ReadNxv(
  const std::filesystem::path& path, const NxvReadOptions& options = {}, GriddedVolume memory = {});

/// Reads the header alone: the same volume without values, states and companions.
GriddedVolume ReadNxvHeader(const std::filesystem::path& path);

/// Names of the companion arrays in the file, as `REF_age`, in the order of the file.
std::vector<std::string> ReadNxvCompanionNames(const std::filesystem::path& path);

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
