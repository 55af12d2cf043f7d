// SPDX-License-Identifier: BSD-3-Clause
#include "Live/LiveFolder.h"

#include "Output/OutputFile.h"
#include "Volumes/UnfinishedRun.h"
#include "nexrad/Codec/NxvFile.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/OrdinaryFile.h"

#include <nlohmann/json.hpp>

#include <fcntl.h>

#include <cerrno>
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

std::string Text(const nlohmann::json& json)
{
  return json.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n';
}

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

nlohmann::json RadarJson(const std::pair<Site, double>& radar)
{
  const Position& position = *radar.first.position;
  return {{"name", radar.first.name}, {"latitude", position.latitude},
    {"longitude", position.longitude}, {"altitude_m", position.altitude},
    {"range_m", radar.second}};
}

std::pair<Site, double> RadarIn(const nlohmann::json& json)
{
  return {Site{json.at("name").get<std::string>(),
            Position{json.at("latitude").get<double>(), json.at("longitude").get<double>(),
              json.at("altitude_m").get<double>()}},
    json.at("range_m").get<double>()};
}

} // namespace

LiveFolder::LiveFolder(fs::path theFolder, std::string theRecipe)
  : folder(std::move(theFolder))
  , recipe(std::move(theRecipe))
{
  MakeFolder(folder);
  MakeFolder(folder / hiddenName);
  this->Lock();
}

LiveFolder::~LiveFolder()
{
  this->Unlock();
}

void LiveFolder::Unlock()
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

void LiveFolder::Lock()
{
  const fs::path ofGrid = folder / UnfinishedRun::HiddenName;
  MakeFolder(ofGrid);
  lock = OpenLock(folder / hiddenName / "lock");
  gridLock = OpenLock(ofGrid / UnfinishedRun::LockName);
  if (!TryLock(lock) || !TryLock(gridLock))
  {
    gridLock.Close();
    throw Error(folder.string() +
                ": another run writes volumes into this folder; wait until it has ended, or name "
                "another folder");
  }
}

void LiveFolder::GoOn()
{
  this->ReadState();
  const fs::path room = folder / hiddenName / roomName;
  if (!fs::exists(room))
  {
    WriteText(room, std::string(roomBytes, ' '));
  }
}

void LiveFolder::ReadState()
{
  const fs::path path = folder / hiddenName / "state.json";
  RequireOrdinaryFile(path);
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    return;
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
      before.radars.push_back(RadarIn(radar));
    }
  }
  catch (const nlohmann::json::exception&)
  {
    throw Error(path.string() + ": cannot be read; remove it to begin the series anew");
  }
}

fs::path LiveFolder::NewestVolume() const
{
  return folder / "newest.nxv";
}

fs::path LiveFolder::Index() const
{
  return folder / "volumes.nxv.series";
}

void LiveFolder::WriteNewest(const GriddedVolume& volume) const
{
  WriteNxv(this->NewestVolume(), volume);
}

void LiveFolder::WriteStep(const GriddedVolume& volume) const
{
  WriteNxv(folder / VolumeFileName(volume.time), volume);
}

void LiveFolder::RemoveStep(Time time) const
{
  std::error_code ignored;
  fs::remove(folder / VolumeFileName(time), ignored);
}

void LiveFolder::WriteIndex(const std::vector<Time>& steps) const
{
  std::vector<std::string> files;
  for (const Time time : steps)
  {
    files.push_back(VolumeFileName(time).string());
  }
  WriteVolumeIndex(this->Index(), files, steps);
}

void LiveFolder::WriteState(const LiveState& state) const
{
  nlohmann::json json = {{"recipe", recipe}, {"steps", state.steps},
    {"keeps_grid", state.keepsGrid}, {"radars", nlohmann::json::array()}};
  for (const auto& radar : state.radars)
  {
    json["radars"].push_back(RadarJson(radar));
  }
  WriteText(folder / hiddenName / "state.json", Text(json));
}

void LiveFolder::WriteStatus(const std::string& text) const
{
  WriteText(folder / "status.json", text);
}

void LiveFolder::WriteLastStatus(const std::string& text) const noexcept
{
  try
  {
    std::error_code ignored;
    fs::remove(folder / hiddenName / roomName, ignored);
    this->WriteStatus(text);
  }
  catch (const std::exception&)
  {
    return; // the caller says what went wrong before
  }
}

} // namespace nexrad::application
