// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/KeptValues.h"
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

/// Moments of volumes that were decoded, by moment, cycle and file.
using PolarCache = KeptValues<std::tuple<MomentName, std::size_t, std::filesystem::path>,
  std::shared_ptr<const PolarVolume>>;

/// What a VolumeLoader does with the volumes.
struct LoaderWork
{
  /// Makes a moment of a volume ready. Called from several threads at once.
  std::function<ReadyVolume(const std::shared_ptr<const PolarVolume>&)> prepare;
  VolumeRule rule; ///< by which the volumes of a time are chosen
};

/// The files of a series, by radar and time.
struct SeriesFiles
{
  std::vector<std::filesystem::path> paths;
  std::vector<SiteFileList> sites; ///< by name
  std::vector<ScannedFile> known;  ///< what each path holds; IsUnknown where nobody knows; may be
                                   ///< empty
  Catalogue listed;                ///< of the files that are known, its radars as in `sites`
};

/// The volumes about any time, made ready for a merge. Files are decoded on threads of their own:
/// those that a time needs, and a few that follow it.
///
/// What is needed at a time is decided by the rays of the files about it; which files lie about it,
/// by the times that SeriesFiles has for them. Where these are those of the files' headers, a
/// header that errs may hide a volume: Made and HeadersErr tell. What a time needs does
/// not depend on the times asked for before. When times ascend, each file is decoded once, and
/// memory does not grow with the length of the day; when they do not, a file is taken from the
/// cache, or decoded again. With a cache nothing is decoded ahead of the first time, whose volume
/// somebody waits for, and who may want no other.
class VolumeLoader
{
public:
  /// `options` are those of a scan of the files, with a moment; `cache` keeps volumes for times in
  /// any order, and may be nullptr. `threads` decode, at least 1.
  VolumeLoader(SeriesFiles files, SeriesOptions options, LoaderWork work,
    std::shared_ptr<PolarCache> cache, unsigned threads);
  ~VolumeLoader();
  VolumeLoader(const VolumeLoader&) = delete;
  VolumeLoader& operator=(const VolumeLoader&) = delete;

  /// The last time that will be asked for, if it is known before the first: files that begin later
  /// are not decoded ahead.
  void EndAt(Time time);

  /// Begins to decode a file, by its index in the paths, for which Scan will ask.
  void Expect(std::size_t index);

  /// What a file holds, by its index in the paths. Its volumes are held for the first time that may
  /// need them. Throws what decoding threw, but for what is wrong in a file.
  ScannedFile Scan(std::size_t index);

  /// The volumes that are needed at a time, of the sites that `wanted` names (all when it is
  /// empty), by moment, site and start. Of each moment these are chosen among the volumes that have
  /// it. Empty when `progress`, called from this thread alone, asked to
  /// stop. Throws what decoding threw, but for what is wrong in a file.
  std::optional<std::vector<ReadyVolume>> About(
    Time time, const std::vector<bool>& wanted = {}, const Progress& progress = {});

  /// The volumes of reflectivity that About gives at a time, with their summaries; nothing is
  /// loaded. Empty as long as these are not known; with a cache, About finds them out.
  std::optional<std::vector<std::pair<Site, SeriesVolume>>> EchoAbout(Time time);

  /// Finds out what the files about a time hold; of those that are known already none is decoded.
  /// False when `progress` asked to stop.
  bool Know(Time time, const Progress& progress = {});

  /// What a time is made of (Catalogue::MadeOf) by the files that are known.
  std::string MadeOf(Time time) const;

  /// What each path holds, as far as it is known; else IsUnknown.
  std::vector<ScannedFile> Known() const;

  /// Tells what a file holds; what is known of it already stays.
  void Learn(std::size_t index, const ScannedFile& scanned);

  /// How many times a file was decoded.
  std::size_t DecodedFiles() const { return decodedFiles; }

  /// True when the rays of some file decoded so far are another radar's than its header says, or do
  /// not begin near the header's time, in the order of the headers.
  bool HeadersErr() const;

  /// What About gave the volumes of for each time so far, by the files that were known then.
  const std::map<Time, std::string>& Made() const { return made; }

private:
  struct HeldVolume
  {
    SeriesVolume volume;
    std::vector<ReadyVolume> ready; ///< each moment that was asked for and that it has
    bool used = false;              ///< some time needed it

    const ReadyVolume& Of(MomentName moment) const;
  };
  enum class State
  {
    Waiting,
    Running,
    Done
  };
  struct File
  {
    State state = State::Waiting;
    bool asked = false;   ///< it is in `wanted`
    bool kept = false;    ///< Scan asked for it; held until some time needs it
    Time time{};          ///< of its header
    std::size_t site = 0; ///< in `sites`
    ScannedFile scanned;  ///< IsUnknown until it is decoded
    std::vector<HeldVolume> held;
  };

  void Work();
  std::optional<std::size_t> NextFile();
  std::vector<TimedFile>::const_iterator FirstAhead(Time time) const;
  std::vector<TimedFile>::const_iterator EndOfAhead(Time time) const;
  std::vector<HeldVolume> Load(std::size_t index, ScannedFile& scanned);
  static void AddSummaries(const std::vector<HeldVolume>& held, ScannedFile& scanned);
  void Keep(std::size_t index, ScannedFile scanned, std::vector<HeldVolume> held);
  void LearnFile(std::size_t index, const ScannedFile& scanned);
  void Want(std::size_t index);
  bool IsWanted(std::size_t site) const;
  std::vector<HeldVolume> FindKept(const ScannedFile& scanned);
  bool TakesStarted(std::size_t site, MomentName moment, Time time) const;
  bool KnowsAbout(std::size_t site, MomentName moment, Time time);
  bool KnowsAbout(Time time);
  bool KnowsWithoutLoading(Time time);
  std::vector<ChosenVolume> ChosenAt(Time time) const;
  HeldVolume* FindHeld(const SeriesVolume& volume);
  std::optional<std::vector<ChosenVolume>> Demand(Time time);
  void Release(Time time, const std::vector<ChosenVolume>& needed);
  bool WaitFor(std::unique_lock<std::mutex>& lock, const std::function<bool()>& there,
    const Progress& progress = {});

  const std::vector<std::filesystem::path> paths;
  const SeriesOptions options;
  const std::vector<MomentName> moments;
  const LoaderWork work;
  const std::shared_ptr<PolarCache> cache;
  const unsigned threadCount;
  const std::vector<SiteFileList> sites;
  std::atomic<std::size_t> decodedFiles{0};

  mutable std::mutex mutex; // guards all that follows but the threads
  std::condition_variable changed;
  std::vector<File> files;        // by index
  Catalogue catalogue;            // of the files that are known
  std::deque<std::size_t> wanted; // to be decoded first
  std::vector<bool> wantedSites;  // by the last time; empty: all
  std::vector<TimedFile> order;   // all, by time
  std::optional<Time> reached;    // latest header's time of the files that the last time needed
  Time current = Time::min();     // that was asked for last
  std::optional<Time> farthest;   // the latest `reached` since times ascend: it shrinks again once
                                  // files are known that were asked for in case they are needed
  Time lastTime = Time::max();    // that will be asked for
  bool looksAhead;                // a file is decoded before a time needs it
  bool stopped = false;
  std::exception_ptr failure;
  std::map<Time, std::string> made;
  ThreadGroup threads;
};

} // namespace nexrad
