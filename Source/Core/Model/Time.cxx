// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/Time.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ratio>

namespace nexrad
{

namespace
{

struct CalendarDate
{
  std::int64_t year;
  unsigned month;
  unsigned day;
};

// Days since 1970-01-01 of a date in the proleptic Gregorian calendar. Years are counted from
// March, so that the leap day is the last day of a year.
std::int64_t DaysFromDate(const CalendarDate& date)
{
  const std::int64_t year = date.month <= 2 ? date.year - 1 : date.year;
  const std::int64_t era = (year >= 0 ? year : year - 399) / 400;
  const std::int64_t yearOfEra = year - era * 400;
  const std::int64_t monthFromMarch = (date.month + 9) % 12;
  const std::int64_t dayOfYear = (153 * monthFromMarch + 2) / 5 + date.day - 1;
  const std::int64_t dayOfEra = yearOfEra * 365 + yearOfEra / 4 - yearOfEra / 100 + dayOfYear;
  return era * 146097 + dayOfEra - 719468;
}

CalendarDate DateFromDays(std::int64_t days)
{
  const std::int64_t shifted = days + 719468;
  const std::int64_t era = (shifted >= 0 ? shifted : shifted - 146096) / 146097;
  const std::int64_t dayOfEra = shifted - era * 146097;
  const std::int64_t yearOfEra =
    (dayOfEra - dayOfEra / 1460 + dayOfEra / 36524 - dayOfEra / 146096) / 365;
  const std::int64_t dayOfYear = dayOfEra - (365 * yearOfEra + yearOfEra / 4 - yearOfEra / 100);
  const std::int64_t monthFromMarch = (5 * dayOfYear + 2) / 153;
  const auto day = static_cast<unsigned>(dayOfYear - (153 * monthFromMarch + 2) / 5 + 1);
  const auto month =
    static_cast<unsigned>(monthFromMarch < 10 ? monthFromMarch + 3 : monthFromMarch - 9);
  return {yearOfEra + era * 400 + (month <= 2 ? 1 : 0), month, day};
}

bool IsCalendarDate(const CalendarDate& date)
{
  if (date.month < 1 || date.month > 12 || date.day < 1)
  {
    return false;
  }
  const CalendarDate back = DateFromDays(DaysFromDate(date));
  return back.month == date.month && back.day == date.day;
}

} // namespace

Time FromLevel2Date(std::uint32_t days, std::uint32_t milliseconds)
{
  return Time(Duration((static_cast<std::int64_t>(days) - 1) * 86'400'000 + milliseconds));
}

std::string FormatIso8601(Time time)
{
  using Days = std::chrono::duration<std::int64_t, std::ratio<86'400>>;
  const auto day = std::chrono::floor<Days>(time.time_since_epoch());
  const CalendarDate date = DateFromDays(day.count());
  const auto rest = static_cast<unsigned>((time.time_since_epoch() - day).count());
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%04lld-%02u-%02uT%02u:%02u:%02u.%03uZ",
    static_cast<long long>(date.year), date.month, date.day, rest / 3'600'000, rest / 60'000 % 60,
    rest / 1000 % 60, rest % 1000);
  return text.data();
}

std::string FormatForFileName(Time time)
{
  std::string text = FormatIso8601(time);
  text.erase(text.find('.'), 4);
  const auto isPunctuation = [](char letter) { return letter == '-' || letter == ':'; };
  text.erase(std::remove_if(text.begin(), text.end(), isPunctuation), text.end());
  return text;
}

std::optional<Time> ParseIso8601(std::string_view text)
{
  std::string value(text);
  if (!value.empty() && value.back() == 'Z')
  {
    value.pop_back();
  }
  int year = 0;
  unsigned month = 0;
  unsigned day = 0;
  unsigned hour = 0;
  unsigned minute = 0;
  double second = 0.0;
  char separator = 'T';
  // Where the date, the minutes and the seconds end; 0 for what is not there.
  int dateEnd = 0;
  int minuteEnd = 0;
  int secondEnd = 0;
  const int fields = std::sscanf(value.c_str(), "%4d-%2u-%2u%n%c%2u:%2u%n:%6lf%n", &year, &month,
    &day, &dateEnd, &separator, &hour, &minute, &minuteEnd, &second, &secondEnd);
  const bool complete =
    fields >= 3 && std::max({dateEnd, minuteEnd, secondEnd}) == static_cast<int>(value.size());
  const CalendarDate date{year, month, day};
  if (!complete || (separator != 'T' && separator != ' ') || !IsCalendarDate(date) || hour > 23 ||
      minute > 59 || !(second >= 0.0 && second < 60.0))
  {
    return std::nullopt;
  }
  return Time(Duration(DaysFromDate(date) * 86'400'000 + hour * 3'600'000LL + minute * 60'000LL +
                       std::llround(second * 1000.0)));
}

double ToSeconds(Time time)
{
  return static_cast<double>(time.time_since_epoch().count()) / 1000.0;
}

Time FromSeconds(double seconds)
{
  return Time(DurationOf(seconds));
}

Duration DurationOf(double seconds)
{
  return Duration(static_cast<Duration::rep>(std::llround(seconds * 1000.0)));
}

} // namespace nexrad
