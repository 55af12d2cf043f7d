// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Live/FolderListing.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Live/ChunkedVolume.h"
#include "nexrad/Live/LiveSeries.h"
#include "nexrad/Series/VolumeSelection.h"

#include <chrono>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace nexrad::application
{

/// A feed that is played again from its records.
struct ReplayRequest
{
  Time begin{};       ///< what the clock shows at the start
  double speed = 1.0; ///< how many times as fast as the real clock it runs; above 0
};

/// The clock by which the ages of data are told and chunks are waited for.
class LiveClock
{
public:
  explicit LiveClock(const std::optional<ReplayRequest>& theReplay)
    : replay(theReplay)
  {
  }

  /// The time in UTC. It jumps as the clock of the machine does.
  Time Now() const
  {
    return replay ? replay->begin + this->Elapsed()
                  : std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());
  }
  /// Time since the start; it never jumps.
  Duration Elapsed() const
  {
    const std::chrono::duration<double> real = std::chrono::steady_clock::now() - begun;
    return DurationOf(real.count() * (replay ? replay->speed : 1.0));
  }

private:
  const std::optional<ReplayRequest> replay;
  const std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now();
};

/// What became of the files that arrived of one radar, chunks or whole volumes. Each file that
/// arrived counts once among those that are used, repeated, replacing, refused or old, or it waits.
struct ArrivalCounts
{
  std::size_t used = 0;        ///< decoded, or waiting for a missing chunk before them
  std::size_t late = 0;        ///< of these, came after a chunk with a higher number
  std::size_t cut = 0;         ///< of these, never became whole: what could be read of them is used
  std::size_t repeated = 0;    ///< came again with the same bytes
  std::size_t replaced = 0;    ///< came again with other bytes, which took the place of the first
  std::size_t refused = 0;     ///< cannot be used; standard error says why
  std::size_t old = 0;         ///< of a volume that no time step may use any more
  std::size_t halfWritten = 0; ///< were seen before they were whole, however they went on
  std::size_t missing = 0;     ///< numbers of chunks that never came, of volumes that are finished

  ArrivalCounts& operator+=(const ArrivalCounts& other)
  {
    used += other.used;
    late += other.late;
    cut += other.cut;
    repeated += other.repeated;
    replaced += other.replaced;
    refused += other.refused;
    old += other.old;
    halfWritten += other.halfWritten;
    missing += other.missing;
    return *this;
  }
};

/// How long is waited for what does not come.
struct IntakeRules
{
  Level2Options level2;
  Duration patience = std::chrono::seconds(30); ///< for a chunk that is missing or half-written,
                                                ///< by the clock of the data
  Duration idle = std::chrono::minutes(10);     ///< for anything of a volume in progress
  std::chrono::milliseconds settle = std::chrono::seconds(2); ///< how long a file must not have
                                                              ///< grown that does not tell its
                                                              ///< length; real time
  Duration longestPause = LongestPause; ///< what is older than the feed by more is none of it
};

/// A volume that has more complete sweeps than before, or is finished.
struct IntakeChange
{
  LiveInput input;
  /// When the last byte came that completed its newest sweep; empty where a missing chunk was
  /// given up.
  std::optional<std::filesystem::file_time_type> completed;
  bool isTakenBack = false; ///< it was used, and proved to be older than the feed; without rays
};

/// What arrives of one radar.
struct ArrivingRadar
{
  std::string volume;               ///< name of the newest volume: its chunks' folder, or its file
  std::vector<SweepArrival> sweeps; ///< of it
  bool finished = false;            ///< nothing more is expected of it
  std::vector<int> awaited;         ///< numbers of chunks of it that are missing now
  std::size_t waiting = 0;          ///< files that are not whole yet
  ArrivalCounts counts;             ///< of all its volumes since the start
};

/// Makes volumes of the files that arrive, chunks of volumes or whole ones, in any order: late,
/// repeated, half-written or not at all.
///
/// The sweeps of a volume that arrives in chunks are used as they become complete. What follows a
/// missing chunk waits for it as long as the rules say. The volume is finished when its last chunk
/// is there and none before it is missing or waited for, when a later volume of the radar has begun
/// and nothing more came for as long, or when nothing came for the longer time of the rules. What
/// comes afterwards opens it again. A finished volume is what ReadLevel2 reads of its folder.
///
/// Where the newest files are near the clock, the feed is what goes back from them without a longer
/// pause than the rules allow; elsewhere, as with an archive, what is not older than its newest
/// file by more. A file from before the feed is named once, counted as old and passed over.
class LiveIntake
{
public:
  /// `clock` must outlive this object.
  LiveIntake(const IntakeRules& rules, const LiveClock& clock);

  /// Files that came or changed; they are taken in the order of their volumes' times.
  void Arrive(const std::vector<ArrivedFile>& files);
  /// True while some of them have not been taken.
  bool IsBehind() const { return !queue.empty(); }

  /// Takes files for about `longest`, at most up to the next pause in their times, and gives up
  /// waiting where it is time. Returns what changed. Files that are not whole yet are watched in
  /// the listing.
  std::vector<IntakeChange> Take(FolderListing& listing, std::chrono::milliseconds longest);

  /// Nothing more comes: finishes all volumes with what is there.
  std::vector<IntakeChange> FinishAll(FolderListing& listing);

  /// Files of volumes that begin before this time are passed over, and such volumes are forgotten.
  void SetOldest(Time time);

  /// What arrives, by the radars' names; "" has what belongs to none yet.
  std::map<std::string, ArrivingRadar> Radars() const;
  /// Time of the earliest volume of which a file is not whole yet; empty without any.
  std::optional<Time> OldestWaiting() const;
  /// Since the last file came.
  Duration SilentFor() const { return clock.Elapsed() - lastArrival; }

  /// What was wrong with files since the last call, a line each.
  std::vector<std::string> TakeProblems();

private:
  using FileTime = std::filesystem::file_time_type;
  struct Queued
  {
    ArrivedFile file;
    std::optional<Chunk> chunk;
    std::optional<Time> time; ///< of its volume, by its name or its header
  };
  struct WaitingFile
  {
    Queued queued;
    Duration since{};                                  ///< by the clock, when it last grew
    std::chrono::steady_clock::time_point realSince{}; ///< the same in real time
    ChunkExtent extent = ChunkExtent::Cut;
  };
  struct Volume
  {
    std::filesystem::path path; ///< of the file, or of the folder of the chunks
    std::string stamp;          ///< of the chunks
    std::optional<Time> time;
    std::unique_ptr<ChunkedVolume> chunks; ///< nullptr: a file of the whole volume
    std::optional<RadarVolume> whole;      ///< the file's, until it is handed on
    std::map<std::filesystem::path, std::pair<std::uintmax_t, FileTime>> files; ///< that were taken
    std::string radar;
    std::vector<SweepArrival> sweeps;
    std::size_t completeSweeps = 0;
    std::optional<FileTime> newestByte; ///< of the files taken since the last sweep was complete
    bool gaveUp = false;                ///< since then, something was waited for in vain
    std::optional<Duration> gapSince;   ///< since when a number is missing
    int firstMissing = 0;
    Duration lastArrival{};
    bool dirty = false;
    bool again = false; ///< what was decoded before changed
    bool expired = false;
    bool isOld = false;   ///< older than the feed
    bool isStray = false; ///< was used before that was known
    bool finished = false;
    ArrivalCounts counts;
  };

  void TakeQueued(const Queued& queued, FolderListing& listing, bool asItIs);
  bool HasSettled(FileTime changed, ChunkExtent extent) const;
  bool IsReadable(const Queued& queued, Volume& volume);
  void Wait(const Queued& queued, ChunkExtent extent, Volume& volume);
  void AddChunk(const Queued& queued, Volume& volume, std::vector<std::uint8_t> bytes);
  bool Reopen(Volume& volume);
  void AddFile(const Queued& queued, Volume& volume, std::vector<std::uint8_t> bytes);
  void TakeWaiting(FolderListing& listing, bool all);
  static void GiveUpMissing(Volume& volume);
  void GiveUpWaiting();
  bool IsSuperseded(const Volume& volume) const;
  std::vector<IntakeChange> Changes();
  std::optional<IntakeChange> ChangeOf(const std::string& key, Volume& volume);
  std::optional<IntakeChange> ChangeOfChunks(const std::string& key, Volume& volume);
  bool IsUsable(const RadarVolume& decoded, Volume& volume);
  void FindFeed();
  void FindStrays();
  void PassOver(Time time, Volume& volume);
  IntakeChange TakeBack(const std::string& key, Volume& volume);
  void Refuse(const std::filesystem::path& path, Volume& volume, const std::string& why);

  const IntakeRules rules;
  const LiveClock& clock;
  std::deque<Queued> queue;
  std::map<std::filesystem::path, WaitingFile> waiting;
  std::map<std::string, Volume> volumes;
  std::map<std::string, ArrivalCounts> forgotten; ///< by radar
  std::optional<Time> oldest;
  std::optional<Time> newestUsed; ///< last ray of all that was used
  std::optional<Time> feedBegin;
  Duration lastArrival{};
  std::vector<std::string> problems;
};

} // namespace nexrad::application
