// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/VolumeLoader.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <chrono>
#include <iterator>

namespace nexrad
{

namespace
{

// So many files of each site that began before a time are looked at: one in progress, one that
// ended, and one more because a header's time is not that of the first ray.
constexpr std::size_t filesBefore = 3;

// A header's time is within seconds of the first ray's in the files of the archive.
constexpr Duration largestHeaderError = std::chrono::minutes(10);

bool IsEarlier(const TimedFile& a, const TimedFile& b)
{
  return a.time < b.time;
}

} // namespace

VolumeLoader::VolumeLoader(SeriesFiles series, SeriesOptions theOptions, LoaderWork theWork,
  std::shared_ptr<PolarCache> theCache, unsigned theThreadCount)
  : paths(std::move(series.paths))
  , options(std::move(theOptions))
  , moments(options.Moments())
  , work(std::move(theWork))
  , cache(std::move(theCache))
  , threadCount(std::max(1U, theThreadCount))
  , sites(std::move(series.sites))
  , files(paths.size())
  , catalogue(std::move(series.listed))
  , looksAhead(cache == nullptr)
{
  catalogue.sites.resize(sites.size());
  for (std::size_t index = 0; index < series.known.size(); ++index)
  {
    files[index].scanned = std::move(series.known[index]);
  }
  for (std::size_t site = 0; site < sites.size(); ++site)
  {
    for (const TimedFile& file : sites[site].files)
    {
      files[file.index].site = site;
      files[file.index].time = file.time;
      order.push_back(file);
    }
  }
  std::stable_sort(order.begin(), order.end(), IsEarlier);
  threads.Start(
    threadCount, [this] { this->Work(); }, 1);
}

VolumeLoader::~VolumeLoader()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    stopped = true;
    changed.notify_all();
  }
  threads.Join();
}

void VolumeLoader::Work()
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
    ScannedFile scanned = files[*index].scanned;
    lock.unlock();
    try
    {
      std::vector<HeldVolume> held = this->Load(*index, scanned);
      if (cache)
      {
        AddSummaries(held, scanned);
      }
      lock.lock();
      this->Keep(*index, std::move(scanned), std::move(held));
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
std::optional<std::size_t> VolumeLoader::NextFile()
{
  while (!wanted.empty())
  {
    const std::size_t index = wanted.front();
    wanted.pop_front();
    files[index].asked = false;
    if (files[index].state == State::Waiting)
    {
      return index;
    }
  }
  if (!reached || !looksAhead)
  {
    return std::nullopt;
  }
  for (auto ahead = this->FirstAhead(*reached); ahead != this->EndOfAhead(*reached); ++ahead)
  {
    const File& file = files[ahead->index];
    if (ahead->time <= lastTime && file.state == State::Waiting && this->IsWanted(file.site))
    {
      return ahead->index;
    }
  }
  return std::nullopt;
}

// The files that may be decoded ahead, where those up to a header's time are needed.
std::vector<TimedFile>::const_iterator VolumeLoader::FirstAhead(Time time) const
{
  return std::upper_bound(order.begin(), order.end(), TimedFile{0, time}, IsEarlier);
}

std::vector<TimedFile>::const_iterator VolumeLoader::EndOfAhead(Time time) const
{
  const auto first = this->FirstAhead(time);
  return first + std::min<std::ptrdiff_t>(FilesAhead * threadCount, order.end() - first);
}

const ReadyVolume& VolumeLoader::HeldVolume::Of(MomentName moment) const
{
  return *std::find_if(ready.begin(), ready.end(),
    [moment](const ReadyVolume& each) { return each.Moment() == moment; });
}

// Called without the lock. The volumes of a file from the cache; none when it lacks something.
std::vector<VolumeLoader::HeldVolume> VolumeLoader::FindKept(const ScannedFile& scanned)
{
  std::vector<HeldVolume> held;
  for (const auto& [site, volume] : scanned.volumes)
  {
    held.push_back({volume, {}});
    for (const MomentName moment : moments)
    {
      const auto kept = cache && volume.Has(moment)
                          ? cache->Find({moment, volume.cycle, volume.file})
                          : std::nullopt;
      if (kept)
      {
        held.back().ready.push_back(work.prepare(*kept));
      }
      else if (volume.Has(moment))
      {
        return {};
      }
    }
  }
  return held;
}

// Called without the lock. Takes the volumes of a file from the cache, or else decodes it.
std::vector<VolumeLoader::HeldVolume> VolumeLoader::Load(std::size_t index, ScannedFile& scanned)
{
  std::vector<HeldVolume> held = this->FindKept(scanned);
  if (!held.empty())
  {
    return held;
  }
  const auto hold = [&](const SeriesVolume& description, const RadarVolume&,
                      const std::shared_ptr<const PolarVolume>& polar)
  {
    if (cache)
    {
      cache->Keep({polar->moment, description.cycle, description.file}, polar, MemoryOf(*polar));
    }
    if (held.empty() || held.back().volume.cycle != description.cycle)
    {
      held.push_back({description, {}});
    }
    held.back().ready.push_back(work.prepare(polar));
  };
  ++decodedFiles;
  ScannedFile found = ScanFile(paths[index], options, hold);
  for (const auto& [site, volume] : scanned.volumes)
  {
    const auto same = [&volume = volume](const HeldVolume& each)
    { return each.volume.cycle == volume.cycle && each.volume.start == volume.start; };
    if (std::none_of(held.begin(), held.end(), same))
    {
      throw Error(
        paths[index].string() + ": the file changed since it was first read; read it again");
    }
  }
  scanned = std::move(found);
  return held;
}

// Where a search for motion follows, it needs no more than the summaries of reflectivity.
void VolumeLoader::AddSummaries(const std::vector<HeldVolume>& held, ScannedFile& scanned)
{
  for (const HeldVolume& each : held)
  {
    for (const ReadyVolume& ready : each.ready)
    {
      const auto own = std::find_if(scanned.volumes.begin(), scanned.volumes.end(),
        [&each](const auto& volume) { return volume.second.cycle == each.volume.cycle; });
      if (ready.beam && ready.beam->moment == MomentName::REF && own != scanned.volumes.end() &&
          !own->second.summary)
      {
        own->second.summary = std::make_shared<const VolumeSummary>(MakeSummary(*ready.beam));
      }
    }
  }
}

// Called with the lock.
void VolumeLoader::Keep(std::size_t index, ScannedFile scanned, std::vector<HeldVolume> held)
{
  File& file = files[index];
  file.state = State::Done;
  file.held = std::move(held);
  file.asked = false;
  const bool isNew = IsUnknown(file.scanned);
  file.scanned = std::move(scanned);
  if (isNew)
  {
    this->LearnFile(index, file.scanned);
    return;
  }
  for (const auto& [site, volume] : file.scanned.volumes)
  {
    for (SeriesVolume& own : catalogue.sites[file.site].volumes)
    {
      own.summary = own.input == index && own.cycle == volume.cycle ? volume.summary : own.summary;
    }
  }
}

// Called with the lock.
void VolumeLoader::LearnFile(std::size_t index, const ScannedFile& scanned)
{
  SiteSeries& series = catalogue.sites[files[index].site];
  for (const auto& [site, volume] : scanned.volumes)
  {
    series.site = series.volumes.empty() ? site : series.site;
    SeriesVolume own = volume;
    own.input = index;
    series.Put(own);
  }
}

// Called with the lock.
void VolumeLoader::Want(std::size_t index)
{
  if (files[index].state == State::Waiting && !files[index].asked)
  {
    files[index].asked = true;
    wanted.push_back(index);
  }
}

// Called with the lock.
bool VolumeLoader::IsWanted(std::size_t site) const
{
  return wantedSites.empty() || wantedSites[site];
}

// Called with the lock. False when `progress` asked to stop.
bool VolumeLoader::WaitFor(
  std::unique_lock<std::mutex>& lock, const std::function<bool()>& there, const Progress& progress)
{
  constexpr auto patience = std::chrono::milliseconds(50);
  while (!failure && !there())
  {
    changed.notify_all(); // there may be something new to decode
    if (!progress)
    {
      changed.wait(lock);
      continue;
    }
    changed.wait_for(lock, patience);
    lock.unlock();
    const bool goOn = progress(0.0); // how much is left, is not known
    lock.lock();
    if (!goOn)
    {
      return false;
    }
  }
  if (failure)
  {
    std::rethrow_exception(failure);
  }
  return true;
}

void VolumeLoader::EndAt(Time time)
{
  const std::lock_guard<std::mutex> lock(mutex);
  lastTime = time;
}

void VolumeLoader::Learn(std::size_t index, const ScannedFile& scanned)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (IsUnknown(files[index].scanned))
  {
    files[index].scanned = scanned;
    this->LearnFile(index, scanned);
  }
}

void VolumeLoader::Expect(std::size_t index)
{
  const std::lock_guard<std::mutex> lock(mutex);
  this->Want(index);
  changed.notify_all();
}

ScannedFile VolumeLoader::Scan(std::size_t index)
{
  std::unique_lock<std::mutex> lock(mutex);
  files[index].kept = true;
  const auto known = [&]
  {
    if (IsUnknown(files[index].scanned))
    {
      this->Want(index);
    }
    return !IsUnknown(files[index].scanned);
  };
  this->WaitFor(lock, known);
  return files[index].scanned;
}

// Called with the lock. Whether a time takes some volume that started by then.
bool VolumeLoader::TakesStarted(std::size_t site, MomentName moment, Time time) const
{
  const auto chosen = catalogue.sites[site].ChosenAt(time, work.rule, moment);
  return !chosen.empty() && chosen.front()->start <= time;
}

// Called with the lock. Asks for the files about a time of which it is not known what they hold of
// a moment. Before the time these are filesBefore files with a volume that started by then. After
// it, all up to those that hold as many later volumes as are needed (one, until all before the time
// are known), and those whose headers have the same time as the last one's. True when nothing had
// to be asked for.
bool VolumeLoader::KnowsAbout(std::size_t site, MomentName moment, Time time)
{
  const std::vector<TimedFile>& own = sites[site].files;
  const auto isOwn = [moment](const auto& each) { return each.second.Has(moment); };
  const auto isLater = [=](const auto& each) { return isOwn(each) && each.second.start > time; };
  bool there = true;
  std::size_t later = 0;
  const auto look = [&](const TimedFile& each, std::size_t unknownLater)
  {
    const File& file = files[each.index];
    const std::vector<std::pair<Site, SeriesVolume>>& volumes = file.scanned.volumes;
    const auto fileLater =
      static_cast<std::size_t>(std::count_if(volumes.begin(), volumes.end(), isLater));
    const auto fileOwn =
      static_cast<std::size_t>(std::count_if(volumes.begin(), volumes.end(), isOwn));
    const bool known = !IsUnknown(file.scanned);
    later += known ? fileLater : unknownLater;
    if (!known)
    {
      this->Want(each.index);
      there = false;
    }
    return !known || fileLater < fileOwn; // may hold a volume that started
  };
  const auto next = static_cast<std::size_t>(
    std::upper_bound(own.begin(), own.end(), TimedFile{0, time}, IsEarlier) - own.begin());
  std::size_t started = 0;
  for (std::size_t place = next; place > 0 && started < filesBefore; --place)
  {
    started += look(own[place - 1], 0) ? 1 : 0;
  }
  const std::size_t needed = there && !this->TakesStarted(site, moment, time) ? 2 : 1;
  std::optional<Time> last = later >= needed ? std::optional(time) : std::nullopt;
  for (std::size_t place = next; place < own.size() && !(last && own[place].time > *last); ++place)
  {
    look(own[place], 1);
    last = !last && later >= needed ? std::optional(own[place].time) : last;
    reached = std::max(reached.value_or(own[place].time), own[place].time);
  }
  return there;
}

// Called with the lock. The same of all sites and moments.
bool VolumeLoader::KnowsAbout(Time time)
{
  bool known = true;
  for (const MomentName moment : moments)
  {
    for (std::size_t site = 0; site < sites.size(); ++site)
    {
      known = (!this->IsWanted(site) || this->KnowsAbout(site, moment, time)) && known;
    }
  }
  return known;
}

// Called with the lock. nullptr when the volume is not held.
VolumeLoader::HeldVolume* VolumeLoader::FindHeld(const SeriesVolume& volume)
{
  std::vector<HeldVolume>& held = files[volume.input].held;
  const auto found = std::find_if(held.begin(), held.end(),
    [&volume](const HeldVolume& each) { return each.volume.cycle == volume.cycle; });
  return found == held.end() ? nullptr : &*found;
}

// Called with the lock. The volumes that a time needs, when it is known what the files about it
// hold.
std::vector<ChosenVolume> VolumeLoader::ChosenAt(Time time) const
{
  std::vector<ChosenVolume> chosen = catalogue.ChosenAt(time, work.rule, moments);
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                 [this](const ChosenVolume& each) { return !this->IsWanted(each.site); }),
    chosen.end());
  return chosen;
}

// Called with the lock. The volumes that a time needs; empty, and asked for, while some are not
// there.
std::optional<std::vector<ChosenVolume>> VolumeLoader::Demand(Time time)
{
  reached = time;
  const bool known = this->KnowsAbout(time);
  farthest = std::max(farthest.value_or(*reached), *reached);
  if (!known)
  {
    return std::nullopt;
  }
  std::vector<ChosenVolume> needed = this->ChosenAt(time);
  bool there = true;
  for (const ChosenVolume& need : needed)
  {
    if (this->FindHeld(*need.volume) == nullptr)
    {
      const std::size_t index = need.volume->input;
      files[index].state = files[index].state == State::Done ? State::Waiting : files[index].state;
      this->Want(index);
      there = false;
    }
  }
  return there ? std::optional(needed) : std::nullopt;
}

std::optional<std::vector<ReadyVolume>> VolumeLoader::About(
  Time time, const std::vector<bool>& ofSites, const Progress& progress)
{
  std::unique_lock<std::mutex> lock(mutex);
  wantedSites = ofSites;
  farthest = time < current ? std::nullopt : farthest;
  looksAhead = looksAhead || (current != Time::min() && time != current);
  current = time;
  std::optional<std::vector<ChosenVolume>> needed;
  const auto allThere = [&]
  {
    needed = this->Demand(time);
    return needed.has_value();
  };
  if (!this->WaitFor(lock, allThere, progress))
  {
    return std::nullopt;
  }
  std::vector<ReadyVolume> volumes;
  for (const auto& [moment, site, volume] : *needed)
  {
    HeldVolume& held = *this->FindHeld(*volume);
    held.used = true;
    volumes.push_back(held.Of(moment));
  }
  made[time] = catalogue.MadeOf(time, work.rule, moments);
  this->Release(time, *needed);
  changed.notify_all(); // more may be decoded ahead
  return volumes;
}

// Called with the lock. Whether it is known what the files about a time hold, of all sites; nothing
// is decoded ahead of this time.
bool VolumeLoader::KnowsWithoutLoading(Time time)
{
  wantedSites.clear();
  const std::optional<Time> reachedBefore = reached;
  const bool known = this->KnowsAbout(time);
  reached = reachedBefore;
  return known;
}

std::optional<std::vector<std::pair<Site, SeriesVolume>>> VolumeLoader::EchoAbout(Time time)
{
  const std::lock_guard<std::mutex> lock(mutex);
  bool known = this->KnowsWithoutLoading(time);
  std::vector<std::pair<Site, SeriesVolume>> volumes;
  for (const ChosenVolume& each : catalogue.ChosenAt(time, work.rule, {MomentName::REF}))
  {
    known = known && each.volume->summary;
    volumes.emplace_back(catalogue.sites[each.site].site, *each.volume);
  }
  return known ? std::optional(volumes) : std::nullopt;
}

bool VolumeLoader::Know(Time time, const Progress& progress)
{
  std::unique_lock<std::mutex> lock(mutex);
  const bool known = this->WaitFor(
    lock, [&] { return this->KnowsWithoutLoading(time); }, progress);
  if (known)
  {
    this->Release(time, this->ChosenAt(time));
  }
  return known;
}

std::string VolumeLoader::MadeOf(Time time) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return catalogue.MadeOf(time, work.rule, moments);
}

// Called with the lock. Drops what the time did not need, but for what was decoded ahead of it, and
// for what Scan asked for and no time needed yet.
void VolumeLoader::Release(Time time, const std::vector<ChosenVolume>& needed)
{
  const auto isNeeded = [&needed](const HeldVolume& held)
  {
    return std::any_of(needed.begin(), needed.end(),
      [&held](const ChosenVolume& need)
      { return need.volume->cycle == held.volume.cycle && need.volume->file == held.volume.file; });
  };
  // Files of several radars may have the time of the last one ahead.
  const auto end = this->EndOfAhead(farthest.value_or(time));
  const Time lastAhead = end != order.end() ? std::prev(end)->time : Time::max();
  for (File& file : files)
  {
    const bool held = !file.held.empty();
    const bool tooFar = !file.kept && file.time > lastAhead;
    file.held.erase(
      std::remove_if(file.held.begin(), file.held.end(),
        [&](const HeldVolume& each)
        { return (each.used || each.volume.start <= time || tooFar) && !isNeeded(each); }),
      file.held.end());
    if (held && file.held.empty())
    {
      file.state = State::Waiting;
    }
  }
}

std::vector<ScannedFile> VolumeLoader::Known() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  std::vector<ScannedFile> known;
  for (const File& file : files)
  {
    known.push_back(file.scanned);
  }
  return known;
}

bool VolumeLoader::HeadersErr() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  for (const SiteFileList& site : sites)
  {
    Time latest = Time::min();
    for (const TimedFile& each : site.files)
    {
      for (const auto& [of, volume] : files[each.index].scanned.volumes)
      {
        const Duration error = volume.start - each.time;
        const bool first = &volume == &files[each.index].scanned.volumes.front().second;
        if (volume.start < latest || (!of.name.empty() && of.name != site.name) ||
            (first && (error > largestHeaderError || -error > largestHeaderError)))
        {
          return true;
        }
        latest = volume.start;
      }
    }
  }
  return false;
}

} // namespace nexrad
