// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/TimeMerge.h"

#include "nexrad/Merging/MergeSettings.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Settings/ValueTexts.h"
#include "nexrad/System/Error.h"
#include "nexrad/Thesis/ThesisGeometry.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

namespace nexrad
{

namespace
{

std::optional<GriddedVolume> MergeByThesis(
  const std::vector<ReadyVolume>& volumes, const MergeRequest& request, const Progress& progress)
{
  std::map<SiteKey, SiteBracket> sites;
  bool synthetic = false;
  for (const ReadyVolume& each : volumes)
  {
    const PolarVolume& volume = *each.polar;
    SiteBracket& bracket = sites[KeyOf(volume.site)];
    (volume.start <= request.time ? bracket.before : bracket.after) = &volume;
    synthetic = synthetic || volume.synthetic;
  }
  std::vector<SiteBracket> brackets;
  for (const auto& [key, bracket] : sites)
  {
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

// Whether a merger with one of them serves for the other.
bool AreSame(const BeamMergeOptions& a, const BeamMergeOptions& b)
{
  MergeOptions settings;
  settings.beam = a;
  MergeOptions others;
  others.beam = b;
  const bool sameInCode = a.maximumGap == b.maximumGap && a.beamWidth == b.beamWidth &&
                          a.beam.EffectiveRadius() == b.beam.EffectiveRadius() &&
                          a.means == b.means && a.trend == b.trend &&
                          a.codes == b.codes; // are no settings
  return sameInCode && AreSame(MergeSettings(), settings, others);
}

std::vector<ReadyVolume> VolumesOf(const std::vector<ReadyVolume>& volumes, MomentName moment)
{
  std::vector<ReadyVolume> own;
  std::copy_if(volumes.begin(), volumes.end(), std::back_inserter(own),
    [moment](const ReadyVolume& volume) { return volume.Moment() == moment; });
  return own;
}

BeamVolumes BeamVolumesOf(const std::vector<ReadyVolume>& volumes)
{
  BeamVolumes ready;
  for (const ReadyVolume& volume : volumes)
  {
    ready.push_back(volume.beam);
  }
  return ready;
}

// One volume of several moments, of which `merge(number, memory)` makes each; empty when it does
// not.
template <class Merge>
std::optional<GriddedVolume> MergeEachMoment(
  const std::vector<MomentName>& moments, GriddedVolume memory, const Merge& merge)
{
  std::vector<GriddedVolume> memories = SplitMoments(std::move(memory));
  memories.resize(moments.size());
  std::vector<GriddedVolume> merged;
  for (std::size_t i = 0; i < moments.size(); ++i)
  {
    std::optional<GriddedVolume> one = merge(i, std::move(memories[i]));
    if (!one)
    {
      return std::nullopt;
    }
    one->moment = moments[i]; // which a merge of no volumes does not know
    merged.push_back(std::move(*one));
  }
  return JoinMoments(std::move(merged));
}

// The cells of `size` columns along x and y of a tile.
class Cells
{
public:
  Cells(const VoxelBlock& tile, int theSize)
    : width(static_cast<std::size_t>(tile.Size(0)))
    , size(static_cast<std::size_t>(theSize))
    , across((width - 1) / size + 1)
    , count(across * ((static_cast<std::size_t>(tile.Size(1)) - 1) / size + 1))
  {
  }

  std::size_t Count() const { return count; }
  // The one in which a column stands.
  std::size_t Of(std::size_t column) const
  {
    return column / width / size * across + column % width / size;
  }

private:
  std::size_t width;
  std::size_t size;
  std::size_t across;
  std::size_t count;
};

} // namespace

MergeRequest MergeRequestOf(const MergeOptions& options, const RangeLoop& loop)
{
  MergeRequest request;
  static_cast<MergeRules&>(request) = options;
  request.loop = loop;
  return request;
}

std::string MergeText(const MergeRequest& request)
{
  std::string text = GridText(request.grid); // rounds; the numbers follow
  for (const auto* numbers : {&request.grid.origin, &request.grid.spacing})
  {
    for (const double number : *numbers)
    {
      text += ' ' + NumberText(number);
    }
  }
  text +=
    ' ' + NumberText(request.grid.centreLatitude) + ' ' + NumberText(request.grid.centreLongitude);
  for (const auto& [radar, bias] : request.beam.biases)
  {
    text += ' ' + radar + ':' + NumberText(bias);
  }
  return text;
}

bool LooksForMotion(const MergeRequest& request, MomentName moment)
{
  return request.method == MergeMethod::Beam && moment == MomentName::REF &&
         request.interpolation == TimeInterpolationMethod::AlongMotion && !request.motion;
}

ReadyVolume MakeReady(const std::shared_ptr<const PolarVolume>& volume, const MergeRequest& request)
{
  if (request.method == MergeMethod::Thesis)
  {
    return {volume, nullptr};
  }
  return {nullptr,
    std::make_shared<const BeamVolume>(PrepareForGrid(*volume, request.grid, request.beam))};
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
    const Velocity& motion = *request.motion;
    // Also refuses what is no number.
    if (!(std::hypot(motion.east, motion.north) <= FastestEcho))
    {
      throw Error("motion of " + std::to_string(motion.east) + " m/s towards east and " +
                  std::to_string(motion.north) + " towards north: its speed must be at most " +
                  std::to_string(static_cast<int>(FastestEcho)) + " m/s");
    }
    return std::make_shared<const MotionField>(MotionField::Constant(motion));
  }
  return LooksForMotion(request, volumes.front()->moment)
           ? tracker->Find(volumes, request.time, request.loop)
           : nullptr;
}

std::optional<GriddedVolume> MergeVolumes(const std::vector<ReadyVolume>& volumes,
  const MergeRequest& request, const Progress& progress, MergeRun& run, GriddedVolume memory)
{
  if (request.method == MergeMethod::Thesis)
  {
    return MergeByThesis(volumes, request, progress);
  }
  const BeamVolumes ready = BeamVolumesOf(volumes);
  BeamMerger& merger = run.MergerFor(request);
  const std::shared_ptr<const MotionField> motion = run.MotionFor(ready, request);
  return merger.Merge(ready, request.time, motion.get(), request.loop, progress, std::move(memory));
}

std::optional<GriddedVolume> MergeMoments(const std::vector<ReadyVolume>& volumes,
  const std::vector<MomentName>& moments, const MergeRequest& request, const Progress& progress,
  MergeRun& run, GriddedVolume memory)
{
  return MergeEachMoment(moments, std::move(memory),
    [&](std::size_t i, GriddedVolume own)
    {
      return MergeVolumes(VolumesOf(volumes, moments[i]), request,
        ShareOf(progress, i, moments.size()), run, std::move(own));
    });
}

PlannedMerge::PlannedMerge(const std::vector<ReadyVolume>& volumes,
  const std::vector<MomentName>& theMoments, const MergeRequest& theRequest, MergeRun& theRun)
  : moments(theMoments)
  , request(theRequest)
  , run(&theRun)
{
  for (const MomentName moment : moments)
  {
    const BeamVolumes own = BeamVolumesOf(VolumesOf(volumes, moment));
    BeamMerger& merger = run->MergerFor(request);
    const auto motion = run->MotionFor(own, request);
    planned.push_back({motion, merger.Plan(own, request.time, motion.get(), request.loop)});
  }
}

PlannedMerge::PlannedMerge(const PlannedMerge& before, const std::vector<ReadyVolume>& volumes)
  : moments(before.moments)
  , request(before.request)
  , run(before.run)
{
  for (std::size_t i = 0; i < moments.size(); ++i)
  {
    const BeamVolumes own = BeamVolumesOf(VolumesOf(volumes, moments[i]));
    const OfMoment& other = before.planned[i];
    planned.push_back(
      {other.motion, run->MergerFor(request).PlanAgain(other.plan, own, request.loop)});
  }
}

void PlannedMerge::NoteEchoes()
{
  const auto& [x, y, z] = request.grid.dimensions;
  for (OfMoment& each : planned)
  {
    each.plan.echoes.assign(static_cast<std::size_t>(x) * static_cast<std::size_t>(y), 1);
  }
}

bool PlannedMerge::MergeBands(int rows, const TakeBand& take, const Progress& progress)
{
  const VoxelBlock all = request.block.value_or(VoxelBlock::Of(request.grid));
  MergeRequest part = request;
  GriddedVolume memory;
  for (int row = all.begin[1]; row < all.end[1]; row += rows)
  {
    VoxelBlock band = all;
    band.begin[1] = row;
    band.end[1] = std::min(row + rows, all.end[1]);
    part.block = band;
    BeamMerger& merger = run->MergerFor(part);
    std::optional<GriddedVolume> merged = MergeEachMoment(moments, std::move(memory),
      [&](std::size_t i, GriddedVolume own)
      { return merger.Merge(planned[i].plan, part.loop, {}, std::move(own)); });
    memory = take(std::move(merged.value()));
    const int made = band.end[1] - all.begin[1];
    if (progress && !progress(static_cast<double>(made) / all.Size(1)))
    {
      return false;
    }
  }
  return true;
}

bool PlannedMerge::KeepsVoxelsOf(const PlannedMerge& before) const
{
  const auto radarsOf = [](const PlannedMerge& plan)
  {
    std::set<std::pair<MomentName, SiteKey>> radars;
    for (const OfMoment& each : plan.planned)
    {
      for (const std::shared_ptr<const BeamVolume>& volume : each.plan.volumes)
      {
        radars.emplace(volume->moment, KeyOf(volume->site));
      }
    }
    return radars;
  };
  return !request.beam.ancillary || radarsOf(*this) == radarsOf(before);
}

std::vector<VoxelBlock> PlannedMerge::FindTiles(const PlannedMerge& before, int size) const
{
  std::vector<VoxelBlock> tiles;
  for (std::size_t i = 0; i < planned.size(); ++i)
  {
    for (const VoxelBlock& tile :
      run->MergerFor(request).FindTiles(before.planned[i].plan, planned[i].plan, size))
    {
      if (std::find(tiles.begin(), tiles.end(), tile) == tiles.end())
      {
        tiles.push_back(tile);
      }
    }
  }
  return tiles;
}

std::optional<ChangedTile> PlannedMerge::MergeTile(
  const PlannedMerge& before, const VoxelBlock& tile, int cell)
{
  const BeamMerger& merger = run->Merger();
  const Cells cells(tile, cell);
  ChangedTile made{tile, {}, std::vector<std::uint8_t>(cells.Count())};
  std::vector<std::uint8_t> columns;
  for (std::size_t i = 0; i < planned.size(); ++i)
  {
    columns = merger.FindChanges(before.planned[i].plan, planned[i].plan, tile);
    for (std::size_t column = 0; column < columns.size(); ++column)
    {
      std::uint8_t& changed = made.changed[cells.Of(column)];
      changed = columns[column] != 0 ? 1 : changed;
    }
  }
  if (std::find(made.changed.begin(), made.changed.end(), 1) == made.changed.end())
  {
    return std::nullopt;
  }
  for (std::size_t column = 0; column < columns.size(); ++column)
  {
    columns[column] = made.changed[cells.Of(column)];
  }
  std::optional<GriddedVolume> merged = MergeEachMoment(moments, {},
    [&](std::size_t i, const GriddedVolume&)
    { return std::optional(merger.MergeColumnsOf(planned[i].plan, tile, columns)); });
  made.volume = std::move(merged.value());
  return made;
}

GriddedVolume PlannedMerge::Describe() const
{
  const BeamMerger& merger = run->Merger();
  return MergeEachMoment(moments, {},
    [&](std::size_t i, const GriddedVolume&)
    { return std::optional(merger.Describe(planned[i].plan)); })
    .value();
}

} // namespace nexrad
