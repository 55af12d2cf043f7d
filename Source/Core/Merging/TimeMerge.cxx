// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/TimeMerge.h"

#include "nexrad/Model/SiteKey.h"
#include "nexrad/Series/VolumeSelection.h"
#include "nexrad/System/Error.h"
#include "nexrad/Thesis/ThesisGeometry.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>

namespace nexrad
{

namespace
{

using VolumeList = std::vector<const PolarVolume*>;

// The volumes of each site, by their starts.
std::vector<VolumeList> GroupBySite(const VolumeList& volumes)
{
  std::map<SiteKey, VolumeList> sites;
  for (const PolarVolume* volume : volumes)
  {
    sites[KeyOf(volume->site)].push_back(volume);
  }
  std::vector<VolumeList> lists;
  for (auto& site : sites)
  {
    std::stable_sort(site.second.begin(), site.second.end(),
      [](const PolarVolume* a, const PolarVolume* b) { return a->start < b->start; });
    lists.push_back(std::move(site.second));
  }
  return lists;
}

VolumeList ChooseVolumes(const VolumeList& own, const MergeRequest& request)
{
  std::vector<Time> starts;
  std::vector<Time> ends;
  for (const PolarVolume* volume : own)
  {
    starts.push_back(volume->start);
    ends.push_back(volume->end);
  }
  VolumeList chosen;
  for (const std::size_t index : ChooseVolumes(starts, ends, request))
  {
    chosen.push_back(own[index]);
  }
  return chosen;
}

std::optional<GriddedVolume> MergeByThesis(
  const std::vector<VolumeList>& sites, const MergeRequest& request, const Progress& progress)
{
  std::vector<SiteBracket> brackets;
  bool synthetic = false;
  for (const VolumeList& chosen : sites)
  {
    SiteBracket bracket;
    for (const PolarVolume* volume : chosen)
    {
      (volume->start <= request.time ? bracket.before : bracket.after) = volume;
      synthetic = synthetic || volume->synthetic;
    }
    brackets.push_back(bracket);
  }
  std::optional<GriddedVolume> merged =
    MergeThesis(brackets, request.grid, request.time, progress, request.block);
  if (merged)
  {
    merged->synthetic = synthetic;
  }
  return merged;
}

std::optional<GriddedVolume> MergeByBeam(const VolumeList& volumes, const BeamVolumes& outlines,
  const MergeRequest& request, const Progress& progress, MergeRun& run)
{
  BeamMerger& merger = run.MergerFor(request);
  BeamVolumes ready = merger.Prepare(volumes, request.loop);
  ready.insert(ready.end(), outlines.begin(), outlines.end());
  const std::shared_ptr<const MotionField> motion = run.MotionFor(ready, request);
  return merger.Merge(ready, request.time, motion.get(), request.loop, progress);
}

// The volumes of one site of a series that a request takes.
struct ChosenSite
{
  const SiteSeries* series;
  std::vector<const SeriesVolume*> volumes;
  bool reaches = true; // the block of the request, or it is not known
};

// Of sites whose digests tell how far they see, finds those that the request's block needs.
void FindReaching(std::vector<ChosenSite>& sites, const MergeRequest& request, MergeRun& run)
{
  std::vector<ChosenSite*> asked;
  std::vector<SiteReach> reaches;
  for (ChosenSite& site : sites)
  {
    const auto known = [](const SeriesVolume* volume) { return volume->digest != nullptr; };
    if (site.series->site.position && std::all_of(site.volumes.begin(), site.volumes.end(), known))
    {
      SiteReach reach{*site.series->site.position, 0.0};
      for (const SeriesVolume* volume : site.volumes)
      {
        reach.reach = std::max(reach.reach, volume->digest->reach);
      }
      asked.push_back(&site);
      reaches.push_back(reach);
    }
  }
  std::vector<bool> found;
  if (request.method == MergeMethod::Beam)
  {
    found = run.MergerFor(request).FindReaching(reaches, request.loop);
  }
  else
  {
    const VoxelBlock block = request.block.value_or(VoxelBlock::Of(request.grid));
    for (const SiteReach& each : reaches)
    {
      found.push_back(ThesisMayReach(request.grid, block, each.position, each.reach));
    }
  }
  for (std::size_t i = 0; i < asked.size(); ++i)
  {
    asked[i]->reaches = found[i];
  }
}

std::vector<ChosenSite> ChooseSites(
  const SeriesScan& scan, const MergeRequest& request, MergeRun& run)
{
  std::vector<ChosenSite> sites;
  for (const SiteSeries& series : scan.sites)
  {
    ChosenSite site{&series, {}};
    for (const std::size_t index : ChooseVolumes(series.Starts(), series.Ends(), request))
    {
      site.volumes.push_back(&series.volumes[index]);
    }
    if (!site.volumes.empty())
    {
      sites.push_back(std::move(site));
    }
  }
  FindReaching(sites, request, run);
  return sites;
}

// Whether a request's merge searches reflectivity for its motion.
bool LooksForMotion(const MergeRequest& request, MomentName moment)
{
  return request.method == MergeMethod::Beam && moment == MomentName::REF &&
         request.interpolation == TimeInterpolationMethod::AlongMotion && !request.motion;
}

bool AreSame(const BeamMergeOptions& a, const BeamMergeOptions& b)
{
  return a.strategy == b.strategy && a.overlapLength == b.overlapLength &&
         a.maximumGap == b.maximumGap && a.beamWidth == b.beamWidth &&
         a.beam.EffectiveRadius() == b.beam.EffectiveRadius() &&
         a.linearReflectivity == b.linearReflectivity && a.fill == b.fill &&
         a.companions == b.companions && a.sharpen == b.sharpen && a.means == b.means &&
         a.trend == b.trend;
}

void CheckMotion(const Velocity& motion)
{
  // Also refuses what is no number.
  if (!(std::hypot(motion.east, motion.north) <= FastestEcho))
  {
    throw Error("motion of " + std::to_string(motion.east) + " m/s towards east and " +
                std::to_string(motion.north) + " towards north: its speed must be at most " +
                std::to_string(static_cast<int>(FastestEcho)) + " m/s");
  }
}

} // namespace

ReadyVolume MakeReady(const RadarVolume& volume, MomentName moment, const MergeRequest& request)
{
  PolarVolume polar = MakeCleanVolume(volume, moment, request.quality);
  ReadyVolume ready;
  if (request.method == MergeMethod::Beam)
  {
    ready.beam =
      std::make_shared<const BeamVolume>(PrepareForGrid(polar, request.grid, request.beam));
  }
  else
  {
    ready.polar = std::make_shared<const PolarVolume>(std::move(polar));
  }
  return ready;
}

std::vector<std::size_t> ChooseVolumes(
  const std::vector<Time>& starts, const std::vector<Time>& ends, const MergeRequest& request)
{
  if (request.method == MergeMethod::Beam)
  {
    return FindVolumesAbout(starts, ends, request.time, request.maximumGap);
  }
  const VolumeBracket bracket = FindBracket(starts, request.time, request.maximumGap);
  std::vector<std::size_t> chosen;
  for (const std::optional<std::size_t>& index : {bracket.before, bracket.after})
  {
    if (index)
    {
      chosen.push_back(*index);
    }
  }
  return chosen;
}

BeamMerger& MergeRun::MergerFor(const MergeRequest& request)
{
  BeamMergeOptions options = request.beam;
  options.maximumGap = request.maximumGap;
  if (!merger || merger->Grid() != request.grid || !AreSame(merger->Options(), options))
  {
    merger = std::make_unique<BeamMerger>(request.grid, options);
    tracker = std::make_unique<MotionTracker>(request.grid, options.beam);
  }
  merger->SetBlock(request.block.value_or(VoxelBlock::Of(request.grid)));
  return *merger;
}

std::shared_ptr<const MotionField> MergeRun::MotionFor(
  const BeamVolumes& volumes, const MergeRequest& request)
{
  if (request.interpolation == TimeInterpolationMethod::Linear || volumes.empty())
  {
    return nullptr;
  }
  if (request.motion)
  {
    CheckMotion(*request.motion);
    return std::make_shared<const MotionField>(MotionField::Constant(*request.motion));
  }
  return LooksForMotion(request, volumes.front()->moment)
           ? tracker->Find(volumes, request.time, request.loop)
           : nullptr;
}

std::optional<GriddedVolume> MergeVolumes(const std::vector<const PolarVolume*>& volumes,
  const MergeRequest& request, const Progress& progress, MergeRun* run)
{
  std::vector<VolumeList> sites;
  for (const VolumeList& own : GroupBySite(volumes))
  {
    VolumeList chosen = ChooseVolumes(own, request);
    if (!chosen.empty())
    {
      sites.push_back(std::move(chosen));
    }
  }
  if (request.method == MergeMethod::Thesis)
  {
    return MergeByThesis(sites, request, progress);
  }
  VolumeList chosen;
  for (const VolumeList& own : sites)
  {
    chosen.insert(chosen.end(), own.begin(), own.end());
  }
  MergeRun once;
  return MergeByBeam(chosen, {}, request, progress, run != nullptr ? *run : once);
}

std::optional<GriddedVolume> MergeVolumes(const std::vector<ReadyVolume>& volumes,
  const MergeRequest& request, const Progress& progress, MergeRun& run, GriddedVolume memory)
{
  if (request.method == MergeMethod::Beam)
  {
    BeamVolumes ready;
    for (const ReadyVolume& volume : volumes)
    {
      ready.push_back(volume.beam);
    }
    BeamMerger& merger = run.MergerFor(request);
    const std::shared_ptr<const MotionField> motion = run.MotionFor(ready, request);
    return merger.Merge(
      ready, request.time, motion.get(), request.loop, progress, std::move(memory));
  }
  VolumeList polar;
  for (const ReadyVolume& volume : volumes)
  {
    polar.push_back(volume.polar.get());
  }
  return MergeVolumes(polar, request, progress, &run);
}

std::shared_ptr<const BeamVolume> MergeRun::OutlineOf(
  const Site& site, const SeriesVolume& volume, const MergeRequest& request, MomentName moment)
{
  const bool pictured = LooksForMotion(request, moment);
  outlines.erase(std::remove_if(outlines.begin(), outlines.end(),
                   [](const Outline& each) { return each.volume.expired(); }),
    outlines.end());
  for (const Outline& each : outlines)
  {
    if (each.digest == volume.digest && each.pictured == pictured)
    {
      return each.volume.lock();
    }
  }
  BeamVolume outline;
  outline.site = site;
  outline.moment = moment;
  outline.start = volume.start;
  outline.end = volume.end;
  outline.synthetic = volume.synthetic;
  if (pictured)
  {
    outline.composite = CompositeOf(*volume.digest);
  }
  auto made = std::make_shared<const BeamVolume>(std::move(outline));
  outlines.push_back({volume.digest, pictured, made});
  return made;
}

std::optional<GriddedVolume> MergeSeries(const SeriesScan& scan, PolarCache& cache,
  const MergeRequest& request, const Progress& progress, MergeRun* run)
{
  MergeRun once;
  MergeRun& shared = run != nullptr ? *run : once;
  const std::vector<ChosenSite> sites = ChooseSites(scan, request, shared);
  // Reading is the first half of the progress when files must be decoded again.
  const Progress reading = ShareOf(progress, 0.0, 0.5);
  std::vector<std::shared_ptr<const PolarVolume>> inUse;
  BeamVolumes outlines;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    if (reading && !reading(static_cast<double>(i) / static_cast<double>(sites.size())))
    {
      return std::nullopt;
    }
    const Site& site = sites[i].series->site;
    for (const SeriesVolume* volume : sites[i].volumes)
    {
      if (sites[i].reaches)
      {
        inUse.push_back(cache.Get(*volume));
      }
      else if (request.method == MergeMethod::Beam)
      {
        outlines.push_back(shared.OutlineOf(site, *volume, request, cache.Moment()));
      }
      else
      {
        inUse.push_back(std::make_shared<const PolarVolume>(
          PolarVolume{site, cache.Moment(), volume->start, volume->end, volume->synthetic, {}}));
      }
    }
  }
  VolumeList volumes;
  for (const std::shared_ptr<const PolarVolume>& volume : inUse)
  {
    volumes.push_back(volume.get());
  }
  const Progress merging = ShareOf(progress, 0.5, 1.0);
  return request.method == MergeMethod::Beam
           ? MergeByBeam(volumes, outlines, request, merging, shared)
           : MergeVolumes(volumes, request, merging, &shared);
}

} // namespace nexrad
