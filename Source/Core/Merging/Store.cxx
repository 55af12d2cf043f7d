// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/Store.h"

#include "nexrad/Quality/EchoClassification.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <set>

namespace nexrad
{

namespace
{

// A header's time is within seconds of the first ray's in the files of the archive.
constexpr Duration largestHeaderError = std::chrono::minutes(10);

// A time was promised what a file held before.
void RequireSame(
  const ScannedFile& before, const ScannedFile& now, const std::filesystem::path& path)
{
  for (const auto& [site, volume] : before.volumes)
  {
    const auto same = [&volume = volume](const auto& each)
    { return each.second.cycle == volume.cycle && each.second.start == volume.start; };
    if (std::none_of(now.volumes.begin(), now.volumes.end(), same))
    {
      throw Error(path.string() + ": the file changed since it was first read; read it again");
    }
  }
}

// The summaries that were made when a file was decoded before.
void TakeSummaries(const ScannedFile& before, ScannedFile& now)
{
  for (auto& [site, volume] : now.volumes)
  {
    for (const auto& [ofSite, known] : before.volumes)
    {
      volume.summary = known.cycle == volume.cycle ? known.summary : volume.summary;
    }
  }
}

// nullptr where no moment is merged by Beam. Reflectivity alone has pictures.
std::shared_ptr<const VolumeSummary> SummaryOf(const std::vector<ReadyVolume>& moments)
{
  std::shared_ptr<VolumeSummary> summary;
  double reach = 0.0;
  for (const ReadyVolume& each : moments)
  {
    if (each.beam)
    {
      VolumeSummary own = MakeSummary(*each.beam);
      reach = std::max(reach, own.reach);
      if (!summary || each.Moment() == MomentName::REF)
      {
        summary = std::make_shared<VolumeSummary>(std::move(own));
      }
      summary->reach = reach;
    }
  }
  return summary;
}

} // namespace

Store::Store(
  std::vector<std::filesystem::path> thePaths, FilesByRadar theHeaders, unsigned theThreadCount)
  : paths(std::move(thePaths))
  , headers(std::move(theHeaders))
  , threadCount(std::max(1U, theThreadCount))
  , files(paths.size())
{
}

Store::~Store()
{
  this->End();
}

void Store::End()
{
  {
    const std::lock_guard<std::mutex> lock(mutex);
    stopped = true;
    changed.notify_all();
  }
  threads.Join();
}

void Store::KeepUpTo(std::size_t bytes)
{
  const std::lock_guard<std::mutex> lock(mutex);
  anyOrder = true;
  limit = bytes;
}

void Store::Begin(StoreWork theWork, Catalogue listed)
{
  this->End();
  work = std::move(theWork);
  moments = work.options.moments;
  catalogue = std::move(listed);
  for (File& file : files)
  {
    file.state = State::Waiting;
    file.kept = false;
    for (HeldVolume& held : file.held)
    {
      held.ready.clear();
    }
  }
  wanted.clear();
  wantedSites.clear();
  reached.reset();
  current = Time::min();
  lastTime = Time::max();
  looksAhead = !anyOrder;
  this->List();
  failure = nullptr;
  stopped = false;
  try
  {
    threads.Start(
      threadCount, [this] { this->Work(); }, 1);
  }
  catch (...)
  {
    failure = std::current_exception(); // whoever asks all the same does not wait
    throw;
  }
}

// Adds the files of which nobody knows what they hold to the catalogue: each as one volume without
// rays, from the time in its header to that in the next.
void Store::List()
{
  for (const auto& [name, own] : headers)
  {
    for (auto file = own.begin(); file != own.end(); ++file)
    {
      if (IsUnknown(files[file->index].scanned))
      {
        SeriesVolume volume;
        volume.input = file->index;
        volume.start = file->time;
        volume.end = std::next(file) != own.end() ? std::next(file)->time : Time::max();
        catalogue.Of({name, {}}).volumes.push_back(volume);
      }
    }
  }
  order.clear();
  std::vector<bool> placed(files.size());
  for (std::size_t site = 0; site < catalogue.sites.size(); ++site)
  {
    std::vector<SeriesVolume>& volumes = catalogue.sites[site].volumes;
    std::stable_sort(volumes.begin(), volumes.end(), IsBefore);
    for (const SeriesVolume& volume : volumes)
    {
      if (!placed[volume.input])
      {
        placed[volume.input] = true;
        files[volume.input].site = site;
        files[volume.input].time = volume.start;
        order.push_back({volume.input, volume.start});
      }
    }
  }
  std::stable_sort(order.begin(), order.end(), IsEarlier);
}

void Store::Work()
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
    File file = files[*index];
    const bool keeps = anyOrder;
    lock.unlock();
    std::exception_ptr thrown;
    try
    {
      this->Load(*index, file, keeps);
    }
    catch (...)
    {
      thrown = std::current_exception();
    }
    lock.lock();
    failure = failure ? failure : thrown;
    if (!thrown)
    {
      this->Keep(*index, std::move(file));
    }
    changed.notify_all();
  }
}

// What somebody waits for comes first, then what stands next in time.
std::optional<std::size_t> Store::NextFile()
{
  while (!wanted.empty())
  {
    const std::size_t index = wanted.front();
    wanted.pop_front();
    if (files[index].state == State::Asked)
    {
      return index;
    }
  }
  if (!reached || !looksAhead)
  {
    return std::nullopt;
  }
  const auto [first, end] = this->Ahead(*reached);
  const auto next = std::find_if(first, end,
    [this](const TimedFile& each)
    {
      const File& file = files[each.index];
      return each.time <= lastTime && file.state == State::Waiting && this->IsWanted(file.site);
    });
  return next != end ? std::optional(next->index) : std::nullopt;
}

// The files that may be decoded ahead, where those up to a time are needed.
Store::FileRange Store::Ahead(Time time) const
{
  const auto first = std::upper_bound(order.begin(), order.end(), TimedFile{0, time}, IsEarlier);
  return {first, first + std::min<std::ptrdiff_t>(FilesAhead * threadCount, order.end() - first)};
}

// nullptr when nothing of the volume is held.
Store::HeldVolume* Store::File::Find(std::size_t cycle)
{
  const auto found = std::find_if(
    held.begin(), held.end(), [cycle](const HeldVolume& each) { return each.cycle == cycle; });
  return found == held.end() ? nullptr : &*found;
}

// Whether no moment of a file needs to be decoded.
bool Store::HoldsMoments(File& file) const
{
  const auto isHeld = [&](const auto& each)
  {
    const HeldVolume* held = file.Find(each.second.cycle);
    const auto count = std::count_if(moments.begin(), moments.end(),
      [&each](MomentName moment) { return each.second.Has(moment); });
    return held != nullptr && held->moments.size() == static_cast<std::size_t>(count);
  };
  const auto& volumes = file.scanned.volumes;
  return !IsUnknown(file.scanned) && std::all_of(volumes.begin(), volumes.end(), isHeld);
}

// Called without the lock, with a copy of the file. Makes its moments ready; where not all of them
// are held, decodes it.
void Store::Load(std::size_t index, File& file, bool keeps)
{
  const bool isThere = this->HoldsMoments(file);
  const std::vector<HeldVolume> before = std::exchange(file.held, {});
  const auto hold = [&](std::size_t cycle, const std::shared_ptr<const PolarVolume>& moment)
  {
    if (file.held.empty() || file.held.back().cycle != cycle)
    {
      file.held.push_back({cycle, {}, {}});
    }
    if (keeps)
    {
      file.held.back().moments.push_back(moment);
    }
    file.held.back().ready.push_back(work.prepare(moment));
  };
  if (isThere)
  {
    for (const HeldVolume& volume : before)
    {
      for (const auto& moment : volume.moments)
      {
        hold(volume.cycle, moment);
      }
    }
  }
  else
  {
    ++decodedFiles;
    ScannedFile found = ScanFile(paths[index], work.options,
      [&hold](const SeriesVolume& volume, const RadarVolume&,
        const std::shared_ptr<const PolarVolume>& moment) { hold(volume.cycle, moment); });
    RequireSame(file.scanned, found, paths[index]);
    TakeSummaries(file.scanned, found);
    file.scanned = std::move(found);
  }
  for (auto& [site, volume] : file.scanned.volumes)
  {
    if (work.summaries && !volume.summary)
    {
      volume.summary = SummaryOf(file.Find(volume.cycle)->ready);
    }
  }
}

void Store::Keep(std::size_t index, File&& loaded)
{
  File& file = files[index];
  const bool isNew = IsUnknown(file.scanned);
  file.state = State::Done;
  file.scanned = std::move(loaded.scanned);
  file.held = std::move(loaded.held);
  file.loaded = ++loads;
  const auto drop = [this](File& from)
  {
    used -= std::exchange(from.bytes, 0);
    for (HeldVolume& held : from.held)
    {
      held.moments.clear();
    }
  };
  used -= std::exchange(file.bytes, 0);
  for (const HeldVolume& held : file.held)
  {
    for (const auto& moment : held.moments)
    {
      file.bytes += MemoryOf(*moment);
    }
  }
  used += file.bytes;
  if (file.bytes > limit)
  {
    drop(file); // it would push all others out, and not stay itself
  }
  while (used > limit)
  {
    drop(*std::min_element(files.begin(), files.end(),
      [](const File& a, const File& b)
      { return a.bytes > 0 && (b.bytes == 0 || a.loaded < b.loaded); }));
  }
  if (isNew)
  {
    this->LearnFile(index);
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

void Store::LearnFile(std::size_t index)
{
  SiteSeries& series = catalogue.sites[files[index].site];
  series.volumes.erase(std::remove_if(series.volumes.begin(), series.volumes.end(),
                         [index](const SeriesVolume& each) { return each.input == index; }),
    series.volumes.end());
  for (const auto& [site, volume] : files[index].scanned.volumes)
  {
    series.site = series.site.position ? series.site : site;
    SeriesVolume own = volume;
    own.input = index;
    series.Put(own);
  }
}

void Store::Want(std::size_t index)
{
  if (files[index].state == State::Waiting)
  {
    files[index].state = State::Asked;
    wanted.push_back(index);
  }
}

bool Store::IsWanted(std::size_t site) const
{
  return wantedSites.empty() || wantedSites[site];
}

// False when `progress` asked to stop.
bool Store::WaitFor(
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

void Store::EndAt(Time time)
{
  const std::lock_guard<std::mutex> lock(mutex);
  lastTime = time;
}

std::vector<ScannedFile> Store::Known() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  std::vector<ScannedFile> known;
  for (const File& file : files)
  {
    known.push_back(file.scanned);
  }
  return known;
}

void Store::Learn(std::size_t index, const ScannedFile& scanned)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (IsUnknown(files[index].scanned))
  {
    files[index].scanned = scanned;
    this->LearnFile(index);
  }
}

void Store::LearnAll(std::vector<ScannedFile> all)
{
  const std::lock_guard<std::mutex> lock(mutex);
  for (std::size_t index = 0; index < files.size(); ++index)
  {
    files[index].scanned = std::move(all[index]);
  }
}

void Store::Offer(const SeriesVolume& volume, const std::shared_ptr<const PolarVolume>& moment)
{
  const std::size_t bytes = MemoryOf(*moment);
  const std::lock_guard<std::mutex> lock(mutex);
  const auto place = std::find(paths.begin(), paths.end(), volume.file) - paths.begin();
  File& file = files[static_cast<std::size_t>(place)];
  HeldVolume* held = file.Find(volume.cycle);
  const bool isHeld =
    held != nullptr && std::any_of(held->moments.begin(), held->moments.end(),
                         [&](const auto& each) { return each->moment == moment->moment; });
  if (isHeld || used + bytes > limit)
  {
    return;
  }
  held = held != nullptr ? held : &file.held.emplace_back(HeldVolume{volume.cycle, {}, {}});
  held->moments.push_back(moment);
  file.loaded = ++loads;
  file.bytes += bytes;
  used += bytes;
}

void Store::Expect(std::size_t index)
{
  const std::lock_guard<std::mutex> lock(mutex);
  if (IsUnknown(files[index].scanned))
  {
    this->Want(index);
    changed.notify_all();
  }
}

ScannedFile Store::Scan(std::size_t index)
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

// The files that a time may take, as far as headers tell, and of which nobody knows what they hold;
// once that is known, there may be others. Copies, and what stands between, come along.
std::vector<std::size_t> Store::UnknownAbout(std::size_t site, MomentName moment, Time time) const
{
  Time first = Time::max();
  Time last = Time::min();
  for (const Duration error : {Duration(0), largestHeaderError})
  {
    VolumeRule rule = work.rule;
    rule.maximumGap += error;
    for (const SeriesVolume* volume : catalogue.sites[site].ChosenAt(time, rule, moment))
    {
      first = std::min(first, files[volume->input].time);
      last = std::max(last, files[volume->input].time);
    }
  }
  std::vector<std::size_t> unknown;
  auto file = std::lower_bound(order.begin(), order.end(), TimedFile{0, first}, IsEarlier);
  for (; file != order.end() && file->time <= last; ++file)
  {
    if (files[file->index].site == site && IsUnknown(files[file->index].scanned))
    {
      unknown.push_back(file->index);
    }
  }
  return unknown;
}

std::vector<std::size_t> Store::UnknownAbout(Time time) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  std::set<std::size_t> unknown;
  for (const MomentName moment : moments)
  {
    for (std::size_t site = 0; site < catalogue.sites.size(); ++site)
    {
      const std::vector<std::size_t> own = this->UnknownAbout(site, moment, time);
      unknown.insert(own.begin(), own.end());
    }
  }
  return {unknown.begin(), unknown.end()};
}

Catalogue Store::Listed() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return catalogue;
}

// True when it is known what the files about a time hold; else asks for those of which it is not.
bool Store::KnowsAbout(Time time)
{
  bool known = true;
  for (const MomentName moment : moments)
  {
    for (std::size_t site = 0; site < catalogue.sites.size(); ++site)
    {
      const bool isWanted = this->IsWanted(site);
      for (const std::size_t index :
        isWanted ? this->UnknownAbout(site, moment, time) : std::vector<std::size_t>())
      {
        this->Want(index);
        known = false;
      }
    }
  }
  return known;
}

// The volumes that a time needs, when it is known what the files about it hold.
std::vector<ChosenVolume> Store::ChosenAt(Time time) const
{
  std::vector<ChosenVolume> chosen = catalogue.ChosenAt(time, work.rule, moments);
  chosen.erase(std::remove_if(chosen.begin(), chosen.end(),
                 [this](const ChosenVolume& each) { return !this->IsWanted(each.site); }),
    chosen.end());
  return chosen;
}

// The volumes that a time needs; empty, and asked for, while some are not there.
std::optional<std::vector<ChosenVolume>> Store::Demand(Time time)
{
  reached = std::max(reached.value_or(time), time);
  if (!this->KnowsAbout(time))
  {
    return std::nullopt;
  }
  std::vector<ChosenVolume> needed = this->ChosenAt(time);
  bool there = true;
  for (const ChosenVolume& need : needed)
  {
    const std::size_t index = need.volume->input;
    File& file = files[index];
    reached = std::max(*reached, file.time);
    const HeldVolume* held = file.Find(need.volume->cycle);
    if (held == nullptr || held->ready.empty())
    {
      file.state = file.state == State::Done ? State::Waiting : file.state;
      this->Want(index);
      there = false;
    }
  }
  return there ? std::optional(needed) : std::nullopt;
}

std::optional<std::vector<ReadyVolume>> Store::About(
  Time time, const std::vector<bool>& ofSites, const Progress& progress)
{
  std::unique_lock<std::mutex> lock(mutex);
  wantedSites = ofSites;
  reached = time < current ? std::nullopt : reached;
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
    HeldVolume& held = *files[volume->input].Find(volume->cycle);
    held.used = true;
    volumes.push_back(*std::find_if(held.ready.begin(), held.ready.end(),
      [of = moment](const ReadyVolume& each) { return each.Moment() == of; }));
  }
  made[time] = catalogue.MadeOf(time, work.rule, moments);
  this->Release(time, *needed);
  changed.notify_all(); // more may be decoded ahead
  return volumes;
}

std::optional<BeamVolumes> Store::EchoAbout(Time time)
{
  const std::lock_guard<std::mutex> lock(mutex);
  wantedSites.clear();
  bool known = this->KnowsAbout(time);
  BeamVolumes volumes;
  for (const auto& [moment, site, volume] : catalogue.ChosenAt(time, work.rule, {MomentName::REF}))
  {
    known = known && volume->summary;
    if (known)
    {
      volumes.push_back(this->WithoutSweeps(catalogue.sites[site].site, *volume, moment, true));
    }
  }
  return known ? std::optional(volumes) : std::nullopt;
}

std::shared_ptr<const BeamVolume> Store::WithoutSweeps(
  const Site& site, const SeriesVolume& volume, MomentName moment, bool pictured)
{
  std::weak_ptr<const BeamVolume>& own =
    withoutSweeps[{volume.file, volume.cycle, moment, pictured}];
  std::shared_ptr<const BeamVolume> known = own.lock();
  if (!known)
  {
    BeamVolume without;
    without.site = site;
    without.moment = moment;
    without.start = volume.start;
    without.end = volume.end;
    without.synthetic = volume.synthetic;
    if (moment == MomentName::REF && volume.echo)
    {
      without.echo = GatesLeft(*volume.echo, work.options.quality.level);
    }
    without.endsAt = volume.endsAt;
    if (pictured)
    {
      without.composite = CompositeOf(volume.summary->composite);
      without.lowest = CompositeOf(volume.summary->lowest);
    }
    known = std::make_shared<const BeamVolume>(std::move(without));
    own = known;
  }
  return known;
}

bool Store::Know(Time time, const Progress& progress)
{
  std::unique_lock<std::mutex> lock(mutex);
  wantedSites.clear();
  const bool known = this->WaitFor(
    lock, [&] { return this->KnowsAbout(time); }, progress);
  if (known)
  {
    this->Release(time, this->ChosenAt(time));
  }
  return known;
}

std::string Store::MadeOf(Time time) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return catalogue.MadeOf(time, work.rule, moments);
}

std::string Store::LastMadeOf(Time time) const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return made.at(time);
}

// Drops of what is ready what the time did not need, but for what was made ready ahead of it, and
// for what Scan asked for and no time needed yet.
void Store::Release(Time time, const std::vector<ChosenVolume>& needed)
{
  // Files of several radars may have the time of the last one ahead.
  const auto end = this->Ahead(std::max(reached.value_or(time), time)).second;
  const Time lastAhead = end != order.end() ? std::prev(end)->time : Time::max();
  for (std::size_t index = 0; index < files.size(); ++index)
  {
    File& file = files[index];
    const bool tooFar = !file.kept && file.time > lastAhead;
    bool had = false;
    bool has = false;
    for (const auto& [site, volume] : file.scanned.volumes)
    {
      HeldVolume* held = file.Find(volume.cycle);
      if (held == nullptr || held->ready.empty())
      {
        continue;
      }
      had = true;
      const bool isNeeded = std::any_of(needed.begin(), needed.end(),
        [&, cycle = volume.cycle](const ChosenVolume& need)
        { return need.volume->input == index && need.volume->cycle == cycle; });
      if ((held->used || volume.start <= time || tooFar) && !isNeeded)
      {
        held->ready.clear();
      }
      has = has || !held->ready.empty();
    }
    file.state = file.state == State::Done && had && !has ? State::Waiting : file.state;
  }
}

bool Store::HeadersErr() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  for (const auto& [name, own] : headers)
  {
    Time latest = Time::min();
    for (const TimedFile& each : own)
    {
      for (const auto& [of, volume] : files[each.index].scanned.volumes)
      {
        const Duration error = volume.start - each.time;
        const bool first = &volume == &files[each.index].scanned.volumes.front().second;
        if (volume.start < latest || (!of.name.empty() && of.name != name) ||
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
