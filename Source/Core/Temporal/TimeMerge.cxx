// SPDX-License-Identifier: BSD-3-Clause
#include "Temporal/TimeMerge.h"

#include "Gridding/ThesisMerge.h"
#include "Temporal/VolumeSelection.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <tuple>

namespace nexrad
{

namespace
{

std::optional<GriddedVolume> MergeBrackets(
  const std::vector<SiteBracket>& brackets, const MergeRequest& request, const Progress& progress)
{
  switch (request.method)
  {
  case MergeMethod::Thesis:
    return MergeThesis(brackets, request.grid, request.time, progress);
  }
  return std::nullopt;
}

bool AnySynthetic(const std::vector<SiteBracket>& brackets)
{
  return std::any_of(brackets.begin(), brackets.end(),
    [](const SiteBracket& each)
    {
      return (each.before != nullptr && each.before->synthetic) ||
             (each.after != nullptr && each.after->synthetic);
    });
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
  }
  return "";
}

std::optional<MergeMethod> ParseMergeMethod(std::string_view text)
{
  return text == ToString(MergeMethod::Thesis) ? std::optional<MergeMethod>(MergeMethod::Thesis)
                                               : std::nullopt;
}

std::optional<GriddedVolume> MergeVolumes(const std::vector<const PolarVolume*>& volumes,
  const MergeRequest& request, const Progress& progress)
{
  // Sites without a name are told apart by where they stand.
  std::map<std::tuple<std::string, double, double>, std::vector<const PolarVolume*>> sites;
  for (const PolarVolume* volume : volumes)
  {
    const Position position =
      volume->site.name.empty() ? volume->site.position.value_or(Position{}) : Position{};
    sites[{volume->site.name, position.latitude, position.longitude}].push_back(volume);
  }
  std::vector<SiteBracket> brackets;
  for (auto& site : sites)
  {
    std::vector<const PolarVolume*>& own = site.second;
    std::stable_sort(own.begin(), own.end(),
      [](const PolarVolume* a, const PolarVolume* b) { return a->start < b->start; });
    std::vector<Time> starts;
    std::transform(own.begin(), own.end(), std::back_inserter(starts),
      [](const PolarVolume* volume) { return volume->start; });
    const VolumeBracket bracket = FindBracket(starts, request.time, request.maximumGap);
    if (bracket.before || bracket.after)
    {
      brackets.push_back({bracket.before ? own[*bracket.before] : nullptr,
        bracket.after ? own[*bracket.after] : nullptr});
    }
  }
  std::optional<GriddedVolume> merged = MergeBrackets(brackets, request, progress);
  if (merged)
  {
    merged->synthetic = AnySynthetic(brackets);
  }
  return merged;
}

std::optional<GriddedVolume> MergeSeries(
  const SeriesScan& scan, PolarCache& cache, const MergeRequest& request, const Progress& progress)
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
    const VolumeBracket bracket = FindBracket(series.Starts(), request.time, request.maximumGap);
    for (const std::optional<std::size_t>& index : {bracket.before, bracket.after})
    {
      if (index)
      {
        inUse.push_back(cache.Get(series.volumes[*index]));
      }
    }
  }
  std::vector<const PolarVolume*> volumes;
  for (const std::shared_ptr<const PolarVolume>& volume : inUse)
  {
    volumes.push_back(volume.get());
  }
  return MergeVolumes(volumes, request, Share(progress, 0.5, 1.0));
}

} // namespace nexrad
