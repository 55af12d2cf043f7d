// SPDX-License-Identifier: BSD-3-Clause
#include "Live/LiveFolder.h"

#include "Output/OutputFile.h"
#include "Volumes/UnfinishedRun.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <system_error>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

constexpr const char* hiddenName = ".watch";
// A file that is given up for the last status where the disk is full.
constexpr const char* roomName = "room";
constexpr std::size_t roomBytes = std::size_t(1) << 18; // a status of hundreds of radars

void WriteText(const fs::path& path, const std::string& text)
{
  WriteFileAtomically(path, text.data(), text.size());
}

FileDescriptor OpenLock(const fs::path& path)
{
  FileDescriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
  if (!file.IsOpen())
  {
    throw Error(path.string() + ": cannot be written: " + std::strerror(errno));
  }
  return file;
}

nlohmann::json RadarJson(const Site& site, double range)
{
  const Position& position = *site.position;
  return {{"name", site.name}, {"latitude", position.latitude}, {"longitude", position.longitude},
    {"altitude_m", position.altitude}, {"range_m", range}};
}

std::pair<Site, double> RadarIn(const nlohmann::json& json)
{
  return {Site{json.at("name").get<std::string>(),
            Position{json.at("latitude").get<double>(), json.at("longitude").get<double>(),
              json.at("altitude_m").get<double>()}},
    json.at("range_m").get<double>()};
}

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

Json StatusOfRadar(const std::string& name, const RadarStatus& radar, Time now)
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

std::string StatusText(const LiveStatus& status)
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
    json["radars"].push_back(StatusOfRadar(name, radar, status.written));
  }
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

} // namespace

void LiveDelays::Add(double seconds)
{
  last = seconds;
  largest = std::max(largest, seconds);
  sum += seconds;
  ++count;
}

std::string StatusLine(const LiveStatus& status)
{
  constexpr std::size_t mostNamed = 12;
  std::vector<std::string> words;
  std::vector<std::string> stale;
  for (const auto& [name, radar] : status.radars)
  {
    if (radar.newest)
    {
      words.push_back(
        name + (radar.live ? " LIVE " : " STALE ") + AgeText(status.written - *radar.newest));
      if (!radar.live)
      {
        stale.push_back(words.back());
      }
    }
  }
  if (words.size() > mostNamed)
  {
    words = {std::to_string(words.size() - stale.size()) + " radars LIVE"};
    if (stale.size() > mostNamed)
    {
      stale = {std::to_string(stale.size()) + " STALE"};
    }
    words.insert(words.end(), stale.begin(), stale.end());
  }
  constexpr std::size_t date = 11; // "2006-03-12T"
  constexpr std::size_t clock = 8;
  std::string line = FormatIso8601(status.written).substr(date, clock) + "Z";
  const char* separator = " ";
  for (const std::string& word : words)
  {
    line += separator + word;
    separator = ", ";
  }
  return line;
}

LiveFolder::LiveFolder(fs::path theFolder, std::string theRecipe)
  : folder(std::move(theFolder))
  , recipe(std::move(theRecipe))
{
  MakeFolder(folder);
  MakeFolder(folder / hiddenName);
  const fs::path ofGrid = folder / UnfinishedRun::HiddenName;
  MakeFolder(ofGrid);
  lock = OpenLock(folder / hiddenName / "lock");
  gridLock = OpenLock(ofGrid / UnfinishedRun::LockName);
  if (!TryLock(lock) || !TryLock(gridLock))
  {
    throw Error(folder.string() +
                ": another run writes volumes into this folder; wait until it has ended, or name "
                "another folder");
  }
}

LiveFolder::~LiveFolder()
{
  std::error_code ignored;
  const fs::path ofGrid = folder / UnfinishedRun::HiddenName;
  const auto held = std::distance(fs::directory_iterator(ofGrid, ignored), {});
  if (held > 1)
  {
    return; // an interrupted run of grid left something there
  }
  fs::remove(ofGrid / UnfinishedRun::LockName, ignored);
  fs::remove(ofGrid, ignored);
}

LiveState LiveFolder::GoOn() const
{
  LiveState before = this->ReadState();
  const fs::path room = folder / hiddenName / roomName;
  if (!fs::exists(room))
  {
    WriteText(room, std::string(roomBytes, ' '));
  }
  return before;
}

LiveState LiveFolder::ReadState() const
{
  LiveState before;
  const fs::path path = folder / hiddenName / "state.json";
  RequireOrdinaryFile(path);
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return before;
  }
  try
  {
    const nlohmann::json json = nlohmann::json::parse(file);
    if (json.at("recipe") != recipe)
    {
      throw Error(folder.string() +
                  ": holds a series of other options; give the same options to go on with it, or "
                  "name another folder");
    }
    before.steps = json.at("steps").get<std::string>();
    before.keepsGrid = json.at("keeps_grid").get<bool>();
    for (const nlohmann::json& radar : json.at("radars"))
    {
      const auto [site, range] = RadarIn(radar);
      before.radars.emplace(site.name, std::pair(site, range));
    }
  }
  catch (const nlohmann::json::exception&)
  {
    throw Error(path.string() + ": cannot be read; remove it to begin the series anew");
  }
  return before;
}

fs::path LiveFolder::NewestVolume() const
{
  return folder / "newest.nxv";
}

fs::path LiveFolder::StepVolume(Time time) const
{
  return folder / VolumeFileName(time);
}

void LiveFolder::RemoveStep(Time time) const
{
  std::error_code ignored;
  fs::remove(this->StepVolume(time), ignored);
}

void LiveFolder::WriteIndex(const std::vector<Time>& steps) const
{
  std::vector<std::string> files;
  for (const Time time : steps)
  {
    files.push_back(VolumeFileName(time).string());
  }
  WriteVolumeIndex(folder / "volumes.nxv.series", files, steps);
}

void LiveFolder::WriteState(const LiveState& state) const
{
  nlohmann::json json = {{"recipe", recipe}, {"steps", state.steps},
    {"keeps_grid", state.keepsGrid}, {"radars", nlohmann::json::array()}};
  for (const auto& [name, radar] : state.radars)
  {
    json["radars"].push_back(RadarJson(radar.first, radar.second));
  }
  WriteText(folder / hiddenName / "state.json",
    json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
}

void LiveFolder::WriteStatus(const LiveStatus& status) const
{
  WriteText(folder / "status.json", StatusText(status));
}

void LiveFolder::WriteLastStatus(const LiveStatus& status) const noexcept
{
  try
  {
    std::error_code ignored;
    fs::remove(folder / hiddenName / roomName, ignored);
    this->WriteStatus(status);
  }
  catch (const std::exception&)
  {
    return; // the caller says what went wrong before
  }
}

} // namespace nexrad::application
