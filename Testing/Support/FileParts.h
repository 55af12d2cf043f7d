// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Level2Bytes.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// A Level II file out of its outer container, in the parts that a feed hands on: its LDM records,
/// or groups of messages where it has none.
struct FileParts
{
  Bytes header; ///< the 24 bytes in front
  std::vector<Bytes> parts;

  /// The file of the parts as they are now.
  Bytes Whole() const;
};

/// Cuts a file. `messages` is the size of a group in a file without LDM records.
FileParts CutFile(const std::filesystem::path& path, std::size_t messages);
FileParts CutFile(Bytes stored, std::size_t messages);

/// The same with each record replaced by its decompressed messages: decoding takes a tenth of the
/// time.
FileParts Decompress(const FileParts& file);

/// What can happen to the part at a place of a file; empty where it cannot.
struct ChangedFile
{
  std::string what;
  Bytes bytes;
};

/// Each way in which a feed can spoil the order at one part: it comes again right behind itself,
/// at the end of the file, or before all others; it comes five parts late, or at the end of the
/// file; it is swapped with the next; and a part of another radar stands before it.
std::vector<ChangedFile> ChangeAt(
  const FileParts& file, std::size_t place, const Bytes& foreignPart);

/// What differs first between the rays, the site or the cuts of two volumes; "" when nothing does.
std::string DifferenceOf(const RadarVolume& a, const RadarVolume& b);

} // namespace nexrad::testing
