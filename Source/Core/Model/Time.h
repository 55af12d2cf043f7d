// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace nexrad
{

/// An instant in UTC, in whole milliseconds since 1970-01-01T00:00:00Z (the resolution of Level
/// II).
using Time = std::chrono::time_point<std::chrono::system_clock, std::chrono::milliseconds>;
using Duration = std::chrono::milliseconds;

/// The instant of a Level II date and time: `days` counts from 1 on 1970-01-01, `milliseconds` from
/// midnight (ICD 2620002, message header).
Time FromLevel2Date(std::uint32_t days, std::uint32_t milliseconds);

/// "2005-08-21T02:43:19.671Z".
std::string FormatIso8601(Time time);

/// "20050821T024319Z", the name of a volume file. Milliseconds are cut.
std::string FormatForFileName(Time time);

/// Reads "2005-08-21T02:43:19.671Z" and its shorter forms: no milliseconds, no seconds, no 'Z',
/// a space in place of 'T', the date alone (midnight). Empty when the text is none of these or no
/// such day exists.
std::optional<Time> ParseIso8601(std::string_view text);

/// VTK's time value: seconds since 1970-01-01T00:00:00Z, exact to the millisecond.
double ToSeconds(Time time);
Time FromSeconds(double seconds);
/// A duration of so many seconds, to the millisecond.
Duration DurationOf(double seconds);

/// The first and the last millisecond of the years 1 to 9999, which ISO 8601 writes with four
/// digits. Readers refuse other times: sums with them would overflow.
constexpr Time EarliestTime{Duration(-62'135'596'800'000)};
constexpr Time LatestTime{Duration(253'402'300'799'999)};

} // namespace nexrad
