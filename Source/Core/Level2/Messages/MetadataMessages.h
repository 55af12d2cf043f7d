// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Model/CoveragePattern.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

namespace nexrad
{

/// Reads the body of message 2, what the radar says of itself (ICD 2620002, table IV). Empty when
/// the body is too short.
std::optional<RadarStatus> DecodeMessage2(ByteView body);

/// Reads the body of message 5, the volume coverage pattern (ICD 2620002, table XI). Empty when the
/// message holds none: before 2006 it was sent filled with zeros.
std::optional<CoveragePattern> DecodeMessage5(ByteView body);

/// How a file says that it was simulated: its metadata record holds a console message (type 4 of
/// ICD 2620002, table II) with the text below. Real decoders pass over console messages.
constexpr std::uint8_t SyntheticMarkMessageType = 4;
constexpr std::string_view SyntheticMarkText = "SYNTHETIC vtk-nexrad";

/// True when a message is the mark. `body` is what follows the message header, `size` its bytes: a
/// big-endian halfword with the length of the text, then the text, of which the mark is the
/// beginning.
inline bool IsSyntheticMark(unsigned messageType, const std::uint8_t* body, std::size_t size)
{
  if (messageType != SyntheticMarkMessageType || size < 2 + SyntheticMarkText.size())
  {
    return false;
  }
  const std::size_t length = static_cast<std::size_t>(body[0]) << 8 | body[1];
  return length >= SyntheticMarkText.size() &&
         std::memcmp(body + 2, SyntheticMarkText.data(), SyntheticMarkText.size()) == 0;
}

} // namespace nexrad
