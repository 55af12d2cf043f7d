// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Series/InputFiles.h"
#include "nexrad/Series/ScannedFile.h"
#include "nexrad/System/RangeLoop.h"

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace nexrad
{

/// So many files a thread are decoded ahead of what was asked for: enough that no thread waits
/// while a volume is merged, few enough to need little memory.
constexpr std::size_t FilesAhead = 3;

/// What a Store does with the volumes.
struct StoreWork
{
  SeriesOptions options; ///< of a scan of the files, with a moment
  /// Makes a moment of a volume ready. Called from several threads at once.
  std::function<ReadyVolume(const std::shared_ptr<const PolarVolume>&)> prepare;
  VolumeRule rule;        ///< by which the volumes of a time are chosen
  bool summaries = false; ///< make the summaries of the volumes that Beam merges
};

/// The volumes of a list of files: what each file holds, as far as that is known, and the volumes
/// about any time, made ready for a merge. Files are decoded on threads of their own: those that a
/// time needs, and a few that follow it.
///
/// What is needed at a time is decided by the rays of the files about it; which files lie about it,
/// by their headers. A header that errs may hide a volume: MadeOf and HeadersErr tell. What a time
/// needs does not depend on the times asked for before. When times ascend, each file is decoded
/// once, and memory does not grow with the length of the day. For times in any order, moments are
/// kept within a limit of memory; those that were dropped are decoded again.
class Store
{
public:
  /// `headers` list the files that a time may need before it is known what they hold. `threads`
  /// decode, at least 1.
  Store(std::vector<std::filesystem::path> paths, FilesByRadar headers, unsigned threads);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  /// Times come in any order: so many bytes of decoded moments are kept for them. From Begin on
  /// nothing is decoded ahead of the first time, whose volume somebody waits for, and who may want
  /// no other.
  void KeepUpTo(std::size_t bytes);

  /// Begins to work, or anew. `listed` has the volumes of the files that are known. What is known
  /// of the files stays, and so do the moments that are kept: all work makes them in the same way.
  void Begin(StoreWork work, Catalogue listed);

  /// The last time that will be asked for, if it is known before the first: files that begin later
  /// are not decoded ahead.
  void EndAt(Time time);

  /// Begins to decode a file, by its index in the paths, for which Scan will ask; but not one of
  /// which it is known what it holds.
  void Expect(std::size_t index);

  /// What a file holds, by its index in the paths. Its volumes are held for the first time that may
  /// need them. Throws what decoding threw, but for what is wrong in a file.
  ScannedFile Scan(std::size_t index);

  /// The volumes that are needed at a time, of the sites that `wanted` names (all when it is
  /// empty), by moment, site and start. Of each moment these are chosen among the volumes that have
  /// it. Empty when `progress`, called from this thread alone, asked to stop. Throws what decoding
  /// threw, but for what is wrong in a file.
  std::optional<std::vector<ReadyVolume>> About(
    Time time, const std::vector<bool>& wanted = {}, const Progress& progress = {});

  /// The volumes of reflectivity that About gives at a time, WithoutSweeps and pictured; nothing is
  /// loaded. Empty as long as these are not known; where times come in any order, About finds them
  /// out.
  std::optional<BeamVolumes> EchoAbout(Time time);

  /// A volume of which nothing but the summary is there, for Beam: of a radar that does not reach a
  /// block, and of a time at which motion is searched and nothing merged. `pictured`: with what
  /// motion is searched in. As long as somebody holds it, it is the same object: a search for
  /// motion knows it again.
  std::shared_ptr<const BeamVolume> WithoutSweeps(
    const Site& site, const SeriesVolume& volume, MomentName moment, bool pictured);

  /// The files about a time of which nobody knows what they hold, by their index in the paths.
  std::vector<std::size_t> UnknownAbout(Time time) const;
  /// What is known of the volumes by now.
  Catalogue Listed() const;

  /// Finds out what the files about a time hold; of those that are known already none is decoded.
  /// False when `progress` asked to stop.
  bool Know(Time time, const Progress& progress = {});

  /// What a time is made of (Catalogue::MadeOf) by the files that are known.
  std::string MadeOf(Time time) const;
  /// The same when About last gave the volumes of a time, by the files that were known then.
  std::string LastMadeOf(Time time) const;

  /// What each path holds, as far as it is known; else IsUnknown.
  std::vector<ScannedFile> Known() const;
  /// Tells what a file holds; what is known of it already stays.
  void Learn(std::size_t index, const ScannedFile& scanned);
  /// Tells what all files hold, before Begin lists them.
  void LearnAll(std::vector<ScannedFile> all);
  /// Keeps a moment of a volume that somebody decoded, when there is room for it without dropping
  /// another: during a scan the earliest volumes stay, for which a run through the day asks first.
  void Offer(const SeriesVolume& volume, const std::shared_ptr<const PolarVolume>& moment);

  /// How many times a file was decoded.
  std::size_t DecodedFiles() const { return decodedFiles; }

  /// True when the rays of some file that is known are another radar's than its header says, or do
  /// not begin near the header's time, in the order of the headers.
  bool HeadersErr() const;

private:
  struct HeldVolume
  {
    std::size_t cycle = 0;
    std::vector<std::shared_ptr<const PolarVolume>> moments; ///< all that it has, or none
    std::vector<ReadyVolume> ready;                          ///< the same
    bool used = false;                                       ///< some time needed what is ready
  };
  enum class State
  {
    Waiting,
    Asked, ///< it is in `wanted`
    Running,
    Done
  };
  struct File
  {
    State state = State::Waiting;
    bool kept = false;      ///< Scan asked for it; held until some time needs it
    Time time{};            ///< as in `order`
    std::size_t site = 0;   ///< in the catalogue
    ScannedFile scanned;    ///< IsUnknown until it is decoded
    std::size_t bytes = 0;  ///< of the moments that are held
    std::size_t loaded = 0; ///< a number that grows with each load
    std::vector<HeldVolume> held;

    HeldVolume* Find(std::size_t cycle);
  };

  using FileRange =
    std::pair<std::vector<TimedFile>::const_iterator, std::vector<TimedFile>::const_iterator>;

  void End();
  void List();
  void Work();
  bool HoldsMoments(File& file) const;
  void Load(std::size_t index, File& file, bool keeps);
  // To be called with the lock:
  std::optional<std::size_t> NextFile();
  FileRange Ahead(Time time) const;
  void Keep(std::size_t index, File&& loaded);
  void LearnFile(std::size_t index);
  void Want(std::size_t index);
  bool IsWanted(std::size_t site) const;
  std::vector<std::size_t> UnknownAbout(std::size_t site, MomentName moment, Time time) const;
  bool KnowsAbout(Time time);
  std::vector<ChosenVolume> ChosenAt(Time time) const;
  std::optional<std::vector<ChosenVolume>> Demand(Time time);
  void Release(Time time, const std::vector<ChosenVolume>& needed);
  bool WaitFor(std::unique_lock<std::mutex>& lock, const std::function<bool()>& there,
    const Progress& progress = {});

  const std::vector<std::filesystem::path> paths;
  const FilesByRadar headers;
  const unsigned threadCount;
  std::atomic<std::size_t> decodedFiles{0};
  StoreWork work; // changes while no thread runs
  std::vector<MomentName> moments;

  mutable std::mutex mutex; // guards all that follows but the threads
  std::condition_variable changed;
  std::vector<File> files; // by index
  bool anyOrder = false;
  std::size_t limit = 0;          // of `used`
  std::size_t used = 0;           // bytes of the moments that are held
  std::size_t loads = 0;          // so far
  Catalogue catalogue;            // of all files; of unknown ones by their headers
  std::vector<TimedFile> order;   // all of these, by their first rays when work began, or headers
  std::deque<std::size_t> wanted; // to be decoded first
  std::vector<bool> wantedSites;  // by the last time; empty: all
  std::optional<Time> reached;    // the latest of the files that were needed since times ascend
  Time current = Time::min();     // that was asked for last
  Time lastTime = Time::max();    // that will be asked for
  bool looksAhead = true;         // a file is decoded before a time needs it
  bool stopped = false;
  std::exception_ptr failure;
  std::map<Time, std::string> made;
  std::map<std::tuple<std::filesystem::path, std::size_t, MomentName, bool>,
    std::weak_ptr<const BeamVolume>>
    withoutSweeps;
  ThreadGroup threads;
};

} // namespace nexrad
