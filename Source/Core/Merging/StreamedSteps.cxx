// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/StreamedSteps.h"

#include "nexrad/Grid/MakeGrid.h"

#include <algorithm>
#include <utility>

namespace nexrad
{
namespace
{

StreamWork WorkFor(
  const MergeRequest& request, MomentName moment, std::shared_ptr<const PlannedGrid> grid)
{
  StreamWork work;
  work.prepare = [request, moment, grid](const RadarVolume& volume)
  {
    MergeRequest onto = request;
    const std::optional<GridSpecification> planned = grid->Get();
    onto.grid = planned.value_or(request.grid);
    onto.beam.means = request.beam.means && planned;
    return MakeReady(volume, moment, onto);
  };
  work.choose = [request](const std::vector<Time>& starts, const std::vector<Time>& ends, Time time)
  {
    MergeRequest at = request;
    at.time = time;
    return ChooseVolumes(starts, ends, at);
  };
  return work;
}

SeriesOptions OneThreadAFile(SeriesOptions series)
{
  series.level2.threads = 1;
  return series;
}

// When the files' volumes began, as their headers say.
std::vector<TimeSpan> HeaderTimes(const std::vector<SiteOutline>& outline)
{
  std::vector<TimeSpan> times;
  for (const SiteOutline& site : outline)
  {
    for (const OutlinedFile& file : site.files)
    {
      times.push_back({file.time, file.time});
    }
  }
  return times;
}

// The first volume of some files, in their order; empty when there is none.
template <class Iterator>
std::optional<std::pair<Site, SeriesVolume>> FindVolume(
  Iterator begin, Iterator end, VolumeStream& stream)
{
  for (Iterator file = begin; file != end; ++file)
  {
    const ScannedFile scanned = stream.Scan(file->index);
    if (!scanned.volumes.empty())
    {
      return scanned.volumes.front();
    }
  }
  return std::nullopt;
}

} // namespace

void PlannedGrid::Set(const GridSpecification& theGrid)
{
  const std::lock_guard<std::mutex> lock(mutex);
  grid = theGrid;
}

std::optional<GridSpecification> PlannedGrid::Get() const
{
  const std::lock_guard<std::mutex> lock(mutex);
  return grid;
}

StreamedSteps::StreamedSteps(const InputFiles& inputs, std::vector<SiteOutline> sites,
  const MergeOptions& userOptions, const RangeLoop& loop, unsigned threads)
  : options(userOptions)
  , outline(std::move(sites))
  , request(MergeRequestOf(options, loop))
  , stream(inputs.paths, outline, OneThreadAFile(SeriesOptionsOf(options)),
      WorkFor(request, options.moment, plannedGrid), threads)
{
}

bool StreamedSteps::Plan()
{
  if (options.time || FindPause(options, HeaderTimes(outline)))
  {
    return false; // whether it is so, all rays must tell
  }
  for (const SiteOutline& site : outline)
  {
    stream.Expect(site.files.front().index);
    if (!options.end)
    {
      stream.Expect(site.files.back().index);
    }
  }
  std::vector<Position> positions;
  Time first = Time::max();
  Time last = Time::min();
  double range = DefaultRange;
  for (const SiteOutline& site : outline)
  {
    std::vector<OutlinedFile> asGiven = site.files;
    std::sort(asGiven.begin(), asGiven.end(),
      [](const OutlinedFile& a, const OutlinedFile& b) { return a.index < b.index; });
    const auto known = FindVolume(asGiven.begin(), asGiven.end(), stream);
    if (!known)
    {
      return false;
    }
    positions.push_back(*known->first.position);
    const auto earliest = FindVolume(site.files.begin(), site.files.end(), stream);
    range = RangeOf(earliest->first, earliest->second);
    first = std::min(first, earliest->second.start);
    if (!options.end)
    {
      last = std::max(last, FindVolume(site.files.rbegin(), site.files.rend(), stream)->second.end);
    }
  }
  if (options.begin.value_or(first) > options.end.value_or(last))
  {
    return false;
  }
  request.grid = GridOf(options, positions, outline.size() == 1 ? range : DefaultRange);
  plannedGrid->Set(request.grid);
  times = TimeStepsOf(options, first, last, this->CountVolumes());
  return true;
}

std::optional<GriddedVolume> StreamedSteps::Merge(
  Time time, const Progress& progress, GriddedVolume memory)
{
  const std::vector<ReadyVolume> volumes = stream.About(time);
  request.time = time;
  return MergeVolumes(volumes, request, progress, run, std::move(memory));
}

// Of several files at least two.
std::size_t StreamedSteps::CountVolumes()
{
  const bool alone = outline.size() == 1 && outline.front().files.size() == 1;
  return alone ? stream.Scan(outline.front().files.front().index).volumes.size() : 2;
}

bool StreamedSteps::IsAsIn(const SeriesScan& scan) const
{
  return !scan.sites.empty() && stream.IsAsIn(scan) &&
         request.grid == GridOf(options, scan.Positions(), scan.Range()) &&
         !FindPause(options, scan.Spans()) && times == TimeStepsOf(options, scan);
}

} // namespace nexrad
