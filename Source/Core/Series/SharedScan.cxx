// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/SharedScan.h"

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <tuple>

namespace nexrad
{

namespace
{

using Json = nlohmann::json;

// The first byte of a message between processes says how the scan of its sender went.
constexpr char scanDone = 'd';
constexpr char scanStopped = 's';
constexpr char scanFailed = 'f';

Json PackComposite(const PackedComposite& composite)
{
  std::vector<std::uint8_t> bytes(composite.picture.size() * sizeof(float));
  std::memcpy(bytes.data(), composite.picture.data(), bytes.size());
  Json tilts = Json::array();
  for (const VolumeComposite::Tilt& tilt : composite.tilts)
  {
    tilts.push_back({tilt.elevation, tilt.echo});
  }
  return {{"rings", composite.rings}, {"echoTime", composite.echoTime}, {"echo", composite.echo},
    {"tilts", std::move(tilts)}, {"picture", Json::binary(std::move(bytes))}};
}

PackedComposite UnpackComposite(const Json& packed)
{
  PackedComposite composite;
  composite.rings = packed.at("rings");
  composite.echoTime = packed.at("echoTime");
  composite.echo = packed.at("echo");
  for (const Json& tilt : packed.at("tilts"))
  {
    composite.tilts.push_back({tilt.at(0), tilt.at(1)});
  }
  const Json::binary_t& bytes = packed.at("picture").get_binary();
  composite.picture.resize(bytes.size() / sizeof(float));
  std::memcpy(composite.picture.data(), bytes.data(), composite.picture.size() * sizeof(float));
  return composite;
}

Json PackSummary(const VolumeSummary& summary)
{
  return {{"reach", summary.reach}, {"composite", PackComposite(summary.composite)},
    {"lowest", PackComposite(summary.lowest)}};
}

VolumeSummary UnpackSummary(const Json& packed)
{
  return {packed.at("reach"), UnpackComposite(packed.at("composite")),
    UnpackComposite(packed.at("lowest"))};
}

Json PackVolume(const Site& site, const SeriesVolume& volume)
{
  Json packed = {{"site", site.name}, {"file", volume.file.string()}, {"cycle", volume.cycle},
    {"start", volume.start.time_since_epoch().count()},
    {"end", volume.end.time_since_epoch().count()}, {"begun", volume.begun},
    {"left", volume.left.count()}, {"rays", volume.rays}, {"reach", volume.reach},
    {"synthetic", volume.synthetic}, {"moments", volume.moments}, {"lacking", volume.lacking}};
  if (site.position)
  {
    packed["position"] = {
      site.position->latitude, site.position->longitude, site.position->altitude};
  }
  if (volume.echo)
  {
    packed["echo"] = *volume.echo;
  }
  if (volume.summary)
  {
    packed["summary"] = PackSummary(*volume.summary);
  }
  if (volume.lowEcho)
  {
    const std::string bytes = volume.lowEcho->Pack();
    packed["lowEcho"] = Json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
  }
  return packed;
}

std::pair<Site, SeriesVolume> UnpackVolume(const Json& packed)
{
  Site site;
  site.name = packed.at("site");
  if (packed.contains("position"))
  {
    const Json& position = packed.at("position");
    site.position = Position{position.at(0), position.at(1), position.at(2)};
  }
  SeriesVolume volume;
  volume.file = packed.at("file").get<std::string>();
  volume.cycle = packed.at("cycle");
  volume.start = Time(Duration(packed.at("start").get<Duration::rep>()));
  volume.end = Time(Duration(packed.at("end").get<Duration::rep>()));
  volume.begun = packed.at("begun");
  volume.left = Duration(packed.at("left").get<Duration::rep>());
  volume.rays = packed.at("rays");
  volume.reach = packed.at("reach");
  volume.synthetic = packed.at("synthetic");
  volume.moments = packed.at("moments").get<std::vector<MomentName>>();
  volume.lacking = packed.at("lacking").get<std::vector<MomentName>>();
  if (packed.contains("echo"))
  {
    volume.echo = packed.at("echo").get<ReasonCounts>();
  }
  if (packed.contains("summary"))
  {
    volume.summary = std::make_shared<const VolumeSummary>(UnpackSummary(packed.at("summary")));
  }
  if (packed.contains("lowEcho"))
  {
    const Json::binary_t& bytes = packed.at("lowEcho").get_binary();
    volume.lowEcho =
      std::make_shared<const LowEcho>(LowEcho::Unpack(std::string(bytes.begin(), bytes.end())));
  }
  return {site, volume};
}

Json PackProblem(const InputProblem& problem)
{
  return {{"file", problem.file}, {"what", problem.what}, {"leftOut", problem.leftOut},
    {"isMissingEnd", problem.isMissingEnd},
    {"offset", problem.offset ? Json(*problem.offset) : Json()}};
}

InputProblem UnpackProblem(const Json& packed)
{
  InputProblem problem;
  problem.file = packed.at("file");
  problem.what = packed.at("what");
  problem.leftOut = packed.at("leftOut");
  problem.isMissingEnd = packed.at("isMissingEnd");
  if (!packed.at("offset").is_null())
  {
    problem.offset = packed.at("offset").get<std::uint64_t>();
  }
  return problem;
}

// Where a site stands along the axis of an order, degrees; 0 without one, or for an unknown site.
double PlaceOf(const std::string& site, ScanOrder order)
{
  const KnownSite* known = order == ScanOrder::ByTime ? nullptr : FindSite(site);
  if (known == nullptr)
  {
    return 0.0;
  }
  return order == ScanOrder::ByLongitude ? known->position.longitude : known->position.latitude;
}

// Indices of the paths in the order of the places and times in the files' headers.
std::vector<std::size_t> OrderByHeaders(
  const std::vector<std::filesystem::path>& paths, ScanOrder order)
{
  std::vector<std::tuple<double, std::string, Time>> keys;
  for (const std::filesystem::path& path : paths)
  {
    const VolumeHeader header = PeekVolumeHeader(path).value_or(VolumeHeader());
    const std::string site = order == ScanOrder::ByTime ? std::string() : header.siteName;
    keys.emplace_back(PlaceOf(site, order), site, header.time.value_or(Time()));
  }
  std::vector<std::size_t> sorted(paths.size());
  std::iota(sorted.begin(), sorted.end(), std::size_t(0));
  std::stable_sort(sorted.begin(), sorted.end(),
    [&keys](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return sorted;
}

// The scan of this process as a message. Whatever goes wrong becomes a message too: the others wait
// for it.
std::string ScanToMessage(const std::function<std::optional<std::vector<ScannedFile>>()>& scan)
{
  try
  {
    const auto files = scan();
    return files ? scanDone + PackScannedFiles(*files) : std::string(1, scanStopped);
  }
  catch (const std::exception& error)
  {
    return scanFailed + std::string(error.what());
  }
}

} // namespace

std::optional<std::vector<ScannedFile>> ScanTogether(
  const std::vector<std::filesystem::path>& paths, const Processes& processes, ScanOrder scanOrder,
  const FileScanner& scan)
{
  std::vector<std::size_t> order;
  const auto scanOwn = [&]
  {
    order = OrderByHeaders(paths, scanOrder);
    std::vector<std::filesystem::path> own;
    const auto [begin, end] = processes.Part(paths.size());
    for (std::size_t place = begin; place < end; ++place)
    {
      own.push_back(paths[order[place]]);
    }
    return scan(own);
  };
  const std::vector<std::string> messages = processes.Exchange(ScanToMessage(scanOwn));
  std::vector<ScannedFile> files(paths.size());
  bool stopped = false;
  for (std::size_t rank = 0; rank < messages.size(); ++rank)
  {
    const char outcome = messages[rank].empty() ? scanFailed : messages[rank].front();
    if (outcome == scanFailed)
    {
      throw Error(messages[rank].empty() ? "a process was lost" : messages[rank].substr(1));
    }
    stopped = stopped || outcome == scanStopped;
    const std::vector<ScannedFile> part = outcome == scanDone
                                            ? UnpackScannedFiles(messages[rank].substr(1))
                                            : std::vector<ScannedFile>();
    const auto [begin, end] = processes.PartOf(paths.size(), rank);
    if (outcome == scanDone && part.size() != end - begin)
    {
      throw Error("the processes do not find the same input files; all need the same folders");
    }
    for (std::size_t index = 0; index < part.size(); ++index)
    {
      files.at(order.at(begin + index)) = part[index];
    }
  }
  return stopped ? std::nullopt : std::optional(files);
}

std::string PackScannedFiles(const std::vector<ScannedFile>& files)
{
  Json list = Json::array();
  for (const ScannedFile& file : files)
  {
    Json packed = {{"volumes", Json::array()}, {"problems", Json::array()}, {"notes", file.notes}};
    for (const auto& [site, volume] : file.volumes)
    {
      packed["volumes"].push_back(PackVolume(site, volume));
    }
    for (const InputProblem& problem : file.problems)
    {
      packed["problems"].push_back(PackProblem(problem));
    }
    list.push_back(packed);
  }
  // Not as text: a file's name need not be UTF-8.
  const std::vector<std::uint8_t> bytes = Json::to_cbor(list);
  return {bytes.begin(), bytes.end()};
}

std::vector<ScannedFile> UnpackScannedFiles(const std::string& bytes)
{
  try
  {
    std::vector<ScannedFile> files;
    for (const Json& packed : Json::from_cbor(bytes))
    {
      ScannedFile& file = files.emplace_back();
      for (const Json& volume : packed.at("volumes"))
      {
        file.volumes.push_back(UnpackVolume(volume));
      }
      for (const Json& problem : packed.at("problems"))
      {
        file.problems.push_back(UnpackProblem(problem));
      }
      file.notes = packed.at("notes").get<std::vector<std::string>>();
    }
    return files;
  }
  catch (const Json::exception& error)
  {
    throw Error(
      std::string("what another process says of its files cannot be read: ") + error.what());
  }
}

} // namespace nexrad
