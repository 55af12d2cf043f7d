// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Messages/MetadataMessages.h"

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

namespace
{

constexpr std::size_t patternHeaderBytes = 22;
constexpr std::size_t cutBytes = 46;
constexpr double degreesPerAngleCode = 180.0 / 32768.0;
constexpr double rateOfHighestBit = 22.5; // degrees a second, bit 14; bit 15 is the sign
constexpr double ratePerCode = rateOfHighestBit / 16384.0;
constexpr unsigned halfDegreeAzimuths = 1;

CoverageCut DecodeCut(ByteView cut)
{
  CoverageCut result;
  const double angle = cut.U16(0) * degreesPerAngleCode;
  result.elevation = angle > 180.0 ? angle - 360.0 : angle;
  const unsigned waveform = cut.U8(3);
  result.waveform = waveform <= static_cast<unsigned>(Waveform::StaggeredPulsePair)
                      ? static_cast<Waveform>(waveform)
                      : Waveform::Unknown;
  result.superResolution = (cut.U8(4) & halfDegreeAzimuths) != 0;
  result.azimuthRate = cut.I16(8) * ratePerCode;
  return result;
}

} // namespace

std::optional<CoveragePattern> DecodeMessage5(ByteView body)
{
  if (!body.Has(0, patternHeaderBytes))
  {
    return std::nullopt;
  }
  const unsigned cuts = body.U16(6);
  if (cuts == 0 || body.U16(4) == 0 || !body.Has(patternHeaderBytes, cutBytes * cuts) ||
      std::size_t(2) * body.U16(0) < patternHeaderBytes + cutBytes * cuts)
  {
    return std::nullopt;
  }
  CoveragePattern pattern;
  pattern.number = body.U16(4);
  for (unsigned index = 0; index < cuts; ++index)
  {
    pattern.cuts.push_back(DecodeCut(body.Sub(patternHeaderBytes + cutBytes * index, cutBytes)));
  }
  return pattern;
}

} // namespace nexrad
