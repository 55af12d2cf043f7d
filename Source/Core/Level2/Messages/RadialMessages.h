// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Level2/Messages/DecodedRay.h"

namespace nexrad
{

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

} // namespace nexrad
