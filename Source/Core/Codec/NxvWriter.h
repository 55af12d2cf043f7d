// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GriddedVolume.h"
#include "nexrad/System/RangeLoop.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace nexrad
{

/// How the moment is stored in a volume file.
enum class NxvEncoding
{
  RadarSteps, ///< codes of 8 or 16 bits in the radar's own steps (MomentCode.h), deflated
  Thesis,     ///< the thesis's codes of 7 bits and run lengths (ThesisStream.h), of REF alone
  Float       ///< exact float32 and the states, deflated
};

/// Writes one volume, with its further moments (Documentation/Formats/nxv.md), under a temporary
/// name and renames it. Encoded by default as Thesis for REF of the method "thesis", else as
/// RadarSteps; further moments are RadarSteps or Float. Throws Error when the file cannot be
/// written; nothing half-written stays.
///
/// All codes keep three states: an echo, no echo, not scanned. When a voxel is range folded
/// the states go into the file beside them as an array of their own; when one is filtered, an array
/// that says which are. AncillaryArrays follow when the volume has them: numbers and sites as they
/// are; ages and weights in 255 steps, of 1 s and 0.01 or as many more (2, 5, 10, … times) as the
/// largest value needs, but exact when Float is asked for.
void WriteNxv(const std::filesystem::path& path, const GriddedVolume& volume,
  std::optional<NxvEncoding> encoding = {});

/// Writes one volume in bricks (Documentation/Formats/nxv.md) from bands of its rows, of which one
/// alone is there at a time. A brick of voxels that are alike takes eight bytes before these are
/// compressed. Memory and file grow with what the volume holds, not with the grid. The volume in
/// larger voxels follows (CoarserLevels).
///
/// Codes are those of WriteNxv, but velocities always have two bytes, and ages and weights are
/// exact. Not for NxvEncoding::Thesis.
class NxvBandWriter
{
public:
  /// `grid` is that of the whole volume.
  NxvBandWriter(const std::filesystem::path& path, const GridSpecification& grid,
    std::optional<NxvEncoding> encoding = {});
  /// Of some rows of the grid alone, which one of several processes makes: from a multiple of
  /// PartRows to another one, or to the last row. The file serves AddPart alone.
  NxvBandWriter(const std::filesystem::path& path, const GridSpecification& grid,
    const VoxelBlock& rows, std::optional<NxvEncoding> encoding = {});
  ~NxvBandWriter();
  NxvBandWriter(const NxvBandWriter&) = delete;
  NxvBandWriter& operator=(const NxvBandWriter&) = delete;

  /// Rows of each band but the last, which has what is left.
  static constexpr int Rows = 64;
  /// Rows that a band of the next level stands for.
  static constexpr int PartRows = 2 * Rows;

  /// Packs the next band: its grid is that part of the whole. `loop` packs several bricks at a
  /// time. Throws Error as WriteNxv does.
  void Add(const GriddedVolume& band, const RangeLoop& loop = {});
  /// The same of the bands that the next part holds: the file becomes what Add would make of them,
  /// byte for byte. Throws Error also for a part that cannot be read or does not follow.
  void AddPart(const std::filesystem::path& part, const RangeLoop& loop = {});

  /// Writes the file, after the last band. Throws Error when it cannot be written.
  void Commit();

private:
  struct Impl;
  std::unique_ptr<Impl> impl;
};

} // namespace nexrad
