// SPDX-License-Identifier: BSD-3-Clause
#include "Live/LiveStatus.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace nexrad::application
{
namespace
{

using Json = nlohmann::ordered_json;

Json TimeJson(const std::optional<Time>& time)
{
  return time ? Json(FormatIso8601(*time)) : Json();
}

double Seconds(Duration duration)
{
  return static_cast<double>(duration.count()) / 1000.0;
}

Json CountsJson(const ArrivingRadar& arriving)
{
  const ArrivalCounts& counts = arriving.counts;
  return {{"used", counts.used}, {"late", counts.late}, {"cut", counts.cut},
    {"repeated", counts.repeated}, {"replaced", counts.replaced}, {"refused", counts.refused},
    {"old", counts.old}, {"waiting", arriving.waiting}, {"half_written", counts.halfWritten},
    {"missing", counts.missing}};
}

Json SweepsJson(const std::vector<SweepArrival>& sweeps)
{
  Json json = Json::array();
  for (const SweepArrival& sweep : sweeps)
  {
    json.push_back({{"elevation_number", sweep.elevationNumber}, {"elevation_deg", sweep.elevation},
      {"begin", FormatIso8601(sweep.begin)}, {"end", FormatIso8601(sweep.end)},
      {"rays", sweep.rays}, {"complete", sweep.complete}});
  }
  return json;
}

Json RadarJson(const std::string& name, const RadarStatus& radar, Time now)
{
  const ArrivingRadar& arriving = radar.arriving;
  return {{"radar", name.empty() ? Json() : Json(name)},
    {"state", radar.newest ? Json(radar.live ? "LIVE" : "STALE") : Json()},
    {"newest_ray", TimeJson(radar.newest)},
    {"age_s", radar.newest ? Json(Seconds(now - *radar.newest)) : Json()},
    {"volume", {{"name", arriving.volume}, {"finished", arriving.finished},
                 {"missing_chunks", arriving.awaited}, {"sweeps", SweepsJson(arriving.sweeps)}}},
    {"files", CountsJson(arriving)}};
}

// In the largest unit of which there are two.
std::string AgeText(Duration age)
{
  constexpr std::pair<const char*, std::int64_t> units[] = {
    {" d", 86'400}, {" h", 3'600}, {" min", 60}};
  const std::int64_t seconds = age.count() / 1000;
  for (const auto& [name, length] : units)
  {
    if (seconds >= 2 * length)
    {
      return std::to_string(seconds / length) + name;
    }
  }
  return std::to_string(seconds) + " s";
}

} // namespace

void LiveDelays::Add(double seconds)
{
  last = seconds;
  largest = std::max(largest, seconds);
  sum += seconds;
  ++count;
}

std::string StatusJson(const LiveStatus& status)
{
  const LiveDelays& delays = status.delays;
  Json json = {{"state", status.state},
    {"reason", status.reason.empty() ? Json() : Json(status.reason)},
    {"written", FormatIso8601(status.written)}, {"stale_s", Seconds(status.staleAge)},
    {"newest", {{"time", TimeJson(status.newest)}, {"file", status.newestFile}}},
    {"picture", status.pictureFile.empty()
                  ? Json()
                  : Json({{"time", TimeJson(status.pictureTime)}, {"file", status.pictureFile}})},
    {"series", {{"steps", status.steps.size()},
                 {"first", status.steps.empty() ? Json() : TimeJson(status.steps.front())},
                 {"last", status.steps.empty() ? Json() : TimeJson(status.steps.back())}}},
    {"delay_s", {{"last", delays.last}, {"largest", delays.largest},
                  {"mean", delays.count > 0 ? delays.sum / static_cast<double>(delays.count) : 0.0},
                  {"volumes", delays.count}}},
    {"radars", Json::array()}, {"problems", status.problems}, {"held_bytes", status.heldBytes},
    {"notes", status.notes}};
  for (const auto& [name, radar] : status.radars)
  {
    json["radars"].push_back(RadarJson(name, radar, status.written));
  }
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

std::string StatusLine(const LiveStatus& status)
{
  constexpr std::size_t date = 11; // "2006-03-12T"
  constexpr std::size_t clock = 8;
  std::string line = FormatIso8601(status.written).substr(date, clock) + "Z";
  const char* separator = " ";
  for (const auto& [name, radar] : status.radars)
  {
    if (radar.newest)
    {
      line += separator + name + (radar.live ? " LIVE " : " STALE ") +
              AgeText(status.written - *radar.newest);
      separator = ", ";
    }
  }
  return line;
}

} // namespace nexrad::application
