// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvSeries.h"

#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/Codec/JsonText.h"
#include "nexrad/Model/Time.h"
#include "nexrad/System/AtomicFile.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/MessageText.h"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstring>
#include <exception>
#include <fstream>

namespace nexrad
{

namespace
{

using Json = nlohmann::ordered_json;

NxvSeries ParseSeries(const Json& json)
{
  if (json.at("file-series-version").get<std::string>().rfind("1.", 0) != 0)
  {
    throw Error(
      "file-series-version " + Excerpt(json.at("file-series-version").dump()) + ": must be 1.x");
  }
  NxvSeries series;
  for (const Json& entry : json.at("files"))
  {
    const auto time = entry.at("time").get<double>();
    if (!(time >= ToSeconds(EarliestTime) && time <= ToSeconds(LatestTime)))
    {
      throw Error("time " + Excerpt(entry.at("time").dump()) + ": must lie in the years 1 to 9999");
    }
    series.emplace_back(entry.at("name").get<std::string>(), time);
  }
  return series;
}

} // namespace

void WriteNxvSeries(const std::filesystem::path& path, const NxvSeries& series)
{
  Json json = {{"file-series-version", "1.0"}, {"files", Json::array()}};
  for (const auto& [name, time] : series)
  {
    json["files"].push_back({{"name", name}, {"time", time}});
  }
  const std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  WriteFileAtomically(path, text.data(), text.size());
}

NxvSeries ReadNxvSeries(const std::filesystem::path& path)
{
  RequireOrdinaryFile(path);
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw Error(path.string() + ": cannot be read: " + std::strerror(errno));
  }
  try
  {
    return ParseSeries(Json::parse(file));
  }
  catch (const std::exception& problem)
  {
    // JSON's, ours, or the stream's own (a folder opens and then cannot be read).
    throw FileError(path, std::string("not a series index: ") + problem.what());
  }
}

} // namespace nexrad
