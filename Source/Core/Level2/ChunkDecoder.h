// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Level2/FileDecoder.h"
#include "nexrad/Level2/VolumeAssembler.h"

#include <cstdint>
#include <string>
#include <vector>

namespace nexrad
{

/// Makes a volume of the chunks of the real-time feed that belong to it, in the order of their
/// numbers.
class ChunkDecoder
{
public:
  explicit ChunkDecoder(const Level2Options& theOptions);

  /// The next chunk, by its number and its file's name. Numbers that lie between it and the chunk
  /// before are damage.
  void Begin(int number, const std::string& name);
  /// The stored bytes of the chunk that began.
  void Decode(std::vector<std::uint8_t> stored);
  /// A chunk in the same folder that belongs to another volume.
  void AddOther(const std::string& name);
  /// Something that is wrong with the chunk that began.
  void AddDamage(const std::string& what) { assembler.AddDamage(0, what); }

  /// The volume of the chunks so far; more may follow. `name` is the path of their folder.
  RadarVolume VolumeSoFar(const std::string& name) const;

private:
  const Level2Options options;
  VolumeAssembler assembler;
  FileDecoder decoder;
  int expected = 1;       ///< number of the next chunk
  std::uint64_t size = 0; ///< bytes of the last chunk
};

} // namespace nexrad
