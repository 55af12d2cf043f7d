// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Time.h"

#include <cstddef>
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

} // namespace nexrad
