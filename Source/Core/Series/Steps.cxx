// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/Steps.h"

#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <utility>

namespace nexrad
{

namespace
{

// Bytes that are no UTF-8, as in the name of a file, are replaced, in all texts alike.
std::string StepText(const std::string& of)
{
  return nlohmann::json(of).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Time TimeIn(const nlohmann::json& json)
{
  const auto number = [](Time time) { return time.time_since_epoch().count(); };
  const bool tooLarge = json.is_number_unsigned() &&
                        json.get<std::uint64_t>() > static_cast<std::uint64_t>(number(LatestTime));
  if (!json.is_number_integer() || tooLarge || json.get<std::int64_t>() < number(EarliestTime))
  {
    throw Error("a time step is no time of the years 1 to 9999");
  }
  return Time(Duration(json.get<std::int64_t>()));
}

} // namespace

bool Steps::IsDue(Time step, const std::string& of) const
{
  const auto known = made.find(step);
  return known == made.end() || known->second != StepText(of);
}

void Steps::Make(Time step, const std::string& of)
{
  made[step] = StepText(of);
}

void Steps::Close(Time until)
{
  for (auto step = made.begin(); step != made.upper_bound(until); ++step)
  {
    step->second = StepText({});
  }
}

void Steps::Drop(Time before)
{
  made.erase(made.begin(), made.lower_bound(before));
}

std::vector<Time> Steps::Made() const
{
  std::vector<Time> times;
  for (const auto& [time, of] : made)
  {
    times.push_back(time);
  }
  return times;
}

std::string Steps::Pack() const
{
  std::string text;
  for (const auto& [time, of] : made)
  {
    text += (text.empty() ? "[[" : ",[") + std::to_string(time.time_since_epoch().count()) + ',' +
            of + ']';
  }
  return text.empty() ? "[]" : text + ']';
}

void Steps::Unpack(const std::string& text)
{
  try
  {
    Steps all = *this;
    for (const nlohmann::json& step : nlohmann::json::parse(text))
    {
      all.Make(TimeIn(step.at(0)), step.at(1).get<std::string>());
    }
    *this = std::move(all);
  }
  catch (const nlohmann::json::exception&)
  {
    throw Error("these are no time steps of a series");
  }
}

} // namespace nexrad
