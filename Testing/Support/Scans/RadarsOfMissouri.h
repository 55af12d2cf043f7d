// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Model/Site.h"
#include "nexrad/Model/Time.h"

namespace nexrad::testing
{

/// Two radars 310 km apart, in whose names many tests make volumes, and times at which they do.
inline const Site keax = {"KEAX", Position{38.81, -94.264, 333.0}};
inline const Site klsx = {"KLSX", Position{38.699, -90.683, 220.0}};
inline const Time start = *ParseIso8601("2006-03-12T18:00:00Z");
inline const Time noon = *ParseIso8601("2006-03-12T12:00:00Z");

/// A time as ParseIso8601 reads it.
inline Time At(const char* text)
{
  return *ParseIso8601(text);
}

} // namespace nexrad::testing
