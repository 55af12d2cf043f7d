// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Live/AwaitedEnds.h"

#include <algorithm>
#include <utility>

namespace nexrad
{

namespace
{

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
