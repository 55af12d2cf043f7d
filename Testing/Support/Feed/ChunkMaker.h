// SPDX-License-Identifier: BSD-3-Clause
// Volumes cut into the chunks of the real-time feed.
#pragma once

#include "HandMadeVolume.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace nexrad::testing
{

/// One chunk of a volume, with the name that the feed gives it.
struct MadeChunk
{
  std::string name; ///< "20060312-180000-001-S"
  int number = 0;
  char kind = 'I';
  std::vector<std::uint8_t> bytes;
};

/// A hand-made volume of so many sweeps of 360 rays with one reflectivity each, whose sweeps end
/// with the status that the radar sends. It takes four minutes.
RadarVolume VolumeOfSweeps(const Site& site, Time start, int sweeps, double reflectivity);

/// The chunks of a volume: the metadata, then one record of 120 rays each.
std::vector<MadeChunk> CutIntoChunks(const RadarVolume& volume);

/// Writes chunks into a folder, which is made.
void WriteChunks(const std::filesystem::path& folder, const std::vector<MadeChunk>& chunks);

} // namespace nexrad::testing
