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

nlohmann::json ToJson(const std::optional<Time>& time)
{
  return time ? nlohmann::json(time->time_since_epoch().count()) : nlohmann::json();
}

// A time as Steps reads it.
std::optional<Time> TimeIn(const nlohmann::json& json)
{
  Steps one;
  one.Unpack(json.is_null() ? "[]" : "[[" + json.dump() + ",\"\"]]");
  return json.is_null() ? std::nullopt : std::optional(one.Made().front());
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
  const std::vector<Time> steps = this->Made();
  const auto before = newest || steps.empty() ? newest : std::optional(steps.back());
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
  return made.IsDue(step, inputs) && (settled || !made.Has(step) || this->IsClosing(step));
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
  if (closedUntil)
  {
    made.Close(*closedUntil);
  }
}

void StepBook::Drop(Time before)
{
  made.Drop(before);
  if (first && before > *first)
  {
    closedUntil = std::max(closedUntil.value_or(before - Duration(1)), before - Duration(1));
  }
}

std::string StepBook::Pack() const
{
  return "{\"first\":" + ToJson(first).dump() + ",\"closed_until\":" + ToJson(closedUntil).dump() +
         ",\"steps\":" + made.Pack() + '}';
}

void StepBook::Unpack(const std::string& text)
{
  try
  {
    const nlohmann::json json = nlohmann::json::parse(text);
    StepBook book(rules);
    book.first = TimeIn(json.at("first"));
    book.closedUntil = TimeIn(json.at("closed_until"));
    book.made.Unpack(json.at("steps").dump());
    *this = std::move(book);
  }
  catch (const nlohmann::json::exception&)
  {
    throw Error("these are no time steps of a series");
  }
}

} // namespace nexrad
