// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Compression/BigEndian.h"
#include "nexrad/Level2/Messages/DecodedRay.h"

namespace nexrad
{

/// Reads the body of message 31, digital radar data since 2008: any moment, in words of 8 or 16
/// bits (ICD 2620002, table XVII). The ray points into the body. A block that does not lie in the
/// body or makes no sense is left out and named in `problems`; moments of other names are passed
/// over. Throws MessageError, or std::out_of_range when the body is too short, when it gives no
/// ray.
DecodedRay DecodeMessage31(ByteView body);

} // namespace nexrad
