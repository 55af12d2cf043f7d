// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/LiveSeries.h"

#include "nexrad/Model/Site.h"
#include "nexrad/System/Error.h"

#include <algorithm>

namespace nexrad
{

namespace
{

SeriesOptions ScanOptionsOf(const MergeOptions& options)
{
  if (options.measureBiases)
  {
    throw Error(
      "biases cannot be measured while volumes arrive: all of them would have to be known "
      "before the first merge; give the biases");
  }
  SeriesOptions series = SeriesOptionsOf(options);
  series.level2.threads = 1; // several inputs are prepared at a time
  return series;
}

// One moment of one volume of an input, before it is made ready.
using Moments = std::vector<std::pair<std::size_t, std::shared_ptr<const PolarVolume>>>;

// The volumes of each radar that are held while they arrive; how large they are is not known.
InputSizes InputsOf(std::size_t radars)
{
  constexpr std::size_t held = 4;
  InputSizes inputs;
  inputs.radars = radars;
  inputs.files = radars * held;
  return inputs;
}

// Takes the volumes of a radar out of what a file holds.
void LeaveOutRadar(const std::string& radar, const std::string& why,
  const std::filesystem::path& path, ScannedFile& file)
{
  const auto own = std::remove_if(file.volumes.begin(), file.volumes.end(),
    [&radar](const auto& each) { return each.first.name == radar; });
  if (own != file.volumes.end())
  {
    file.volumes.erase(own, file.volumes.end());
    file.problems.push_back({path.string(), {}, radar + " is left out: " + why, true});
  }
}

const SeriesVolume* FindNext(const Catalogue& known, const std::string& radar, Time start)
{
  const auto isOwn = [&radar](const SiteSeries& each) { return each.site.name == radar; };
  const auto own = std::find_if(known.sites.begin(), known.sites.end(), isOwn);
  if (own == known.sites.end())
  {
    return nullptr;
  }
  const auto next = std::find_if(own->volumes.begin(), own->volumes.end(),
    [start](const SeriesVolume& volume) { return volume.start > start; });
  return next != own->volumes.end() ? &*next : nullptr;
}

} // namespace

LiveSeries::LiveSeries(
  const MergeOptions& theOptions, const RangeLoop& loop, const VolumeUse& theUse)
  : options(theOptions)
  , series(ScanOptionsOf(theOptions))
  , use(theUse)
  , request(MergeRequestOf(theOptions, loop))
{
  RequireMemory(options, InputsOf(1), 1, use);
}

void LiveSeries::PlanGrid()
{
  std::vector<Position> positions;
  for (const auto& [name, site] : sites)
  {
    positions.push_back(*site.first.position);
  }
  request.grid =
    GridOf(options, positions, sites.size() == 1 ? sites.begin()->second.second : DefaultRange);
  RequireMemory(options, InputsOf(sites.size()), 1, use, request.grid, positions);
}

void LiveSeries::Expect(const Site& site, double range)
{
  if (keepsGrid)
  {
    return;
  }
  const auto [known, isNew] = sites.emplace(site.name, std::pair(site, range));
  if (isNew || known->second.second != range)
  {
    known->second.second = range;
    this->PlanGrid();
  }
}

// The radars of what arrived. The range of each is that of its first volume, which may still grow.
void LiveSeries::ExpectRadarsOf(
  const std::vector<LiveInput>& inputs, std::vector<ScannedFile>& scanned)
{
  std::map<std::string, Time> firsts;
  for (const SiteSeries& own : known.sites)
  {
    firsts[own.site.name] = own.volumes.front().start;
  }
  std::map<std::string, std::pair<Site, double>> ranges;
  for (const ScannedFile& file : scanned)
  {
    for (const auto& [site, volume] : file.volumes)
    {
      const auto first = firsts.emplace(site.name, volume.start).first;
      if (volume.start <= first->second)
      {
        first->second = volume.start;
        ranges[site.name] = {site, RangeOf(site, volume)};
      }
    }
  }
  for (const auto& [name, radar] : ranges)
  {
    try
    {
      this->Expect(radar.first, radar.second);
    }
    catch (const Error& problem)
    {
      if (sites.size() < 2) // it is the options that cannot be met
      {
        throw;
      }
      for (std::size_t i = 0; i < inputs.size(); ++i)
      {
        LeaveOutRadar(name, problem.what(), inputs[i].path, scanned[i]);
      }
      this->ForgetRadar(name);
    }
  }
}

// Takes a radar out of a domain that may still change.
void LiveSeries::ForgetRadar(const std::string& radar)
{
  if (!keepsGrid && sites.erase(radar) > 0 && !sites.empty())
  {
    this->PlanGrid();
  }
}

// Volumes of a radar that stands elsewhere than the first of its name does.
void LiveSeries::LeaveOutOthers(std::vector<ScannedFile>& scanned) const
{
  std::map<std::string, Site> places;
  for (const auto& [name, site] : sites)
  {
    places.emplace(name, site.first);
  }
  for (ScannedFile& file : scanned)
  {
    std::vector<std::pair<Site, SeriesVolume>> kept;
    for (auto& [site, volume] : file.volumes)
    {
      const Site& known = places.emplace(site.name, site).first->second;
      if (StandApart(known, site))
      {
        file.problems.push_back({volume.file.string(), {}, DescribePlaces(site, known), true});
        continue;
      }
      kept.emplace_back(site, std::move(volume));
    }
    file.volumes = std::move(kept);
  }
}

std::vector<ScannedFile> LiveSeries::Put(const std::vector<LiveInput>& inputs)
{
  std::vector<ScannedFile> scanned(inputs.size());
  std::vector<Moments> moments(inputs.size());
  RunEach(request.loop, inputs.size(),
    [&](std::size_t i)
    {
      const auto keep = [&of = moments[i]](const SeriesVolume& volume, const RadarVolume&,
                          const std::shared_ptr<const PolarVolume>& polar)
      { of.emplace_back(volume.cycle, polar); };
      scanned[i] = ScanVolume(inputs[i].volume, inputs[i].path, series, keep);
    });
  this->LeaveOutOthers(scanned);
  this->ExpectRadarsOf(inputs, scanned);
  std::vector<std::vector<Volume>> made(inputs.size());
  RunEach(request.loop, inputs.size(),
    [&](std::size_t i)
    {
      for (const auto& [site, description] : scanned[i].volumes)
      {
        made[i].push_back({site, description, {}, inputs[i].finished});
        for (const auto& [cycle, polar] : moments[i])
        {
          if (cycle == description.cycle)
          {
            made[i].back().ready.push_back(MakeReady(polar, request));
          }
        }
      }
    });
  for (std::size_t i = 0; i < inputs.size(); ++i)
  {
    const std::vector<Volume> before = std::exchange(volumes[inputs[i].key], std::move(made[i]));
    if (volumes[inputs[i].key].empty())
    {
      volumes.erase(inputs[i].key);
    }
    this->List();
    for (const Volume& volume : before)
    {
      if (this->NewestByRadar().count(volume.site.name) == 0)
      {
        this->ForgetRadar(volume.site.name);
      }
    }
  }
  return scanned;
}

// What is held, as a catalogue. Keys tell which of two copies was named first.
void LiveSeries::List()
{
  known.sites.clear();
  held.clear();
  for (auto& [key, input] : volumes)
  {
    for (Volume& volume : input)
    {
      volume.description.input = held.size();
      held.push_back(&volume);
      known.Of(volume.site).Put(volume.description);
    }
  }
}

std::vector<ChosenVolume> LiveSeries::ChosenAt(Time time) const
{
  return known.ChosenAt(time, VolumeRuleOf(options), options.moments);
}

void LiveSeries::Forget(Time from)
{
  std::set<const Volume*> needed;
  for (const ChosenVolume& each : this->ChosenAt(from))
  {
    needed.insert(held[each.volume->input]);
  }
  for (auto input = volumes.begin(); input != volumes.end();)
  {
    const bool isOver = std::all_of(input->second.begin(), input->second.end(),
      [&](const Volume& volume)
      {
        return volume.finished && volume.description.start <= from &&
               volume.description.end <= from && needed.count(&volume) == 0;
      });
    input = isOver ? volumes.erase(input) : std::next(input);
  }
  this->List();
}

std::map<std::string, Time> LiveSeries::NewestByRadar() const
{
  std::map<std::string, Time> newest;
  for (const Volume* volume : held)
  {
    Time& time = newest.emplace(volume->site.name, volume->description.end).first->second;
    time = std::max(time, volume->description.end);
  }
  return newest;
}

std::size_t LiveSeries::MemoryBytes() const
{
  std::size_t bytes = 0;
  for (const Volume* volume : held)
  {
    for (const ReadyVolume& ready : volume->ready)
    {
      bytes += ready.beam ? ready.beam->MemoryBytes() : MemoryOf(*ready.polar);
    }
  }
  return bytes;
}

std::string LiveSeries::InputsAt(Time time) const
{
  return MergeText(request) + known.MadeOf(time, VolumeRuleOf(options), options.moments);
}

bool LiveSeries::IsSettled(Time time, const std::set<std::string>& silent) const
{
  const auto isSettled = [&](const SiteSeries& own)
  {
    bool goesOn = false;
    bool finished = true;
    for (const SeriesVolume& volume : own.volumes)
    {
      const bool isFinished = held[volume.input]->finished;
      goesOn = goesOn || (isFinished && volume.start > time);
      finished = finished && (isFinished || volume.start > time);
    }
    return silent.count(own.site.name) > 0 || (goesOn && finished);
  };
  return std::all_of(known.sites.begin(), known.sites.end(), isSettled);
}

// What a merge at a time takes, for which the request is made.
std::vector<ReadyVolume> LiveSeries::VolumesFor(Time time)
{
  request.time = time;
  std::vector<ReadyVolume> ready;
  for (const ChosenVolume& each : this->ChosenAt(time))
  {
    const std::vector<ReadyVolume>& own = held[each.volume->input]->ready;
    ready.push_back(*std::find_if(own.begin(), own.end(),
      [&each](const ReadyVolume& one) { return one.Moment() == each.moment; }));
  }
  return ready;
}

std::optional<GriddedVolume> LiveSeries::Merge(
  Time time, const Progress& progress, GriddedVolume memory)
{
  const std::vector<ReadyVolume> volumes = this->VolumesFor(time);
  return MergeMoments(volumes, options.moments, request, progress, run, std::move(memory));
}

PlannedMerge LiveSeries::Plan(Time time)
{
  const std::vector<ReadyVolume> volumes = this->VolumesFor(time);
  return {volumes, options.moments, request, run};
}

PlannedMerge LiveSeries::PlanAgain(const PlannedMerge& before)
{
  return {before, this->VolumesFor(before.At())};
}

void AwaitedEnds::Keep(ScannedFile& file)
{
  for (const auto& [site, volume] : file.volumes)
  {
    const auto isSame = [&path = volume.file](const Awaited& each)
    { return each.volume.file == path; };
    awaited.erase(std::remove_if(awaited.begin(), awaited.end(), isSame), awaited.end());
  }
  const auto problem = std::find_if(file.problems.begin(), file.problems.end(),
    [](const InputProblem& each) { return each.isMissingEnd; });
  if (problem != file.problems.end() && !file.volumes.empty())
  {
    const auto& [site, last] = file.volumes.back();
    awaited.push_back({site.name, last, std::move(*problem)});
    file.problems.erase(problem);
  }
}

AwaitedEnds::Decided AwaitedEnds::TakeDecided(
  const Catalogue& known, const std::set<std::string>& silent)
{
  Decided decided;
  std::vector<Awaited> open;
  for (Awaited& each : awaited)
  {
    const SeriesVolume* next = FindNext(known, each.radar, each.volume.start);
    if (next == nullptr && silent.count(each.radar) == 0)
    {
      open.push_back(std::move(each));
      continue;
    }
    std::string note = next != nullptr ? DescribeRestart(each.volume, *next) : std::string();
    note.empty() ? decided.problems.push_back(std::move(each.problem))
                 : decided.notes.push_back(std::move(note));
  }
  awaited = std::move(open);
  return decided;
}

} // namespace nexrad
