// SPDX-License-Identifier: BSD-3-Clause
#include "Live/LiveIntake.h"

#include "Output/MessageOutput.h"
#include "nexrad/Archives/StoredFiles.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <new>
#include <tuple>

namespace fs = std::filesystem;

namespace nexrad::application
{
namespace
{

// A header's time is that of another clock than the rays'.
constexpr auto clockError = std::chrono::hours(1);
constexpr auto rayClockError = std::chrono::minutes(10);

// "20060312-180000" as a time.
std::optional<Time> TimeOfStamp(const std::string& stamp)
{
  return ParseIso8601(stamp.substr(0, 4) + '-' + stamp.substr(4, 2) + '-' + stamp.substr(6, 2) +
                      'T' + stamp.substr(9, 2) + ':' + stamp.substr(11, 2) + ':' +
                      stamp.substr(13, 2));
}

// Tells the volume of a file from all others: the file, or what its chunks have in common.
std::string VolumeKey(const fs::path& path, const std::optional<Chunk>& chunk)
{
  return chunk ? (path.parent_path() / chunk->volume).string() : path.string();
}

} // namespace

LiveIntake::LiveIntake(const IntakeRules& theRules, const LiveClock& theClock)
  : rules(theRules)
  , clock(theClock)
{
}

void LiveIntake::Arrive(const std::vector<ArrivedFile>& files)
{
  for (const ArrivedFile& file : files)
  {
    std::optional<Chunk> chunk = ParseChunkName(file.path);
    const auto time = chunk ? TimeOfStamp(chunk->volume)
                            : PeekVolumeHeader(file.path).value_or(VolumeHeader()).time;
    queue.push_back({file, std::move(chunk), time});
  }
  if (!files.empty())
  {
    this->FindFeed();
    this->FindStrays();
  }
  lastArrival = files.empty() ? lastArrival : clock.Elapsed();
  const auto place = [](const Queued& each)
  { return std::tuple(each.time.value_or(Time()), each.chunk ? each.chunk->number : 0); };
  std::stable_sort(queue.begin(), queue.end(),
    [&place](const Queued& a, const Queued& b) { return place(a) < place(b); });
}

// The begin of the feed moves on as time goes by; it stays where the clock jumps away from the
// data.
void LiveIntake::FindFeed()
{
  std::vector<Time> times;
  const Time now = clock.Now();
  const auto add = [&times, now](const std::optional<Time>& time)
  {
    if (time && *time <= now + clockError)
    {
      times.push_back(*time);
    }
  };
  std::for_each(queue.begin(), queue.end(), [&add](const Queued& each) { add(each.time); });
  std::for_each(volumes.begin(), volumes.end(),
    [&add](const auto& each) { each.second.isOld ? void() : add(each.second.time); });
  std::sort(times.rbegin(), times.rend());
  if (times.empty() || now - times.front() > rules.longestPause)
  {
    if (newestUsed && *newestUsed <= now + clockError)
    {
      const Time begin = *newestUsed - rules.longestPause;
      feedBegin = std::max(feedBegin.value_or(begin), begin);
    }
    return;
  }
  Time begin = times.front();
  for (const Time time : times)
  {
    if (begin - time > rules.longestPause)
    {
      break;
    }
    begin = time;
  }
  feedBegin = std::max(feedBegin.value_or(begin), begin);
}

// Files that came before the first ones of the feed look like an archive. As long as no time step
// is done with, what was made of them can be taken back.
void LiveIntake::FindStrays()
{
  for (auto& [key, volume] : volumes)
  {
    const bool isBefore = feedBegin && volume.time && *volume.time < *feedBegin;
    if (isBefore && !oldest && !volume.isOld && !volume.sweeps.empty())
    {
      volume.isStray = true;
      volume.dirty = true;
    }
  }
}

// Names a volume that is older than the feed; what was taken of it counts as old.
void LiveIntake::PassOver(Time time, Volume& volume)
{
  volume.counts.old += std::exchange(volume.counts.used, 0);
  if (!std::exchange(volume.isOld, true))
  {
    problems.push_back(volume.path.string() + ": is of " + FormatIso8601(time) +
                       ", long before the feed, which goes back to " + FormatIso8601(*feedBegin) +
                       ": passed over as old");
  }
}

std::vector<IntakeChange> LiveIntake::Take(
  FolderListing& listing, std::chrono::milliseconds longest)
{
  const auto end = std::chrono::steady_clock::now() + longest;
  this->TakeWaiting(listing, false);
  std::optional<Time> before;
  while (!queue.empty() && std::chrono::steady_clock::now() < end)
  {
    const std::optional<Time>& time = queue.front().time;
    if (before && time && *time - *before > rules.longestPause)
    {
      break; // what was scanned before the pause is done with first
    }
    const bool isOfFeed = time && (!feedBegin || *time >= *feedBegin);
    before = isOfFeed ? time : before;
    const Queued queued = std::move(queue.front());
    queue.pop_front();
    this->TakeQueued(queued, listing, false);
  }
  this->GiveUpWaiting();
  return this->Changes();
}

std::vector<IntakeChange> LiveIntake::FinishAll(FolderListing& listing)
{
  this->TakeWaiting(listing, true);
  for (auto& [key, volume] : volumes)
  {
    if (!volume.finished && volume.chunks)
    {
      GiveUpMissing(volume);
      volume.expired = true;
    }
  }
  return this->Changes();
}

// One file, which may wait until it is whole; `asItIs`: no longer.
void LiveIntake::TakeQueued(const Queued& queued, FolderListing& listing, bool asItIs)
{
  const fs::path& path = queued.file.path;
  const auto [place, isNew] = volumes.try_emplace(VolumeKey(path, queued.chunk));
  Volume& volume = place->second;
  if (isNew)
  {
    volume.path = queued.chunk ? path.parent_path() : path;
    volume.stamp = queued.chunk ? queued.chunk->volume : "";
    volume.time = queued.time;
  }
  const auto taken = volume.files.find(path);
  if (taken != volume.files.end() &&
      taken->second == std::pair(queued.file.size, queued.file.changed))
  {
    return; // it was read after its last change already
  }
  try
  {
    if (!this->IsReadable(queued, volume))
    {
      return;
    }
    std::vector<std::uint8_t> bytes = ReadStoredBytes(path, rules.level2.maximumFileBytes);
    const ByteView view(bytes.data(), bytes.size());
    const ChunkExtent extent = queued.chunk ? ExtentOfChunk(view) : ExtentOfFile(view);
    const bool isOld = this->HasSettled(queued.file.changed, extent);
    if (extent != ChunkExtent::Whole && !asItIs && !isOld)
    {
      this->Wait(queued, extent, volume);
      listing.Watch(path, true);
      return;
    }
    listing.Watch(path, false);
    waiting.erase(path);
    volume.counts.cut += extent == ChunkExtent::Cut ? 1 : 0;
    volume.lastArrival = clock.Elapsed();
    volume.gaveUp = volume.gaveUp || extent == ChunkExtent::Cut;
    volume.newestByte =
      std::max(volume.newestByte.value_or(queued.file.changed), queued.file.changed);
    queued.chunk ? this->AddChunk(queued, volume, std::move(bytes))
                 : this->AddFile(queued, volume, std::move(bytes));
    volume.files[path] = {queued.file.size, queued.file.changed};
  }
  catch (const Error& error)
  {
    this->Refuse(path, volume, error.what());
  }
  catch (const std::bad_alloc&)
  {
    this->Refuse(path, volume, path.string() + ": needs more memory than there is: left out");
  }
}

void LiveIntake::Refuse(const fs::path& path, Volume& volume, const std::string& why)
{
  waiting.erase(path);
  ++volume.counts.refused;
  problems.push_back(why);
}

// Whether so much time has passed since the last byte of a file that no more is expected. The clock
// of another machine may have set its time.
bool LiveIntake::HasSettled(FileTime changed, ChunkExtent extent) const
{
  const auto since = FileTime::clock::now() - changed;
  return extent == ChunkExtent::Cut ? since > rules.patience : since > rules.settle;
}

std::optional<Time> LiveIntake::OldestWaiting() const
{
  std::optional<Time> oldestTime;
  for (const auto& [path, file] : waiting)
  {
    const std::optional<Time>& time = file.queued.time;
    oldestTime = time && (!oldestTime || *time < *oldestTime) ? time : oldestTime;
  }
  return oldestTime;
}

// False for a file that is passed over by its time.
bool LiveIntake::IsReadable(const Queued& queued, Volume& volume)
{
  if (queued.time && feedBegin && *queued.time < *feedBegin)
  {
    this->PassOver(*queued.time, volume);
    ++volume.counts.old;
    return false;
  }
  if (queued.time && oldest && *queued.time < *oldest)
  {
    ++volume.counts.old;
    return false;
  }
  if (queued.time && *queued.time > clock.Now() + clockError)
  {
    throw Error(queued.file.path.string() + ": is dated " + FormatIso8601(*queued.time) +
                ", in the future: left out");
  }
  if (FindArchive(queued.file.path))
  {
    throw Error(queued.file.path.string() + ": an archive, which is not followed: left out");
  }
  if (!queued.chunk && !LooksLikeLevel2(queued.file.path) && queued.file.size > 0)
  {
    throw Error(queued.file.path.string() + ": " + WhyNotLevel2(queued.file.path) + ": left out");
  }
  return true;
}

void LiveIntake::Wait(const Queued& queued, ChunkExtent extent, Volume& volume)
{
  const auto found = waiting.find(queued.file.path);
  const bool isNew = found == waiting.end();
  volume.counts.halfWritten += isNew && extent == ChunkExtent::Cut ? 1 : 0;
  if (isNew || found->second.queued.file.size != queued.file.size)
  {
    waiting[queued.file.path] = {queued, clock.Elapsed(), std::chrono::steady_clock::now(), extent};
  }
}

// Takes files that were waited for long enough.
void LiveIntake::TakeWaiting(FolderListing& listing, bool all)
{
  std::vector<Queued> over;
  for (const auto& [path, file] : waiting)
  {
    const bool cut = file.extent == ChunkExtent::Cut;
    const bool settled = std::chrono::steady_clock::now() - file.realSince > rules.settle;
    const bool isOver = cut ? clock.Elapsed() - file.since > rules.patience : settled;
    if (all || isOver)
    {
      over.push_back(file.queued);
    }
  }
  for (const Queued& queued : over)
  {
    this->TakeQueued(queued, listing, true);
  }
}

void LiveIntake::AddChunk(const Queued& queued, Volume& volume, std::vector<std::uint8_t> bytes)
{
  if (!volume.chunks)
  {
    volume.chunks = std::make_unique<ChunkedVolume>(volume.path.string(), rules.level2);
  }
  const ChunkedVolume::Place place = {queued.chunk->number, queued.chunk->kind};
  const std::string name = queued.file.path.filename().string();
  auto arrival = volume.chunks->Add(place, name, bytes);
  const bool reopened = arrival == ChunkedVolume::Arrival::Closed;
  if (reopened)
  {
    if (!this->Reopen(volume))
    {
      throw Error(queued.file.path.string() +
                  ": came after the other chunks of its volume were removed: left out");
    }
    arrival = volume.chunks->Add(place, name, std::move(bytes));
    volume.again = true;
    if (arrival == ChunkedVolume::Arrival::Repeated) // read again with the others
    {
      arrival = ChunkedVolume::Arrival::Replaced;
    }
  }
  ArrivalCounts& counts = volume.counts;
  switch (arrival)
  {
  case ChunkedVolume::Arrival::Repeated:
    ++counts.repeated;
    return;
  case ChunkedVolume::Arrival::Replaced:
    ++counts.replaced;
    volume.again = true;
    break;
  default:
    ++counts.used;
    counts.late += arrival == ChunkedVolume::Arrival::Late ? 1 : 0;
    volume.again = volume.again || arrival == ChunkedVolume::Arrival::Late;
  }
  volume.dirty = true;
}

// Reads the chunks of a finished volume once more. False when one of them is gone.
bool LiveIntake::Reopen(Volume& volume)
{
  auto chunks = std::make_unique<ChunkedVolume>(volume.path.string(), rules.level2);
  try
  {
    for (const auto& [path, taken] : volume.files)
    {
      const auto chunk = ParseChunkName(path);
      chunks->Add({chunk->number, chunk->kind}, path.filename().string(),
        ReadStoredBytes(path, rules.level2.maximumFileBytes));
    }
  }
  catch (const Error&)
  {
    return false;
  }
  volume.counts.missing = 0;
  volume.finished = false;
  volume.expired = false;
  volume.chunks = std::move(chunks);
  return true;
}

void LiveIntake::AddFile(const Queued& queued, Volume& volume, std::vector<std::uint8_t> bytes)
{
  volume.whole = DecodeLevel2(std::move(bytes), queued.file.path.string(), rules.level2);
  ++(volume.files.empty() ? volume.counts.used : volume.counts.replaced);
  volume.dirty = true;
}

bool LiveIntake::IsSuperseded(const Volume& volume) const
{
  return std::any_of(volumes.begin(), volumes.end(),
    [&volume](const auto& each)
    {
      // A volume of message 1 names its radar in its first chunk alone, which may be missing.
      const Volume& other = each.second;
      const bool ofOneRadar = other.radar.empty() || volume.radar.empty()
                                ? other.path.parent_path() == volume.path.parent_path()
                                : other.radar == volume.radar;
      return ofOneRadar && other.stamp > volume.stamp;
    });
}

void LiveIntake::GiveUpMissing(Volume& volume)
{
  volume.chunks->SkipMissing();
  volume.gaveUp = true;
  volume.dirty = true;
}

// Of volumes in progress: missing chunks, and those that follow.
void LiveIntake::GiveUpWaiting()
{
  const Duration now = clock.Elapsed();
  for (auto& [key, volume] : volumes)
  {
    if (!volume.chunks || volume.finished)
    {
      continue;
    }
    const bool waits = volume.chunks->DecodedCount() < volume.chunks->Count();
    const std::vector<int> missing = waits ? volume.chunks->Missing() : std::vector<int>();
    const int firstMissing = missing.empty() ? 0 : missing.front();
    if (firstMissing != volume.firstMissing)
    {
      volume.firstMissing = firstMissing;
      volume.gapSince = waits ? std::optional(now) : std::nullopt;
    }
    if (waits && volume.gapSince && now - *volume.gapSince > rules.patience)
    {
      GiveUpMissing(volume);
      volume.gapSince.reset();
    }
    const Duration silent = now - volume.lastArrival;
    if (silent > rules.idle || (silent > rules.patience && this->IsSuperseded(volume)))
    {
      GiveUpMissing(volume);
      volume.expired = true;
    }
  }
}

std::vector<IntakeChange> LiveIntake::Changes()
{
  std::vector<IntakeChange> changes;
  for (auto& [key, volume] : volumes)
  {
    if (volume.dirty)
    {
      volume.dirty = false;
      if (volume.isStray)
      {
        changes.push_back(this->TakeBack(key, volume));
        continue;
      }
      auto change = volume.chunks ? this->ChangeOfChunks(key, volume) : this->ChangeOf(key, volume);
      if (change)
      {
        changes.push_back(std::move(*change));
      }
    }
  }
  return changes;
}

// False for a volume that is left out by the times of its rays, whatever its header says.
bool LiveIntake::IsUsable(const RadarVolume& decoded, Volume& volume)
{
  const std::optional<Time> end = decoded.End();
  if (!end)
  {
    return true;
  }
  if (*end > clock.Now() + rayClockError)
  {
    ++volume.counts.refused;
    problems.push_back(
      volume.path.string() + ": has rays of " + FormatIso8601(*end) + ", in the future: left out");
    return false;
  }
  if (feedBegin && *end + clockError < *feedBegin)
  {
    this->PassOver(*end, volume);
    return false;
  }
  newestUsed = std::max(newestUsed.value_or(*end), *end);
  return true;
}

// A volume that was used and is none of the feed is taken out.
IntakeChange LiveIntake::TakeBack(const std::string& key, Volume& volume)
{
  volume.isStray = false;
  volume.finished = true;
  volume.sweeps.clear();
  if (volume.chunks)
  {
    volume.chunks->Close();
  }
  this->PassOver(*volume.time, volume);
  return {{key, volume.path, RadarVolume(), false}, std::nullopt, true};
}

// A whole file.
std::optional<IntakeChange> LiveIntake::ChangeOf(const std::string& key, Volume& volume)
{
  RadarVolume decoded = std::move(*volume.whole);
  volume.whole.reset();
  volume.radar = decoded.site.name;
  volume.sweeps = ArrivedSweeps(decoded);
  volume.finished = true;
  if (!this->IsUsable(decoded, volume))
  {
    return std::nullopt;
  }
  return IntakeChange{{key, volume.path, std::move(decoded), true}, volume.newestByte, false};
}

std::optional<IntakeChange> LiveIntake::ChangeOfChunks(const std::string& key, Volume& volume)
{
  RadarVolume decoded = volume.chunks->Volume();
  volume.radar = decoded.site.name;
  volume.sweeps = ArrivedSweeps(decoded);
  const auto complete = static_cast<std::size_t>(std::count_if(volume.sweeps.begin(),
    volume.sweeps.end(), [](const SweepArrival& sweep) { return sweep.complete; }));
  const bool allDecoded = volume.chunks->DecodedCount() == volume.chunks->Count();
  const bool finished = volume.expired || (volume.chunks->HasEnd() && allDecoded);
  const bool changed = volume.again || complete != volume.completeSweeps;
  volume.completeSweeps = complete;
  volume.again = false;
  if (!this->IsUsable(decoded, volume))
  {
    finished ? volume.chunks->Close() : void();
    volume.finished = finished;
    return std::nullopt;
  }
  if (finished)
  {
    volume.finished = true;
    volume.counts.missing = volume.chunks->Missing().size();
    volume.chunks->Close();
  }
  else if (!changed)
  {
    return std::nullopt;
  }
  else
  {
    DropSweepInProgress(decoded);
  }
  auto completed = std::exchange(volume.newestByte, std::nullopt);
  if (std::exchange(volume.gaveUp, false))
  {
    completed.reset();
  }
  return IntakeChange{{key, volume.path, std::move(decoded), finished}, completed, false};
}

void LiveIntake::SetOldest(Time time)
{
  oldest = time;
  for (auto volume = volumes.begin(); volume != volumes.end();)
  {
    const Volume& each = volume->second;
    const bool waits = std::any_of(waiting.begin(), waiting.end(),
      [&each](const auto& file) { return file.first.parent_path() == each.path; });
    const bool isOver =
      each.time && *each.time < time && !waits && (each.finished || (!each.chunks && !each.whole));
    if (isOver)
    {
      forgotten[each.radar] += each.counts;
    }
    volume = isOver ? volumes.erase(volume) : std::next(volume);
  }
}

std::map<std::string, ArrivingRadar> LiveIntake::Radars() const
{
  std::map<std::string, ArrivingRadar> radars;
  for (const auto& [radar, counts] : forgotten)
  {
    radars[radar].counts += counts;
  }
  std::map<std::string, const Volume*> newest;
  for (const auto& [key, volume] : volumes)
  {
    ArrivingRadar& radar = radars[volume.radar];
    radar.counts += volume.counts;
    const Volume*& latest = newest[volume.radar];
    const bool later = latest == nullptr || volume.sweeps.empty() < latest->sweeps.empty() ||
                       (!volume.sweeps.empty() && !latest->sweeps.empty() &&
                         volume.sweeps.front().begin > latest->sweeps.front().begin);
    latest = later ? &volume : latest;
  }
  for (const auto& [name, volume] : newest)
  {
    ArrivingRadar& radar = radars[name];
    radar.volume = volume->stamp.empty() ? volume->path.filename().string() : volume->stamp;
    radar.sweeps = volume->sweeps;
    radar.finished = volume->finished;
    radar.awaited =
      volume->chunks && !volume->finished ? volume->chunks->Missing() : std::vector<int>();
  }
  for (const auto& [path, file] : waiting)
  {
    const auto volume = volumes.find(VolumeKey(path, file.queued.chunk));
    ++radars[volume != volumes.end() ? volume->second.radar : ""].waiting;
  }
  return radars;
}

std::vector<std::string> LiveIntake::TakeProblems()
{
  return std::exchange(problems, {});
}

} // namespace nexrad::application
