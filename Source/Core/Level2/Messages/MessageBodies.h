// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Model/RadarVolume.h"

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace nexrad
{

/// Why a message gives no ray: one line without the place.
class MessageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Where a radar stands, as the volume block of message 31 has it.
struct StoredPosition
{
  double latitude = 0.0;  ///< degrees; TDWR may write thousandths of a degree
  double longitude = 0.0; ///< the same, east positive
  int siteHeight = 0;     ///< m above mean sea level
  int feedhornHeight = 0; ///< m above the ground; TDWR repeats the site height here
};

/// A ray with what its message says besides.
struct DecodedRay
{
  Ray ray;                                ///< its words lie in the message
  unsigned azimuthNumber = 0;             ///< number of the ray in its cut, from 1
  int coveragePatternNumber = 0;          ///< VCP; 0 when the message has none
  std::string siteName;                   ///< "" in message 1
  std::optional<StoredPosition> position; ///< message 31
  std::vector<std::string> problems;      ///< what is wrong with moments that were left out
};

/// Reads the body of message 1, digital radar data of 1991 to 2008: REF, VEL and SW in bytes (ICD
/// 2620002, table III). The ray points into the body. A moment that does not lie in the body is
/// left out and named in `problems`. Throws MessageError, or std::out_of_range when the body is too
/// short, when it gives no ray.
DecodedRay DecodeMessage1(ByteView body);

/// Reads the body of message 31, digital radar data since 2008: any moment, in words of 8 or 16
/// bits (ICD 2620002, table XVII). The ray points into the body. A block that does not lie in the
/// body or makes no sense is left out and named in `problems`; moments of other names are passed
/// over. Throws MessageError, or std::out_of_range when the body is too short, when it gives no
/// ray.
DecodedRay DecodeMessage31(ByteView body);

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

/// True when a console message is the mark. `body` is what follows the message header: a halfword
/// with the length of the text, then the text, of which the mark is the beginning.
bool IsSyntheticMark(ByteView body);

} // namespace nexrad
