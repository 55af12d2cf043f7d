// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Model/Time.h"

#include <cstddef>
#include <optional>
#include <string>

namespace nexrad
{

/// The first 24 bytes of a Level II file (ICD 2620010, section 7.3.3).
struct VolumeHeader
{
  static constexpr std::size_t bytes = 24;

  std::optional<Time> time; ///< empty when the header has no date
  std::string siteName;     ///< "" when it is blank
};

/// True when a volume header stands at the offset.
bool IsVolumeHeader(ByteView stream, std::size_t offset);

/// Reads the header at the start; empty when there is none.
std::optional<VolumeHeader> ParseVolumeHeader(ByteView stream);

/// The four bytes of an identifier of a radar as text; "" when they are no such name.
std::string ParseSiteName(ByteView stream, std::size_t offset);

} // namespace nexrad
