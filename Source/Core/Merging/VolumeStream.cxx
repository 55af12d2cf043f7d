// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/VolumeStream.h"

#include <algorithm>
#include <iterator>

namespace nexrad
{

namespace
{

// Before the first time, so many volumes of each site are looked at: one in progress, one that
// ended, and one more because a header's time is not that of the first ray.
constexpr std::size_t volumesBefore = 3;

// So many files a thread are decoded ahead of what was asked for: enough that no thread waits while
// a volume is merged, few enough to need little memory.
constexpr std::size_t filesAhead = 3;

bool IsEarlier(const OutlinedFile& a, const OutlinedFile& b)
{
  return a.time < b.time;
}

} // namespace

VolumeStream::VolumeStream(std::vector<std::filesystem::path> thePaths,
  std::vector<SiteOutline> outline, SeriesOptions theOptions, StreamWork theWork,
  unsigned threadCount)
  : paths(std::move(thePaths))
  , options(std::move(theOptions))
  , work(std::move(theWork))
  , files(paths.size())
{
  for (SiteOutline& site : outline)
  {
    sites.push_back({std::move(site), 0, {}});
  }
  for (unsigned count = 0; count < std::max(1U, threadCount); ++count)
  {
    threads.emplace_back([this] { this->Work(); });
  }
}

VolumeStream::~VolumeStream()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    stopped = true;
    changed.notify_all();
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

void VolumeStream::Work()
{
  std::unique_lock<std::mutex> lock(mutex);
  while (!stopped && !failure)
  {
    const std::optional<std::size_t> index = this->NextFile();
    if (!index)
    {
      changed.wait(lock);
      continue;
    }
    files[*index].state = State::Running;
    lock.unlock();
    try
    {
      this->Decode(*index);
      lock.lock();
    }
    catch (...)
    {
      lock.lock();
      failure = failure ? failure : std::current_exception();
    }
    changed.notify_all();
  }
}

// Called with the lock. What somebody waits for comes first, then what stands next in time.
std::optional<std::size_t> VolumeStream::NextFile()
{
  while (!wanted.empty())
  {
    const std::size_t index = wanted.front();
    wanted.pop_front();
    if (files[index].state == State::Waiting)
    {
      return index;
    }
  }
  const OutlinedFile asked = {0, reached};
  const auto firstAhead = std::upper_bound(order.begin(), order.end(), asked, IsEarlier);
  const auto end = std::min(order.size(),
    static_cast<std::size_t>(firstAhead - order.begin()) + filesAhead * threads.size());
  for (; nextAhead < end; ++nextAhead)
  {
    if (files[order[nextAhead].index].state == State::Waiting)
    {
      return order[nextAhead++].index;
    }
  }
  return std::nullopt;
}

// Called without the lock.
void VolumeStream::Decode(std::size_t index)
{
  std::vector<HeldVolume> held;
  const auto hold = [this, &held](const SeriesVolume& description, const RadarVolume& volume) {
    held.push_back({description, work.prepare(volume)});
  };
  ScannedFile scanned = ScanFile(paths[index], options, hold);
  const std::lock_guard<std::mutex> lock(mutex);
  files[index].scanned = std::move(scanned);
  files[index].held = std::move(held);
  files[index].state = State::Done;
}

void VolumeStream::WaitFor(std::unique_lock<std::mutex>& lock, const std::function<bool()>& there)
{
  while (!failure && !there())
  {
    changed.notify_all(); // there may be something new to decode
    changed.wait(lock);
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}

// Called with the lock.
void VolumeStream::Want(std::size_t index)
{
  if (files[index].state == State::Waiting && !files[index].wanted)
  {
    files[index].wanted = true;
    wanted.push_back(index);
  }
}

void VolumeStream::EndAt(Time time)
{
  const std::lock_guard<std::mutex> lock(mutex);
  lastTime = time;
}

void VolumeStream::Expect(std::size_t index)
{
  const std::lock_guard<std::mutex> lock(mutex);
  this->Want(index);
  changed.notify_all();
}

ScannedFile VolumeStream::Scan(std::size_t index)
{
  std::unique_lock<std::mutex> lock(mutex);
  this->Want(index);
  this->WaitFor(lock, [&] { return files[index].state == State::Done; });
  return files[index].scanned;
}

// Called with the lock. Passes over what lies too long before the first time.
void VolumeStream::Begin(Time time)
{
  begun = true;
  for (SiteWindow& site : sites)
  {
    const std::vector<OutlinedFile>& own = site.outline.files;
    const auto after = std::find_if(
      own.begin(), own.end(), [time](const OutlinedFile& file) { return file.time > time; });
    const auto before = static_cast<std::size_t>(after - own.begin());
    site.next = before > volumesBefore ? before - volumesBefore : 0;
    for (std::size_t place = 0; place < own.size(); ++place)
    {
      if (place < site.next)
      {
        files[own[place].index].held.clear();
      }
      else if (own[place].time <= lastTime)
      {
        order.push_back(own[place]);
      }
    }
  }
  std::stable_sort(order.begin(), order.end(), IsEarlier);
}

// Called with the lock. How many volumes that start after a time it may need: two when none is
// chosen of those that started before it, as far as is known, else one.
std::size_t VolumeStream::LaterNeeded(const SiteWindow& site, std::size_t end, Time time) const
{
  std::vector<TimeSpan> startedSpans;
  const auto add = [&startedSpans, time](const std::vector<HeldVolume>& held)
  {
    for (const HeldVolume& each : held)
    {
      if (each.volume.start <= time)
      {
        startedSpans.push_back({each.volume.start, each.volume.end});
      }
    }
  };
  add(site.held);
  for (std::size_t place = site.next; place < end; ++place)
  {
    add(files[site.outline.files[place].index].held);
  }
  std::sort(startedSpans.begin(), startedSpans.end(),
    [](const TimeSpan& a, const TimeSpan& b) { return a.first < b.first; });
  std::vector<Time> starts;
  std::vector<Time> ends;
  for (const TimeSpan& each : startedSpans)
  {
    starts.push_back(each.first);
    ends.push_back(each.last);
  }
  return work.choose(starts, ends, time).empty() ? 2 : 1;
}

// Called with the lock. Asks for the files of a site that a time may need: all up to those that
// hold as many later volumes as are needed, and those whose headers have the same time as the last
// one's. The place after the last of them; empty while some are not there.
std::optional<std::size_t> VolumeStream::Demand(const SiteWindow& site, Time time)
{
  const std::vector<OutlinedFile>& own = site.outline.files;
  const auto countLater = [time](const std::vector<HeldVolume>& held)
  {
    return static_cast<std::size_t>(std::count_if(held.begin(), held.end(),
      [time](const HeldVolume& each) { return each.volume.start > time; }));
  };
  std::size_t later = countLater(site.held);
  const auto enough = [&](std::size_t end)
  { return later > 0 && later >= this->LaterNeeded(site, end, time); };
  bool there = true;
  std::size_t place = site.next;
  std::optional<Time> last;
  if (enough(place))
  {
    return place;
  }
  for (; place < own.size() && !(last && own[place].time > *last); ++place)
  {
    const File& file = files[own[place].index];
    const bool done = file.state == State::Done;
    if (!done)
    {
      this->Want(own[place].index);
      there = false;
    }
    later += done ? countLater(file.held) : own[place].time > time ? 1 : 0;
    last = last || !enough(place + 1) ? last : std::optional(own[place].time);
    reached = std::max(reached, own[place].time);
  }
  return there ? std::optional(place) : std::nullopt;
}

std::vector<ReadyVolume> VolumeStream::About(Time time)
{
  std::unique_lock<std::mutex> lock(mutex);
  if (!begun)
  {
    this->Begin(time);
  }
  std::vector<std::size_t> ends;
  const auto allThere = [&]
  {
    ends.clear();
    for (const SiteWindow& site : sites)
    {
      if (const std::optional<std::size_t> end = this->Demand(site, time))
      {
        ends.push_back(*end);
      }
    }
    return ends.size() == sites.size();
  };
  this->WaitFor(lock, allThere);
  std::vector<ReadyVolume> chosen;
  Choice choice;
  for (std::size_t index = 0; index < sites.size(); ++index)
  {
    this->Take(sites[index], ends[index]);
    this->Choose(sites[index], time, chosen, choice);
  }
  choices[time] = std::move(choice);
  changed.notify_all(); // more may be decoded ahead
  return chosen;
}

// Called with the lock. Moves the volumes of a site's files before `end` into its window; of two
// with the same first ray the one with more rays, as a scan does.
void VolumeStream::Take(SiteWindow& site, std::size_t end)
{
  for (; site.next < end; ++site.next)
  {
    std::vector<HeldVolume>& from = files[site.outline.files[site.next].index].held;
    std::move(from.begin(), from.end(), std::back_inserter(site.held));
    from.clear();
  }
  std::stable_sort(site.held.begin(), site.held.end(),
    [](const HeldVolume& a, const HeldVolume& b) { return IsBefore(a.volume, b.volume); });
  const auto same = [](const HeldVolume& a, const HeldVolume& b)
  { return a.volume.start == b.volume.start; };
  site.held.erase(std::unique(site.held.begin(), site.held.end(), same), site.held.end());
}

// Called with the lock. Takes what a time needs of a site's window, and drops what no later time
// can need.
void VolumeStream::Choose(
  SiteWindow& site, Time time, std::vector<ReadyVolume>& chosen, Choice& choice)
{
  std::vector<Time> starts;
  std::vector<Time> ends;
  for (const HeldVolume& held : site.held)
  {
    starts.push_back(held.volume.start);
    ends.push_back(held.volume.end);
  }
  std::vector<HeldVolume> kept;
  for (const std::size_t index : work.choose(starts, ends, time))
  {
    const HeldVolume& held = site.held[index];
    chosen.push_back(held.ready);
    choice.emplace_back(held.volume.file, held.volume.cycle);
    if (held.volume.start <= time)
    {
      kept.push_back(held);
    }
  }
  std::copy_if(site.held.begin(), site.held.end(), std::back_inserter(kept),
    [time](const HeldVolume& held) { return held.volume.start > time; });
  site.held = std::move(kept);
}

std::vector<ScannedFile> VolumeStream::Scanned() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  std::vector<ScannedFile> scanned;
  for (const File& file : files)
  {
    scanned.push_back(file.scanned);
  }
  return scanned;
}

bool VolumeStream::IsAsIn(const SeriesScan& scan) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  for (const auto& [time, choice] : choices)
  {
    Choice expected;
    for (const SiteSeries& series : scan.sites)
    {
      for (const std::size_t index : work.choose(series.Starts(), series.Ends(), time))
      {
        expected.emplace_back(series.volumes[index].file, series.volumes[index].cycle);
      }
    }
    Choice own = choice;
    std::sort(own.begin(), own.end());
    std::sort(expected.begin(), expected.end());
    if (own != expected)
    {
      return false;
    }
  }
  return true;
}

} // namespace nexrad
