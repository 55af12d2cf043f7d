// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Series/ScanInputs.h"

#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"
#include "nexrad/System/RangeLoop.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <iterator>
#include <mutex>
#include <numeric>
#include <tuple>

// What one process tells another of its files, member by member.

namespace nlohmann
{

template <class Value>
struct adl_serializer<std::optional<Value>>
{
  static void to_json(json& packed, const std::optional<Value>& value)
  {
    packed = value ? json(*value) : json();
  }
  static void from_json(const json& packed, std::optional<Value>& value)
  {
    value = packed.is_null() ? std::nullopt : std::optional(packed.get<Value>());
  }
};

template <class Value>
struct adl_serializer<std::shared_ptr<const Value>>
{
  static void to_json(json& packed, const std::shared_ptr<const Value>& value)
  {
    packed = value ? json(*value) : json();
  }
  static void from_json(const json& packed, std::shared_ptr<const Value>& value)
  {
    value = packed.is_null() ? nullptr : std::make_shared<const Value>(packed.get<Value>());
  }
};

template <>
struct adl_serializer<nexrad::Duration>
{
  static void to_json(json& packed, nexrad::Duration value) { packed = value.count(); }
  static void from_json(const json& packed, nexrad::Duration& value)
  {
    value = nexrad::Duration(packed.get<nexrad::Duration::rep>());
  }
};

template <>
struct adl_serializer<nexrad::Time>
{
  static void to_json(json& packed, nexrad::Time value) { packed = value.time_since_epoch(); }
  static void from_json(const json& packed, nexrad::Time& value)
  {
    value = nexrad::Time(packed.get<nexrad::Duration>());
  }
};

} // namespace nlohmann

namespace nexrad
{

using Json = nlohmann::json;

// The pictures are long: as bytes.
void to_json(Json& packed, const PackedComposite& composite)
{
  std::vector<std::uint8_t> bytes(composite.picture.size() * sizeof(float));
  std::memcpy(bytes.data(), composite.picture.data(), bytes.size());
  packed = {composite.rings, composite.echoTime, composite.echo, Json::array(),
    Json::binary(std::move(bytes))};
  for (const VolumeComposite::Tilt& tilt : composite.tilts)
  {
    packed[3].push_back({tilt.elevation, tilt.echo});
  }
}

void from_json(const Json& packed, PackedComposite& composite)
{
  composite.rings = packed.at(0);
  composite.echoTime = packed.at(1);
  composite.echo = packed.at(2);
  for (const Json& tilt : packed.at(3))
  {
    composite.tilts.push_back({tilt.at(0), tilt.at(1)});
  }
  const Json::binary_t& bytes = packed.at(4).get_binary();
  composite.picture.resize(bytes.size() / sizeof(float));
  std::memcpy(composite.picture.data(), bytes.data(), composite.picture.size() * sizeof(float));
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(VolumeSummary, reach, composite, lowest)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Position, latitude, longitude, altitude)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Site, name, position)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(LowEcho, site, start, time, firstLayer, layers, cells)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SeriesVolume, file, origin, cycle, start, end, begun, left, rays,
  reach, synthetic, summary, lowEcho, moments, echo, endsAt)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(InputProblem, file, offset, what, leftOut, isMissingEnd)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(ScannedFile, origin, volumes, problems, notes)

namespace
{

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

} // namespace

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

std::optional<std::vector<ScannedFile>> ScanEach(const std::vector<std::filesystem::path>& paths,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  // Each decoding holds a whole volume in memory, so their number is bounded; the other cores help
  // to decompress.
  constexpr std::size_t mostAtOnce = 8;
  const unsigned wanted = options.threads > 0 ? options.threads : CoreCount();
  const std::size_t atOnce = std::min<std::size_t>({wanted, mostAtOnce, paths.size()});
  SeriesOptions own = options;
  const unsigned each = atOnce > 0 ? std::max(1U, wanted / static_cast<unsigned>(atOnce)) : 0U;
  own.level2.threads = own.level2.threads > 0 ? own.level2.threads : each;
  std::vector<ScannedFile> files(paths.size()); // each written by the thread that scans it
  std::atomic<std::size_t> next{0};
  std::mutex mutex; // guards what follows
  std::condition_variable changed;
  std::size_t done = 0;
  bool stopped = false;
  std::exception_ptr failure;
  const auto work = [&]
  {
    for (std::size_t index = next++; index < paths.size(); index = next++)
    {
      std::exception_ptr thrown;
      try
      {
        files[index] = ScanFile(paths[index], own, visitor);
      }
      catch (...)
      {
        thrown = std::current_exception();
      }
      const std::lock_guard<std::mutex> lock(mutex);
      ++done;
      failure = failure ? failure : thrown;
      changed.notify_all();
      if (failure || stopped)
      {
        return;
      }
    }
  };
  ThreadGroup threads(atOnce, work, 1);
  std::unique_lock<std::mutex> lock(mutex);
  for (std::size_t told = 0; told < paths.size() && !stopped && !failure; told = done)
  {
    lock.unlock();
    const bool goOn =
      !progress || progress(static_cast<double>(told) / static_cast<double>(paths.size()));
    lock.lock();
    stopped = !goOn;
    changed.wait(lock, [&] { return stopped || failure || done > told; });
  }
  lock.unlock();
  threads.Join();
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  return stopped ? std::nullopt : std::optional(std::move(files));
}

std::optional<SeriesScan> ScanInputs(const std::vector<std::filesystem::path>& inputs,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  const InputFiles found = FindInputFiles(inputs);
  const auto files = ScanEach(found.paths, options, visitor, progress);
  return files ? std::optional(CollectSeries(found.problems, *files)) : std::nullopt;
}

std::optional<std::vector<ScannedFile>> FindTogether(
  const std::vector<std::filesystem::path>& paths, const Processes& processes, ScanOrder scanOrder,
  const FileFinder& find)
{
  std::string names;
  for (const std::filesystem::path& path : paths)
  {
    names += path.filename().string() + '\n';
  }
  processes.RequireSame(names, "the processes need different files; all need the same options");
  std::vector<std::size_t> order;
  std::optional<std::vector<ScannedFile>> own;
  const auto findOwn = [&]
  {
    order = OrderByHeaders(paths, scanOrder);
    const auto [begin, end] = processes.Part(paths.size());
    const auto first = order.begin();
    own =
      find({first + static_cast<std::ptrdiff_t>(begin), first + static_cast<std::ptrdiff_t>(end)});
  };
  processes.Together(findOwn);
  if (!processes.InAll(own.has_value()))
  {
    return std::nullopt;
  }
  std::vector<ScannedFile> all;
  for (const std::string& message : processes.Exchange(PackScannedFiles(*own)))
  {
    std::vector<ScannedFile> part = UnpackScannedFiles(message);
    std::move(part.begin(), part.end(), std::back_inserter(all));
  }
  std::vector<ScannedFile> files(paths.size());
  for (std::size_t place = 0; place < paths.size(); ++place)
  {
    files.at(order[place]) = std::move(all.at(place));
  }
  return files;
}

std::optional<std::vector<ScannedFile>> ScanTogether(
  const std::vector<std::filesystem::path>& paths, const Processes& processes, ScanOrder order,
  const SeriesOptions& options, const VolumeVisitor& visitor, const Progress& progress)
{
  const auto scan = [&](const std::vector<std::size_t>& places)
  {
    std::vector<std::filesystem::path> part;
    for (const std::size_t place : places)
    {
      part.push_back(paths[place]);
    }
    return ScanEach(part, options, visitor, progress);
  };
  return FindTogether(paths, processes, order, scan);
}

std::string PackScannedFiles(const std::vector<ScannedFile>& files)
{
  // Not as text: a file's name need not be UTF-8.
  const std::vector<std::uint8_t> bytes = Json::to_cbor(files);
  return {bytes.begin(), bytes.end()};
}

std::vector<ScannedFile> UnpackScannedFiles(const std::string& bytes)
{
  try
  {
    return Json::from_cbor(bytes).get<std::vector<ScannedFile>>();
  }
  catch (const Json::exception& error)
  {
    throw Error(
      std::string("what another process says of its files cannot be read: ") + error.what());
  }
}

} // namespace nexrad
