// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/Message2.h"

#include <cstdlib>

namespace nexrad
{

std::optional<RadarStatus> DecodeMessage2(ByteView body)
{
  constexpr std::size_t usedBytes = 20;
  if (!body.Has(0, usedBytes))
  {
    return std::nullopt;
  }
  RadarStatus status;
  // Negative when the pattern was chosen at the radar.
  status.coveragePatternNumber = std::abs(int(body.I16(14)));
  // Hundredths since build 11; tenths before, when that gives no build below 2.
  const double build = body.U16(18);
  status.softwareBuild = build / 100.0 > 2.0 ? build / 100.0 : build / 10.0;
  return status;
}

} // namespace nexrad
