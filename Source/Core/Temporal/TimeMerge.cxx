// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/TimeMerge.h"

#include "Gridding/ThesisMerge.h"
#include "Model/Error.h"
#include "Temporal/VolumeSelection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <tuple>

namespace nexrad
{

namespace
{

using VolumeList = std::vector<const PolarVolume*>;

// The volumes of each site, by their starts. Sites without a name are told apart by where they
// stand.
std::vector<VolumeList> GroupBySite(const VolumeList& volumes)
{
  std::map<std::tuple<std::string, double, double>, VolumeList> sites;
  for (const PolarVolume* volume : volumes)
  {
    const Position position =
      volume->site.name.empty() ? volume->site.position.value_or(Position{}) : Position{};
    sites[{volume->site.name, position.latitude, position.longitude}].push_back(volume);
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
  std::optional<GriddedVolume> merged = MergeThesis(brackets, request.grid, request.time, progress);
  if (merged)
  {
    merged->synthetic = synthetic;
  }
  return merged;
}

std::optional<GriddedVolume> MergeByBeam(const std::vector<VolumeList>& sites,
  const MergeRequest& request, const Progress& progress, MergeRun* run)
{
  VolumeList volumes;
  for (const VolumeList& chosen : sites)
  {
    volumes.insert(volumes.end(), chosen.begin(), chosen.end());
  }
  MergeRun once;
  MergeRun& shared = run != nullptr ? *run : once;
  BeamMerger& merger = shared.MergerFor(request);
  const BeamVolumes ready = merger.Prepare(volumes, request.loop);
  const std::shared_ptr<const MotionField> motion = shared.MotionFor(ready, request);
  return merger.Merge(ready, request.time, motion.get(), request.loop, progress);
}

bool AreSame(const GridSpecification& a, const GridSpecification& b)
{
  return a.dimensions == b.dimensions && a.origin == b.origin && a.spacing == b.spacing &&
         a.axes == b.axes && a.centreLatitude == b.centreLatitude &&
         a.centreLongitude == b.centreLongitude;
}

bool AreSame(const BeamMergeOptions& a, const BeamMergeOptions& b)
{
  return a.strategy == b.strategy && a.overlapLength == b.overlapLength &&
         a.maximumGap == b.maximumGap && a.beamWidth == b.beamWidth &&
         a.beam.EffectiveRadius() == b.beam.EffectiveRadius() &&
         a.linearReflectivity == b.linearReflectivity && a.fill == b.fill &&
         a.companions == b.companions && a.sharpen == b.sharpen;
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

/// The share [from, to] of a longer piece of work, as a piece of work of its own.
Progress Share(const Progress& whole, double from, double to)
{
  if (!whole)
  {
    return {};
  }
  return [whole, from, to](double done) { return whole(from + (to - from) * done); };
}

} // namespace

const char* ToString(MergeMethod method)
{
  switch (method)
  {
  case MergeMethod::Thesis:
    return "thesis";
  case MergeMethod::Beam:
    return "beam";
  }
  return "";
}

std::optional<MergeMethod> ParseMergeMethod(std::string_view text)
{
  for (const MergeMethod method : {MergeMethod::Thesis, MergeMethod::Beam})
  {
    if (text == ToString(method))
    {
      return method;
    }
  }
  return std::nullopt;
}

void RequireMoment(MergeMethod method, MomentName moment)
{
  if (method == MergeMethod::Thesis && moment != MomentName::REF)
  {
    throw Error(
      std::string("moment ") + ToString(moment) +
      " cannot be merged by the thesis's method, which knows reflectivity alone: set REF");
  }
}

ReadyVolume MakeReady(const RadarVolume& volume, MomentName moment, const MergeRequest& request)
{
  PolarVolume polar = MakePolarVolume(volume, moment);
  ReadyVolume ready;
  if (request.method == MergeMethod::Beam)
  {
    ready.beam =
      std::make_shared<const BeamVolume>(PrepareBeamVolume(polar, request.beam.beamWidth));
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
  if (!merger || !AreSame(merger->Grid(), request.grid) || !AreSame(merger->Options(), options))
  {
    merger = std::make_unique<BeamMerger>(request.grid, options);
    tracker = std::make_unique<MotionTracker>(request.grid, options.beam);
  }
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
  return volumes.front()->moment == MomentName::REF
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
  return request.method == MergeMethod::Thesis ? MergeByThesis(sites, request, progress)
                                               : MergeByBeam(sites, request, progress, run);
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

std::optional<GriddedVolume> MergeSeries(const SeriesScan& scan, PolarCache& cache,
  const MergeRequest& request, const Progress& progress, MergeRun* run)
{
  // Reading is the first half of the progress when files must be decoded again.
  const Progress reading = Share(progress, 0.0, 0.5);
  std::vector<std::shared_ptr<const PolarVolume>> inUse;
  for (std::size_t i = 0; i < scan.sites.size(); ++i)
  {
    if (reading && !reading(static_cast<double>(i) / static_cast<double>(scan.sites.size())))
    {
      return std::nullopt;
    }
    const SiteSeries& series = scan.sites[i];
    for (const std::size_t index : ChooseVolumes(series.Starts(), series.Ends(), request))
    {
      inUse.push_back(cache.Get(series.volumes[index]));
    }
  }
  VolumeList volumes;
  for (const std::shared_ptr<const PolarVolume>& volume : inUse)
  {
    volumes.push_back(volume.get());
  }
  return MergeVolumes(volumes, request, Share(progress, 0.5, 1.0), run);
}

} // namespace nexrad
