// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/StepBook.h"

#include "nexrad/Model/Time.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace nexrad
{

namespace
{

std::int64_t Number(Time time)
{
  return time.time_since_epoch().count();
}

nlohmann::json ToJson(const std::optional<Time>& time)
{
  return time ? nlohmann::json(Number(*time)) : nlohmann::json();
}

Time TimeIn(const nlohmann::json& json)
{
  const bool tooLarge = json.is_number_unsigned() &&
                        json.get<std::uint64_t>() > static_cast<std::uint64_t>(Number(LatestTime));
  if (!json.is_number_integer() || tooLarge || json.get<std::int64_t>() < Number(EarliestTime))
  {
    throw Error("a time step is no time of the years 1 to 9999");
  }
  return Time(Duration(json.get<std::int64_t>()));
}

std::optional<Time> OptionalTimeIn(const nlohmann::json& json)
{
  return json.is_null() ? std::nullopt : std::optional(TimeIn(json));
}

} // namespace

StepBook::StepBook(const StepRules& theRules)
  : rules(theRules)
{
}

void StepBook::Extend(Time theFirst, Time theLast)
{
  if (newest && *newest - theLast > std::max(LongestPause, rules.late))
  {
    return;
  }
  const auto before = newest || made.empty() ? newest : std::optional(made.rbegin()->first);
  if (before && theLast - *before > LongestPause)
  {
    const Time until = theLast - rules.late - rules.step;
    closedUntil = std::max(closedUntil.value_or(until), until);
  }
  // No volume is longer than a day: a ray that was dated before is not where the series begins.
  theFirst = std::max(theFirst, theLast - LongestPause);
  first = std::min(first.value_or(theFirst), theFirst);
  newest = std::max(newest.value_or(theLast), theLast);
}

std::vector<Time> StepBook::Open() const
{
  if (!newest)
  {
    return {};
  }
  Time from = rules.begin.value_or(*first);
  from = closedUntil ? std::max(from, *closedUntil + Duration(1)) : from;
  const Time to = rules.end ? std::min(*rules.end, *newest) : *newest;
  return to < from ? std::vector<Time>() : TimeSteps(from, to, rules.step);
}

bool StepBook::IsClosing(Time step) const
{
  return newest && step < *newest - rules.late;
}

bool StepBook::IsDue(Time step, const std::string& inputs, bool settled) const
{
  const auto known = made.find(step);
  if (known == made.end())
  {
    return true;
  }
  return known->second != inputs && (settled || this->IsClosing(step));
}

void StepBook::Make(Time step, const std::string& inputs)
{
  made[step] = inputs;
}

void StepBook::Close()
{
  for (const Time step : this->Open())
  {
    if (this->IsClosing(step))
    {
      closedUntil = step;
    }
  }
  for (auto& [time, inputs] : made)
  {
    if (closedUntil && time <= *closedUntil)
    {
      inputs.clear(); // never compared again
    }
  }
}

void StepBook::Drop(Time before)
{
  made.erase(made.begin(), made.lower_bound(before));
  if (first && before > *first)
  {
    closedUntil = std::max(closedUntil.value_or(before - Duration(1)), before - Duration(1));
  }
}

std::vector<Time> StepBook::Made() const
{
  std::vector<Time> times;
  for (const auto& [time, inputs] : made)
  {
    times.push_back(time);
  }
  return times;
}

std::string StepBook::Pack() const
{
  nlohmann::json json = {{"first", ToJson(first)}, {"closed_until", ToJson(closedUntil)},
    {"steps", nlohmann::json::array()}};
  for (const auto& [time, inputs] : made)
  {
    json["steps"].push_back({Number(time), inputs});
  }
  return json.dump();
}

void StepBook::Unpack(const std::string& text)
{
  try
  {
    const nlohmann::json json = nlohmann::json::parse(text);
    StepBook book(rules);
    book.first = OptionalTimeIn(json.at("first"));
    book.closedUntil = OptionalTimeIn(json.at("closed_until"));
    for (const nlohmann::json& step : json.at("steps"))
    {
      book.made[TimeIn(step.at(0))] = step.at(1).get<std::string>();
    }
    *this = std::move(book);
  }
  catch (const nlohmann::json::exception&)
  {
    throw Error("these are no time steps of a series");
  }
}

} // namespace nexrad
