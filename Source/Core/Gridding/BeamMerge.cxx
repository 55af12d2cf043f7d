// SPDX-License-Identifier: BSD-3-Clause
#include "Gridding/BeamMerge.h"

#include "Model/Error.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <thread>
#include <tuple>

namespace nexrad
{

namespace
{

// No radar of the network has gates beyond; the geometry is kept so far from each site.
constexpr double farthestGate = 480'000.0; // m

constexpr double weatherCeiling = 18'000.0; // m above mean sea level (Formulas G4)

// Rows between two reports of progress: few enough to stop soon, enough to share out.
constexpr int bandHeight = 64;

using SiteKey = std::tuple<std::string, double, double>;

// Sites without a name are told apart by where they stand.
SiteKey KeyOf(const Site& site)
{
  const Position position = site.name.empty() ? *site.position : Position{};
  return {site.name, position.latitude, position.longitude};
}

OverlapStrategy StrategyFor(MomentName moment, OverlapStrategy wanted)
{
  switch (moment)
  {
  case MomentName::VEL:
  case MomentName::SW:
  case MomentName::PHI:
    return OverlapStrategy::Nearest;
  default:
    return wanted;
  }
}

SamplingContext ContextFor(
  const BeamVolume& volume, const BeamMergeOptions& options, double effectiveRadius)
{
  SamplingContext context;
  context.rule = ValueRule::Of(volume.moment, options.linearReflectivity);
  context.gap = static_cast<float>(options.maximumGap.count()) / 1000.0F;
  context.effectiveRadius = static_cast<float>(effectiveRadius);
  const double ceiling = weatherCeiling - volume.site.position->altitude;
  context.ceiling = static_cast<float>(ceiling / (effectiveRadius + ceiling));
  return context;
}

// tan(γ/2) at the end of the farthest gate.
float ReachOf(const std::vector<const BeamVolume*>& volumes, double effectiveRadius)
{
  float reach = 0.0F;
  for (const BeamVolume* volume : volumes)
  {
    for (const BeamSweep& sweep : volume->sweeps)
    {
      reach = std::max(reach, sweep.Reach());
    }
  }
  return static_cast<float>(std::tan(0.5 * static_cast<double>(reach) / effectiveRadius));
}

void RunInTurn(int count, const std::function<void(int, int)>& work)
{
  work(0, count);
}

void CheckOptions(const GridSpecification& grid, const BeamMergeOptions& options)
{
  if (grid.VoxelCount() == 0)
  {
    throw Error("the grid has no voxels: each dimension must be 1 or more");
  }
  if (!(options.overlapLength > 0.0))
  {
    throw Error(
      "overlap length of " + std::to_string(options.overlapLength) + " m: must be above 0");
  }
  if (!(options.beamWidth > 0.0 && options.beamWidth < 10.0))
  {
    throw Error("beam width of " + std::to_string(options.beamWidth) +
                " degrees: must be above 0 and below 10");
  }
  if (options.maximumGap < Duration::zero())
  {
    throw Error(
      "largest gap of " + std::to_string(options.maximumGap.count()) + " ms: must not be below 0");
  }
}

} // namespace

RangeLoop ThreadLoop(unsigned threads)
{
  return [threads](int count, const std::function<void(int, int)>& work)
  {
    constexpr int share = 4;
    std::atomic<int> next{0};
    const auto run = [&next, count, &work]
    {
      for (int begin = next.fetch_add(share); begin < count; begin = next.fetch_add(share))
      {
        work(begin, std::min(begin + share, count));
      }
    };
    std::vector<std::thread> others;
    for (unsigned i = 1; i < threads; ++i)
    {
      others.emplace_back(run);
    }
    run();
    for (std::thread& other : others)
    {
      other.join();
    }
  };
}

BeamMerger::BeamMerger(const GridSpecification& theGrid, const BeamMergeOptions& theOptions)
  : grid(theGrid)
  , options(theOptions)
{
  CheckOptions(grid, options);
}

bool BeamMerger::KeptVolume::IsMadeFrom(const PolarVolume& source) const
{
  return KeyOf(volume->site) == KeyOf(source.site) && volume->start == source.start &&
         volume->end == source.end && volume->moment == source.moment &&
         sweeps == source.sweeps.size();
}

void BeamMerger::Prepare(const std::vector<const PolarVolume*>& volumes, const RangeLoop& loop)
{
  std::vector<KeptVolume> next;
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < volumes.size(); ++i)
  {
    const PolarVolume& source = *volumes[i];
    if (!source.site.position)
    {
      throw Error("site \"" + source.site.name + "\" has no position: it cannot be gridded");
    }
    if (source.moment != volumes.front()->moment)
    {
      throw Error(std::string("volumes of ") + ToString(volumes.front()->moment) + " and of " +
                  ToString(source.moment) + " cannot be merged into one: give one moment");
    }
    const auto found = std::find_if(kept.begin(), kept.end(),
      [&source](const KeptVolume& each) { return each.IsMadeFrom(source); });
    next.push_back({source.sweeps.size(), found != kept.end() ? found->volume : nullptr});
    if (found == kept.end())
    {
      missing.push_back(i);
    }
  }
  // An exception must not leave a thread of the loop: what can be wrong was looked at above.
  loop(static_cast<int>(missing.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        const std::size_t which = missing[static_cast<std::size_t>(i)];
        next[which].volume =
          std::make_shared<const BeamVolume>(PrepareBeamVolume(*volumes[which], options.beamWidth));
      }
    });
  kept = std::move(next);
}

void BeamMerger::FindGeometries(const RangeLoop& loop)
{
  const auto same = [](const Position& a, const Position& b)
  { return a.latitude == b.latitude && a.longitude == b.longitude; };
  std::vector<std::size_t> missing;
  for (const KeptVolume& each : kept)
  {
    const Position& position = *each.volume->site.position;
    const auto known = [&](const KeptGeometry& other) { return same(other.position, position); };
    if (std::none_of(geometries.begin(), geometries.end(), known))
    {
      missing.push_back(geometries.size());
      geometries.push_back({position, nullptr});
    }
  }
  loop(static_cast<int>(missing.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        KeptGeometry& to = geometries[missing[static_cast<std::size_t>(i)]];
        to.geometry =
          std::make_shared<const SiteGeometry>(grid, to.position, farthestGate, options.beam);
      }
    });
}

const SiteGeometry& BeamMerger::GeometryOf(const Position& position) const
{
  const auto found = std::find_if(geometries.begin(), geometries.end(),
    [&position](const KeptGeometry& each)
    {
      return each.position.latitude == position.latitude &&
             each.position.longitude == position.longitude;
    });
  return *found->geometry;
}

std::vector<MergeSite> BeamMerger::MakeSites(Time time) const
{
  std::map<SiteKey, std::vector<const BeamVolume*>> groups;
  for (const KeptVolume& each : kept)
  {
    groups[KeyOf(each.volume->site)].push_back(each.volume.get());
  }
  const double radius = options.beam.EffectiveRadius();
  std::vector<MergeSite> sites;
  for (const auto& group : groups)
  {
    const BeamVolume& any = *group.second.front();
    const Position& position = *any.site.position;
    const bool byDistance = StrategyFor(any.moment, options.strategy) == OverlapStrategy::Distance;
    MergeSite site{any.site.name, &this->GeometryOf(position),
      SiteLevels(grid, position.altitude, radius, byDistance ? options.overlapLength : 0.0),
      FindTilts(group.second, time, options.maximumGap), {}, ContextFor(any, options, radius),
      ReachOf(group.second, radius)};
    site.edges = FindEdges(site.tilts, options.beamWidth, options.sharpen);
    if (!site.tilts.empty())
    {
      sites.push_back(std::move(site));
    }
  }
  return sites;
}

GriddedVolume BeamMerger::EmptyVolume(
  const std::vector<MergeSite>& sites, MomentName moment, Time time) const
{
  GriddedVolume volume;
  volume.grid = grid;
  volume.time = time;
  volume.moment = moment;
  volume.method = "beam";
  for (const MergeSite& site : sites)
  {
    volume.sites.push_back(site.name);
  }
  volume.synthetic = std::any_of(
    kept.begin(), kept.end(), [](const KeptVolume& each) { return each.volume->synthetic; });
  const std::size_t count = grid.VoxelCount();
  volume.values.assign(count, volume.fill);
  volume.states.assign(count, VoxelState::NotScanned);
  if (options.companions)
  {
    volume.companions.age.assign(count, 0.0F);
    volume.companions.radars.assign(count, 0);
    volume.companions.weight.assign(count, 0.0F);
    volume.companions.nearestSite.assign(count, BeamColumn::NoSite);
  }
  return volume;
}

std::optional<GriddedVolume> BeamMerger::Merge(const std::vector<const PolarVolume*>& volumes,
  Time time, const RangeLoop& loop, const Progress& progress)
{
  const RangeLoop& run = loop ? loop : RangeLoop(RunInTurn);
  this->Prepare(volumes, run);
  this->FindGeometries(run);
  const std::vector<MergeSite> sites = this->MakeSites(time);
  const MomentName moment = volumes.empty() ? MomentName::REF : volumes.front()->moment;
  GriddedVolume volume = this->EmptyVolume(sites, moment, time);
  RowOptions rows;
  rows.strategy = StrategyFor(moment, options.strategy);
  rows.overlapLength = static_cast<float>(options.overlapLength);
  rows.fill = options.fill;
  const int height = grid.dimensions[1];
  for (int band = 0; band < height; band += bandHeight)
  {
    if (progress && !progress(static_cast<double>(band) / height))
    {
      return std::nullopt;
    }
    run(std::min(bandHeight, height - band),
      [&](int begin, int end) { MergeRows(sites, rows, band + begin, band + end, volume); });
  }
  if (progress && !progress(1.0))
  {
    return std::nullopt;
  }
  return volume;
}

} // namespace nexrad
