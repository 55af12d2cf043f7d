// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/RadarVolume.h"

#include <cstdint>
#include <vector>

namespace nexrad
{

/// One message with its CTM header, as it stands in a Level II file.
using MessageBytes = std::vector<std::uint8_t>;

/// A Level II date (days, 1 on 1970-01-01) and milliseconds after midnight: the inverse of
/// FromLevel2Date. Throws Error before 1970 or after the dates of 16 bits.
struct Level2Date
{
  std::uint32_t days = 1;
  std::uint32_t milliseconds = 0;
};
Level2Date ToLevel2Date(Time time);

/// Puts the 12 bytes of the CTM header and the message header (ICD 2620002, table II) before a
/// body. `frame` pads to 2432 bytes, as all messages but 31 are stored; the size field of message 1
/// counts that frame.
MessageBytes WrapMessage(
  int type, unsigned sequence, Time time, const std::vector<std::uint8_t>& body, bool frame);

/// Bytes that every message except 31 takes.
constexpr std::size_t MessageFrameBytes = 2432;

/// The metadata that begins a file: 134 frames, of which the last hold the mark of a synthetic
/// volume, message 5 and message 2; the others are empty.
std::vector<MessageBytes> WriteMetadata(const RadarVolume& volume, Time start);

/// One ray as message 1 (`sequence` counts the messages, `index` the rays of the sweep, from 0).
/// Throws Error for what message 1 cannot hold.
MessageBytes WriteMessage1(
  const RadarVolume& volume, const Ray& ray, unsigned index, unsigned sequence);

/// One ray as message 31. Throws Error for what it cannot hold, and without a position.
MessageBytes WriteMessage31(
  const RadarVolume& volume, const Sweep& sweep, unsigned index, unsigned sequence);

} // namespace nexrad
