// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/AwaitedEnds.h"

#include <algorithm>
#include <utility>

namespace nexrad
{

void AwaitedEnds::Keep(ScannedFile& file)
{
  for (const auto& [site, volume] : file.volumes)
  {
    const auto isSame = [&path = volume.file](const auto& each) { return each.file == path; };
    const auto isAwaited = [&isSame](const Awaited& each) { return isSame(each.volume); };
    std::vector<SeriesVolume>& own = volumes[site.name];
    own.erase(std::remove_if(own.begin(), own.end(), isSame), own.end());
    awaited.erase(std::remove_if(awaited.begin(), awaited.end(), isAwaited), awaited.end());
  }
  for (const auto& [site, volume] : file.volumes)
  {
    volumes[site.name].push_back(volume);
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

const SeriesVolume* AwaitedEnds::FindNext(const Awaited& before) const
{
  const SeriesVolume* next = nullptr;
  for (const SeriesVolume& volume : volumes.at(before.radar))
  {
    const bool follows = volume.start > before.volume.start;
    next = follows && (next == nullptr || volume.start < next->start) ? &volume : next;
  }
  return next;
}

AwaitedEnds::Decided AwaitedEnds::TakeDecided(const std::set<std::string>& silent)
{
  Decided decided;
  std::vector<Awaited> open;
  for (Awaited& each : awaited)
  {
    const SeriesVolume* next = this->FindNext(each);
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
  this->Forget();
  return decided;
}

// The newest volume of a radar, and what follows one that is awaited, are all that can tell.
void AwaitedEnds::Forget()
{
  for (auto& [radar, own] : volumes)
  {
    Time oldest = own.empty() ? Time() : own.front().start;
    for (const SeriesVolume& volume : own)
    {
      oldest = std::max(oldest, volume.start);
    }
    for (const Awaited& each : awaited)
    {
      oldest = each.radar == radar ? std::min(oldest, each.volume.start) : oldest;
    }
    own.erase(std::remove_if(own.begin(), own.end(),
                [oldest](const SeriesVolume& volume) { return volume.start < oldest; }),
      own.end());
  }
}

} // namespace nexrad
