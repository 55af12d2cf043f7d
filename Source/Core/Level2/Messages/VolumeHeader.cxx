// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/VolumeHeader.h"

#include <algorithm>

namespace nexrad
{

bool IsVolumeHeader(ByteView stream, std::size_t offset)
{
  // The first letter alone answers for most bytes of a damaged stream, each of which is asked.
  return stream.Has(offset, VolumeHeader::bytes) && stream.U8(offset) == 'A' &&
         (stream.StartsWith("ARCHIVE2.", offset) ||
           (stream.StartsWith("AR2V00", offset) && stream.U8(offset + 8) == '.'));
}

std::string ParseSiteName(ByteView stream, std::size_t offset)
{
  const ByteView letters = stream.Sub(offset, 4);
  const std::string name(letters.Data(), letters.Data() + letters.Size());
  const bool plausible =
    name.size() == 4 && name.front() >= 'A' && name.front() <= 'Z' &&
    std::all_of(name.begin(), name.end(),
      [](char letter)
      { return (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9'); });
  return plausible ? name : std::string();
}

std::optional<VolumeHeader> ParseVolumeHeader(ByteView stream)
{
  if (!IsVolumeHeader(stream, 0))
  {
    return std::nullopt;
  }
  VolumeHeader header;
  const std::uint32_t days = stream.U32(12);
  // Day 1, the first of January 1970, is what a clock that was never set says.
  if (days > 1 && days <= 40'000)
  {
    header.time = FromLevel2Date(days, stream.U32(16));
  }
  header.siteName = ParseSiteName(stream, 20);
  return header;
}

} // namespace nexrad
