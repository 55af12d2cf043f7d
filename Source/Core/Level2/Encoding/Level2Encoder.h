// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// How the messages of a file are packed.
enum class Level2Container
{
  Bare,    ///< volume header, then messages
  Gzip,    ///< Bare inside gzip
  LdmBzip2 ///< volume header, then bzip2 records behind four-byte lengths: one of metadata, then
           ///< records of 100 rays (message 1) or 120 (message 31); the last length is negative
};

struct Level2EncoderOptions
{
  int messageType = 1; ///< 1 (REF, VEL, SW; 8 bits; no position) or 31 (all moments)
  Level2Container container = Level2Container::LdmBzip2;
  int volumeNumber = 1; ///< extension in the volume header, 1…999
};

/// Writes a volume as a Level II file (ICD 2620002 and 2620010): volume header, metadata with
/// message 5 and message 2 (and the mark of a synthetic volume, IsSyntheticMark), then the rays.
/// What DecodeLevel2 reads back has the same rays, words, times (to the millisecond) and angles (to
/// the resolution of the message type). Throws Error when the message type cannot hold the volume
/// (a moment, a word size, too many gates, a date, for message 31 a missing position), or an option
/// is out of range.
std::vector<std::uint8_t> EncodeLevel2(
  const RadarVolume& volume, const Level2EncoderOptions& options = {});

} // namespace nexrad
