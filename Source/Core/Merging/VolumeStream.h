// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/Merging/TimeMerge.h"
#include "nexrad/Series/ScannedFile.h"
#include "nexrad/Series/SeriesOutline.h"

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
#include <thread>
#include <utility>
#include <vector>

namespace nexrad
{

/// What a VolumeStream does with the files.
struct StreamWork
{
  /// Makes a decoded volume ready. Called from several threads at once.
  std::function<ReadyVolume(const RadarVolume&)> prepare;
  /// Which of a site's volumes are needed at a time, from their starts, which ascend, and ends.
  /// Once a volume that started before the time is not chosen, no later time may choose it.
  std::function<std::vector<std::size_t>(
    const std::vector<Time>& starts, const std::vector<Time>& ends, Time time)>
    choose;
};

/// The volumes about times that ascend, decoded a little ahead of them on threads of its own.
///
/// ```
///   files by the times of their headers    ──────────────────────────────────────▶
///                 dropped │ held: about the time │ decoded ahead │ not touched yet
///                                    ▲ time
/// ```
///
/// Each file is decoded once, and held only as long as a time may need it, so that memory does not
/// grow with the length of the day. Where to look is taken from the headers; what is chosen, from
/// the rays. A header that errs may therefore hide a volume: IsAsIn finds out.
class VolumeStream
{
public:
  /// Keeps references to nothing. `threads` decode, at least 1.
  VolumeStream(std::vector<std::filesystem::path> paths, std::vector<SiteOutline> outline,
    SeriesOptions options, StreamWork work, unsigned threads);
  ~VolumeStream();
  VolumeStream(const VolumeStream&) = delete;
  VolumeStream& operator=(const VolumeStream&) = delete;

  /// The last time that will be asked for, if it is known before the first: files that begin later
  /// are not decoded ahead.
  void EndAt(Time time);

  /// Begins to decode a file, by its index in the paths, for which Scan will ask.
  void Expect(std::size_t index);

  /// What a file holds, by its index in the paths. Its volumes are held for the first time that may
  /// need them.
  ScannedFile Scan(std::size_t index);

  /// The volumes of all sites that are needed at a time, which must not be before that of an
  /// earlier call. Throws what decoding threw, but for what is wrong in a file.
  std::vector<ReadyVolume> About(Time time);

  /// What was decoded so far; of other files an empty entry.
  std::vector<ScannedFile> Scanned() const;

  /// True when at each time so far the choice was the one that a scan of all files leads to.
  bool IsAsIn(const SeriesScan& scan) const;

private:
  struct HeldVolume
  {
    SeriesVolume volume;
    ReadyVolume ready;
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
    bool wanted = false; ///< somebody waits for it
    ScannedFile scanned;
    std::vector<HeldVolume> held; ///< until its site's window takes them
  };
  struct SiteWindow
  {
    SiteOutline outline;
    std::size_t next = 0; ///< in the outline's files: the first that was not taken yet
    std::vector<HeldVolume> held;
  };
  using Choice = std::vector<std::pair<std::filesystem::path, std::size_t>>; // file and cycle

  void Work();
  std::optional<std::size_t> NextFile();
  void Decode(std::size_t index);
  void Want(std::size_t index);
  void Begin(Time time);
  std::size_t LaterNeeded(const SiteWindow& site, std::size_t end, Time time) const;
  std::optional<std::size_t> Demand(const SiteWindow& site, Time time);
  void Take(SiteWindow& site, std::size_t end);
  void Choose(SiteWindow& site, Time time, std::vector<ReadyVolume>& chosen, Choice& choice);
  void WaitFor(std::unique_lock<std::mutex>& lock, const std::function<bool()>& there);

  const std::vector<std::filesystem::path> paths;
  const SeriesOptions options;
  const StreamWork work;

  mutable std::mutex mutex; // guards all that follows but the threads
  std::condition_variable changed;
  std::vector<File> files; // by index
  std::vector<SiteWindow> sites;
  std::deque<std::size_t> wanted;  // to be decoded first
  std::vector<OutlinedFile> order; // files that may be decoded ahead, by time
  std::size_t nextAhead = 0;       // in `order`
  Time reached{};                  // latest header's time of all files asked for
  Time lastTime = Time::max();     // that will be asked for
  bool begun = false;
  bool stopped = false;
  std::exception_ptr failure;
  std::map<Time, Choice> choices;
  std::vector<std::thread> threads;
};

} // namespace nexrad
