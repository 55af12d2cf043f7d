// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Grid/GridSpecification.h"
#include "nexrad/Merging/MergeOptions.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Series/InputFiles.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace nexrad
{

/// What becomes of merged volumes, beside the one that is being made.
struct VolumeUse
{
  std::size_t others = 0;      ///< merged volumes of other times that are there at the same time
  std::size_t bytesAVoxel = 0; ///< that are made of one volume, of all its moments together
  int rows = 0;                ///< of the grid that are there at a time; 0: all
  std::size_t libraries = 0;   ///< bytes of the libraries that write them
};

/// The most memory that a run of merges has at a time, by what it is for, bytes. An estimate from
/// the sizes of the buffers. A run takes no more, but where one file, which counts as one time,
/// holds several volumes; it takes up to a fifth less, and 50 MiB less where it takes little.
struct MemoryNeed
{
  std::size_t voxels = 0;   ///< merged volumes, and what is made of them
  std::size_t geometry = 0; ///< columns of the grid as seen from the radars
  std::size_t rays = 0;     ///< files that are decoded, and volumes made ready; not kept ones
  std::size_t means = 0;    ///< of these volumes' gates, for voxels coarser than gates
  std::size_t program = 0;  ///< the program and its libraries

  std::size_t Total() const { return voxels + geometry + rays + means + program; }
};

/// Bytes of each voxel of a merged volume of all moments, with what the options add to it.
std::size_t BytesOfAVoxel(const MergeOptions& options);

/// What is known of the input files before any of them is decoded.
struct InputSizes
{
  std::size_t radars = 1; ///< or fewer than there are, where headers do not tell
  std::size_t files = 1;
  std::size_t fileBytes = 0; ///< of the file in the middle, by size, as in records of bzip2
};

/// The sizes of files; a chunk folder counts as no file. Reads directories, and the start of one
/// file.
InputSizes SizesOf(const std::vector<std::filesystem::path>& paths, std::size_t radars);

/// Where the radars stand that headers name; empty where the site table lacks one, or there are no
/// headers.
std::vector<Position> KnownPlaces(const std::optional<FilesByRadar>& headers);

/// The need of merges with these options for a grid of these dimensions. `threads` decode files.
/// Without `geometry` and `means`, which depend on where the radars are.
MemoryNeed NeedOf(const MergeOptions& options, const std::array<int, 3>& dimensions,
  const InputSizes& inputs, unsigned threads, const VolumeUse& use);

/// The same with these, of radars at these `places`, as far as they are known. Throws Error
/// when it is above the limit of the options: how much is needed, which dimensions of the same
/// proportions fit, and which limit does.
MemoryNeed RequireMemory(const MergeOptions& options, const InputSizes& inputs, unsigned threads,
  const VolumeUse& use, const std::vector<Position>& places = {});

/// The same once the grid and the radars are known.
MemoryNeed RequireMemory(const MergeOptions& options, const InputSizes& inputs, unsigned threads,
  const VolumeUse& use, const GridSpecification& grid, const std::vector<Position>& radars);

/// Level2Options::freeBytes where `threads` files are decoded at a time: small files that hold much
/// take no more than half of the limit of the options.
std::size_t FreeBytesOfAFile(const MergeOptions& options, unsigned threads);

/// Bytes for rays that are kept for later steps (MergeOptions::memory), as far as the limit leaves
/// them.
std::size_t MemoryForKeptRays(const MergeOptions& options, const MemoryNeed& need);

} // namespace nexrad
