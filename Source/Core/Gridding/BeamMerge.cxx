// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Gridding/BeamMerge.h"

#include "nexrad/Beams/BeamSharpening.h"
#include "nexrad/Beams/SweepMeans.h"
#include "nexrad/Model/Site.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <mutex>
#include <set>
#include <sstream>

namespace nexrad
{

namespace
{

constexpr double weatherCeiling = 18'000.0; // m above mean sea level (Formulas G4)

// Rows between two reports of progress: few enough to stop soon, enough to share out.
constexpr int bandHeight = 128;

// Rows that a thread merges together: neighbours look the same gates up.
constexpr int rowsTogether = 8;

// m above the antenna. Without a position there is no merge.
double CeilingOver(const Site& site)
{
  return weatherCeiling - (site.position ? site.position->altitude : 0.0);
}

SamplingContext ContextFor(
  const BeamVolume& volume, const BeamMergeOptions& options, double effectiveRadius)
{
  SamplingContext context;
  context.rule = ValueRule::Of(volume.moment, options.linearReflectivity);
  context.ages = options.ancillary;
  context.gap = static_cast<float>(options.maximumGap.count()) / 1000.0F;
  context.effectiveRadius = static_cast<float>(effectiveRadius);
  const double ceiling = CeilingOver(volume.site);
  context.ceiling = static_cast<float>(ceiling / (effectiveRadius + ceiling));
  return context;
}

// tan(γ/2) at a slant range, or more.
float HalfTangentAt(double slantRange, double effectiveRadius)
{
  return static_cast<float>(std::tan(0.5 * slantRange / effectiveRadius));
}

// The largest of what the sweeps of volumes have, at least 0.
template <class Of>
double LargestOf(const std::vector<const BeamVolume*>& volumes, const Of& of)
{
  float largest = 0.0F;
  for (const BeamVolume* volume : volumes)
  {
    for (const BeamSweep& sweep : volume->sweeps)
    {
      largest = std::max(largest, of(sweep));
    }
  }
  return static_cast<double>(largest);
}

// Seconds from the time to the farthest ray of a list that may be needed.
float LongestTime(const std::vector<TiltObservation>& observations, bool after)
{
  float longest = 0.0F;
  float reach = 0.0F; // m, of what ended the search
  for (const TiltObservation& observation : observations)
  {
    if (reach == 0.0F || observation.lower->Reach() > reach || observation.upper != nullptr)
    {
      longest = std::max(longest, after ? observation.End() : -observation.Begin());
    }
    if (observation.IsWhole(after))
    {
      reach = std::max(reach, observation.lower->Reach());
    }
  }
  return longest;
}

// Where a radar has echo that counts in the sample of a column, once it has moved. Gates count that
// are so far away, but for one gate or ray beside.
void FindEcho(double effectiveRadius, double fastest, MergeSite& site)
{
  for (const BeamTilt& tilt : site.tilts)
  {
    site.since = std::max(site.since, LongestTime(tilt.before, false));
    site.until = std::max(site.until, LongestTime(tilt.after, true));
  }
  const double spread =
    LargestOf(site.volumes, [](const BeamSweep& sweep) { return sweep.means.spread; });
  std::vector<const VolumeComposite*> composites;
  for (const BeamVolume* volume : site.volumes)
  {
    composites.push_back(&volume->composite);
  }
  const double way = fastest * static_cast<double>(std::max(site.since, site.until));
  site.mask = EchoMask(composites, effectiveRadius, way + spread);
  if (way > MergeSite::NearDistance)
  {
    site.nearMask = EchoMask(composites, effectiveRadius, MergeSite::NearDistance + spread);
  }
}

// The volumes of each radar.
std::map<SiteKey, std::vector<const BeamVolume*>> GroupBySite(const BeamVolumes& volumes)
{
  std::map<SiteKey, std::vector<const BeamVolume*>> groups;
  for (const std::shared_ptr<const BeamVolume>& volume : volumes)
  {
    groups[KeyOf(volume->site)].push_back(volume.get());
  }
  return groups;
}

// A site's north in the directions of the grid's axes. On projected axes the meridians converge; by
// how much, hardly changes over the reach of a radar.
std::array<double, 2> NorthIn(const GridSpecification& grid, const Position& site)
{
  if (grid.axes == GridAxes::Geographic)
  {
    return {0.0, 1.0};
  }
  constexpr double way = 0.01; // degrees of latitude
  const auto south = grid.FromGeographic(site.longitude, site.latitude - way);
  const auto north = grid.FromGeographic(site.longitude, site.latitude + way);
  const double length = std::hypot(north[0] - south[0], north[1] - south[1]);
  return {(north[0] - south[0]) / length, (north[1] - south[1]) / length};
}

// Knows tilts without echo by the distance, where age is not wanted and every voxel that a radar
// scanned has a weight that a float can hold.
void FindQuietZones(double overlapLength, bool byDistance, MergeSite& site)
{
  site.lowestQuiet = 255;
  for (const QuietTilt& tilt : site.quiet)
  {
    site.lowestQuiet = std::min(site.lowestQuiet, tilt.elevation);
  }
  constexpr double leastWeight = 1e-30;
  const double chord =
    2.0 * static_cast<double>(site.context.effectiveRadius * site.reach) / overlapLength;
  const double ofDistance = byDistance ? std::exp(-chord * chord) : 1.0;
  const float ofHeight = *std::min_element(site.levels.weight.begin(), site.levels.weight.end());
  if (!site.context.ages && ofDistance * static_cast<double>(ofHeight) > leastWeight)
  {
    site.zones = QuietZones(site.tilts, site.quiet, site.context);
  }
}

// The shorter side of a voxel about a site, m; 0 for no means.
double SideOfMeans(const Site& site, const GridSpecification& grid, const BeamMergeOptions& options)
{
  if (!options.means || !site.position)
  {
    return 0.0;
  }
  const double y = grid.FromGeographic(site.position->longitude, site.position->latitude)[1];
  const double row = (y - grid.origin[1]) / grid.spacing[1];
  const std::array<double, 2> extent =
    VoxelExtent(grid, std::clamp(row, 0.0, static_cast<double>(grid.dimensions[1] - 1)));
  return std::min(extent[0], extent[1]);
}

// The means that the options ask for, in place of those that a volume has.
void MakeMeans(const GridSpecification& grid, const BeamMergeOptions& options, BeamVolume& volume)
{
  const ValueRule rule = ValueRule::Of(volume.moment, options.linearReflectivity);
  volume.voxelSide = SideOfMeans(volume.site, grid, options);
  for (BeamSweep& sweep : volume.sweeps)
  {
    sweep.means =
      volume.voxelSide > 0.0 ? MakeSweepMeans(sweep, rule, volume.voxelSide) : SweepMeans();
  }
}

// Takes the bias of its radar off reflectivity. Codes stay as they are.
void TakeBiasOff(const RadarBiases& biases, BeamVolume& volume)
{
  const auto bias = biases.find(volume.site.name);
  if (volume.moment == MomentName::REF && bias != biases.end())
  {
    for (BeamSweep& sweep : volume.sweeps)
    {
      sweep.scale.base -= static_cast<float>(bias->second);
    }
  }
}

// Of what the radar measures, reflectivity in dBZ alone is known to be a mean of Z.
bool IsSharpened(MomentName moment, const BeamMergeOptions& options)
{
  return moment == MomentName::REF && !options.linearReflectivity && options.sharpen;
}

// Says of a radar all of whose volumes are cut off where they end. Another volume fills up what one
// lacks.
void AddNote(const std::vector<const BeamVolume*>& ofSite, std::vector<std::string>& notes)
{
  double highest = 0.0;
  for (const BeamVolume* volume : ofSite)
  {
    if (!volume->endsAt)
    {
      return;
    }
    highest = std::max(highest, *volume->endsAt);
  }
  std::ostringstream note;
  note.imbue(std::locale::classic());
  note << ofSite.front()->site.name << ": volume ends at " << std::round(10.0 * highest) / 10.0
       << "°, cut off";
  notes.push_back(note.str());
}

} // namespace

OverlapStrategy StrategyFor(MomentName moment, OverlapStrategy wanted)
{
  switch (moment)
  {
  case MomentName::VEL:
  case MomentName::SW:
  case MomentName::PHI:
  case MomentName::SRV:
  case MomentName::DIV: // the largest of several radars would hide convergence
    return OverlapStrategy::Nearest;
  case MomentName::AZSHEAR:
    return OverlapStrategy::Maximum;
  default:
    return wanted;
  }
}

bool HasCodes(const BeamMergeOptions& options, MomentName moment)
{
  return options.codes && MomentCode::Widest(moment).bytes == 1;
}

BeamVolume PrepareForGrid(
  const PolarVolume& volume, const GridSpecification& grid, const BeamMergeOptions& options)
{
  const double beamWidth = options.beamWidth.value_or(BeamWidthOf(volume.site));
  BeamVolume prepared = PrepareBeamVolume(volume, beamWidth);
  TakeBiasOff(options.biases, prepared);
  const bool decibels = volume.moment == MomentName::REF && !options.linearReflectivity;
  if (IsSharpened(volume.moment, options))
  {
    SharpenSweeps(prepared.sweeps, beamWidth, options.beam);
  }
  if (decibels && options.trend)
  {
    const double ceiling = CeilingOver(volume.site);
    prepared.layers =
      std::make_shared<const EchoLayers>(prepared.sweeps, beamWidth, options.beam, ceiling);
  }
  MakeMeans(grid, options, prepared);
  return prepared;
}

std::size_t GeometryBytes(
  const GridSpecification& grid, const std::vector<Position>& radars, int rows)
{
  std::size_t bytes = 0;
  for (const Position& radar : radars)
  {
    bytes += SiteGeometry::MemoryBytesOf(grid, radar, SiteGeometry::FarthestGate, rows);
  }
  return bytes;
}

BeamMerger::BeamMerger(const GridSpecification& theGrid, const BeamMergeOptions& theOptions)
  : grid(theGrid)
  , options(theOptions)
  , block(VoxelBlock::Of(theGrid))
{
  if (grid.VoxelCount() == 0)
  {
    throw Error("the grid has no voxels: each dimension must be 1 or more");
  }
}

void BeamMerger::SetBlock(const VoxelBlock& part)
{
  if (block != part)
  {
    PartOf(grid, part); // throws for what is no part of it
    block = part;
    geometries.clear();
  }
}

std::vector<bool> BeamMerger::FindReaching(
  const std::vector<SiteReach>& radars, const RangeLoop& loop)
{
  std::vector<Position> positions;
  for (const SiteReach& radar : radars)
  {
    positions.push_back(radar.position);
  }
  this->FindGeometries(positions, loop);
  std::vector<bool> reaching;
  for (const SiteReach& radar : radars)
  {
    reaching.push_back(this->GeometryOf(radar.position).Nearest() <=
                       HalfTangentAt(radar.reach, options.beam.EffectiveRadius()));
  }
  return reaching;
}

BeamVolumes BeamMerger::WithMeans(const BeamVolumes& volumes, const RangeLoop& loop)
{
  const auto isGone = [](const Remade& each) { return each.source.expired(); };
  remade.erase(std::remove_if(remade.begin(), remade.end(), isGone), remade.end());
  const auto find = [this](const std::shared_ptr<const BeamVolume>& volume)
  {
    return std::find_if(remade.begin(), remade.end(),
      [&volume](const Remade& each) { return each.source.lock() == volume; });
  };
  std::vector<Remade> missing;
  for (const std::shared_ptr<const BeamVolume>& volume : volumes)
  {
    const bool hasMeans =
      volume->sweeps.empty() || volume->voxelSide == SideOfMeans(volume->site, grid, options);
    if (!hasMeans && find(volume) == remade.end())
    {
      missing.push_back({volume, nullptr});
    }
  }
  RunEach(loop, missing.size(),
    [&](std::size_t i)
    {
      auto made = std::make_shared<BeamVolume>(*missing[i].source.lock());
      MakeMeans(grid, options, *made);
      missing[i].volume = std::move(made);
    });
  remade.insert(remade.end(), missing.begin(), missing.end());
  BeamVolumes ready = volumes;
  for (std::shared_ptr<const BeamVolume>& volume : ready)
  {
    const auto found = find(volume);
    volume = found != remade.end() ? found->volume : volume;
  }
  return ready;
}

void BeamMerger::FindGeometries(const std::vector<Position>& positions, const RangeLoop& loop)
{
  std::vector<std::pair<Position, std::shared_ptr<const SiteGeometry>*>> missing;
  for (const Position& position : positions)
  {
    const auto [place, isNew] =
      geometries.try_emplace({position.latitude, position.longitude}, nullptr);
    if (isNew)
    {
      missing.emplace_back(position, &place->second);
    }
  }
  RunEach(loop, missing.size(),
    [&](std::size_t i)
    {
      *missing[i].second = std::make_shared<const SiteGeometry>(
        grid, missing[i].first, SiteGeometry::FarthestGate, options.beam, block);
    });
}

const SiteGeometry& BeamMerger::GeometryOf(const Position& position) const
{
  return *geometries.at({position.latitude, position.longitude});
}

std::optional<MergeSite> BeamMerger::MakeSite(int number,
  const std::vector<const BeamVolume*>& volumes, Time time, const MotionField* motion) const
{
  const std::vector<BeamTilt> tilts = FindTilts(volumes, time, options.maximumGap);
  if (tilts.empty())
  {
    return std::nullopt;
  }
  const double radius = options.beam.EffectiveRadius();
  const BeamVolume& any = *volumes.front();
  const Position& position = *any.site.position;
  const bool byDistance = StrategyFor(any.moment, options.strategy) == OverlapStrategy::Distance;
  const double reach = std::min(SiteGeometry::FarthestGate,
    LargestOf(volumes, [](const BeamSweep& sweep) { return sweep.Reach(); }));
  MergeSite site{number, position, volumes,
    SiteLevels(grid, position.altitude, radius, byDistance ? options.overlapLength : 0.0), tilts,
    {}, ContextFor(any, options, radius), HalfTangentAt(reach, radius)};
  const double beamWidth = options.beamWidth.value_or(BeamWidthOf(any.site));
  std::vector<float> elevations;
  for (const BeamTilt& tilt : site.tilts)
  {
    elevations.push_back(tilt.elevation);
    site.quiet.push_back(FindQuiet(tilt, site.context));
  }
  site.edges = FindEdges(elevations, beamWidth);
  FindQuietZones(options.overlapLength, byDistance, site);
  if (options.trend && any.moment == MomentName::REF && !options.linearReflectivity)
  {
    site.layers = SiteLayers(volumes, site.tilts, time);
  }
  const VoxelBlock about = SiteGeometry::ColumnsAbout(grid, position, reach);
  FindEcho(radius, motion != nullptr ? motion->FastestSpeedIn(about) : 0.0, site);
  site.north = NorthIn(grid, position);
  return site;
}

// Of `before`, sites with the same volumes are taken; their numbers are asked for ancillary arrays.
void BeamMerger::FindSites(BeamMergePlan& plan, const BeamMergePlan* before) const
{
  int number = -1;
  for (const auto& group : GroupBySite(plan.volumes))
  {
    ++number;
    const std::vector<const BeamVolume*>& volumes = group.second;
    const auto isSame = [&](const std::shared_ptr<const MergeSite>& site)
    { return site->volumes == volumes && (site->number == number || !options.ancillary); };
    if (before != nullptr)
    {
      const auto same = std::find_if(before->sites.begin(), before->sites.end(), isSame);
      if (same != before->sites.end())
      {
        plan.sites.push_back(*same);
        continue;
      }
    }
    if (std::optional<MergeSite> site = this->MakeSite(number, volumes, plan.time, plan.motion))
    {
      plan.sites.push_back(std::make_shared<const MergeSite>(std::move(*site)));
    }
  }
}

GriddedVolume BeamMerger::Describe(const BeamMergePlan& plan) const
{
  GriddedVolume volume;
  volume.grid = grid;
  volume.time = plan.time;
  volume.method = "beam";
  EchoGates echo;
  for (const std::shared_ptr<const BeamVolume>& each : plan.volumes)
  {
    volume.moment = each->moment;
    volume.synthetic = volume.synthetic || each->synthetic;
    volume.sharpened = IsSharpened(each->moment, options);
    echo.all += each->echo.all;
    echo.biological += each->echo.biological;
  }
  volume.biologicalShare =
    static_cast<float>(echo.biological) / static_cast<float>(std::max<std::size_t>(echo.all, 1));
  for (const auto& group : GroupBySite(plan.volumes))
  {
    const Site& site = group.second.front()->site;
    AddNote(group.second, volume.notes);
    volume.sites.push_back(site.name);
    volume.sitePositions.push_back(site.position.value());
  }
  return volume;
}

void BeamMerger::MakeRoom(const RowOptions& rows, GriddedVolume& volume) const
{
  const std::size_t count = volume.grid.VoxelCount();
  // What used memory holds stays: the merge sets every value.
  volume.values.resize(rows.code ? 0 : count);
  volume.states.resize(rows.code ? 0 : count);
  volume.codes.resize(rows.code ? count : 0);
  if (options.ancillary)
  {
    ForEachAncillaryArray(
      volume.ancillary, [count](const char*, auto& values) { values.resize(count); });
  }
}

std::optional<GriddedVolume> BeamMerger::Merge(const BeamVolumes& volumes, Time time,
  const MotionField* motion, const RangeLoop& loop, const Progress& progress, GriddedVolume memory)
{
  BeamMergePlan plan = this->Plan(volumes, time, motion, loop);
  return this->Merge(plan, loop, progress, std::move(memory));
}

BeamMergePlan BeamMerger::Plan(
  const BeamVolumes& volumes, Time time, const MotionField* motion, const RangeLoop& loop)
{
  if (motion != nullptr && !motion->Covers(grid))
  {
    throw Error("the motion must be that of the grid of the merge, or constant");
  }
  const bool moves = motion != nullptr && motion->FastestSpeed() > 0.0;
  BeamMergePlan plan{this->WithMeans(volumes, loop), time, moves ? motion : nullptr, {}, {}};
  this->FindSites(plan, nullptr);
  return plan;
}

BeamMergePlan BeamMerger::PlanAgain(
  const BeamMergePlan& before, const BeamVolumes& volumes, const RangeLoop& loop)
{
  BeamMergePlan plan{this->WithMeans(volumes, loop), before.time, before.motion, {}, before.echoes};
  this->FindSites(plan, &before);
  return plan;
}

RowOptions BeamMerger::RowsFor(BeamMergePlan& plan, MomentName moment, const VoxelBlock& part) const
{
  RowOptions rows;
  rows.block = part;
  rows.levels = grid.dimensions[2];
  rows.strategy = StrategyFor(moment, options.strategy);
  rows.overlapLength = static_cast<float>(options.overlapLength);
  rows.fillColumns = options.fillColumns;
  rows.trend = options.trend;
  rows.motion = plan.motion;
  rows.echoes = plan.echoes.empty() ? nullptr : plan.echoes.data();
  rows.width = grid.dimensions[0];
  if (HasCodes(options, moment))
  {
    rows.code = MomentCode::Widest(moment);
  }
  return rows;
}

std::optional<GriddedVolume> BeamMerger::Merge(
  BeamMergePlan& plan, const RangeLoop& loop, const Progress& progress, GriddedVolume memory)
{
  std::vector<Position> positions;
  for (const std::shared_ptr<const BeamVolume>& volume : plan.volumes)
  {
    positions.push_back(*volume->site.position);
  }
  this->FindGeometries(positions, loop);
  std::vector<SiteOnBlock> sites;
  for (const std::shared_ptr<const MergeSite>& site : plan.sites)
  {
    sites.push_back({site.get(), &this->GeometryOf(site->position)});
  }
  GriddedVolume volume = this->Describe(plan);
  volume.grid = PartOf(grid, block);
  volume.values = std::move(memory.values);
  volume.codes = std::move(memory.codes);
  volume.states = std::move(memory.states);
  volume.ancillary = std::move(memory.ancillary);
  const RowOptions rows = this->RowsFor(plan, volume.moment, block);
  this->MakeRoom(rows, volume);
  const int height = block.Size(1);
  std::mutex adding;
  for (int band = 0; band < height; band += bandHeight)
  {
    if (progress && !progress(static_cast<double>(band) / height))
    {
      return std::nullopt;
    }
    const int bandEnd = std::min(band + bandHeight, height);
    RunLoop(loop, (bandEnd - band + rowsTogether - 1) / rowsTogether,
      [&](int begin, int end)
      {
        const int first = band + begin * rowsTogether;
        const int last = std::min(band + end * rowsTogether, bandEnd);
        const std::vector<StateRun> runs =
          MergeRows(sites, rows, block.begin[1] + first, block.begin[1] + last, volume);
        const std::lock_guard<std::mutex> lock(adding);
        volume.statesBesideCodes.insert(volume.statesBesideCodes.end(), runs.begin(), runs.end());
      });
  }
  std::sort(volume.statesBesideCodes.begin(), volume.statesBesideCodes.end(),
    [](const StateRun& a, const StateRun& b) { return a.first < b.first; });
  if (progress && !progress(1.0))
  {
    return std::nullopt;
  }
  return volume;
}

namespace
{

// Finds the radars that reach a tile, with their geometry on it, which lives as long as this.
class SitesOnTile
{
public:
  SitesOnTile(const GridSpecification& theGrid, const BeamModel& theBeam, const VoxelBlock& theTile)
    : grid(theGrid)
    , beam(theBeam)
    , tile(theTile)
  {
  }

  void Add(const MergeSite& site, std::vector<SiteOnBlock>& to)
  {
    const std::array<double, 2> place = {site.position.latitude, site.position.longitude};
    const auto geometry =
      geometries.try_emplace(place, grid, site.position, SiteGeometry::FarthestGate, beam, tile)
        .first;
    if (geometry->second.Nearest() <= site.reach)
    {
      to.push_back({&site, &geometry->second});
    }
  }

private:
  const GridSpecification& grid;
  const BeamModel& beam;
  const VoxelBlock& tile;
  std::map<std::array<double, 2>, SiteGeometry> geometries; // by latitude and longitude
};

using Sites = std::vector<std::shared_ptr<const MergeSite>>;

// The sites of a plan that another one does not have.
std::vector<const MergeSite*> SitesOfOne(const Sites& sites, const Sites& others)
{
  std::vector<const MergeSite*> own;
  for (const std::shared_ptr<const MergeSite>& site : sites)
  {
    if (std::find(others.begin(), others.end(), site) == others.end())
    {
      own.push_back(site.get());
    }
  }
  return own;
}

} // namespace

std::vector<VoxelBlock> BeamMerger::FindTiles(
  const BeamMergePlan& before, const BeamMergePlan& after, int size) const
{
  std::set<std::array<int, 2>> places; // y, x
  for (const auto& sites :
    {SitesOfOne(before.sites, after.sites), SitesOfOne(after.sites, before.sites)})
  {
    for (const MergeSite* site : sites)
    {
      const double reach = 2.0 * options.beam.EffectiveRadius() * std::atan(site->reach);
      const VoxelBlock box = SiteGeometry::ColumnsAbout(grid, site->position, reach);
      for (int y = box.begin[1] / size; y * size < box.end[1]; ++y)
      {
        for (int x = box.begin[0] / size; x * size < box.end[0]; ++x)
        {
          places.insert({y, x});
        }
      }
    }
  }
  std::vector<VoxelBlock> tiles;
  for (const auto& [y, x] : places)
  {
    VoxelBlock tile = VoxelBlock::Of(grid);
    tile.begin = {x * size, y * size, 0};
    tile.end[0] = std::min(tile.begin[0] + size, grid.dimensions[0]);
    tile.end[1] = std::min(tile.begin[1] + size, grid.dimensions[1]);
    tiles.push_back(tile);
  }
  return tiles;
}

std::vector<std::uint8_t> BeamMerger::FindChanges(
  const BeamMergePlan& before, BeamMergePlan& after, const VoxelBlock& tile) const
{
  SitesOnTile onTile(grid, options.beam, tile);
  std::vector<SiteOnBlock> sites;
  std::vector<SiteOnBlock> others;
  for (const MergeSite* site : SitesOfOne(before.sites, after.sites))
  {
    onTile.Add(*site, sites);
  }
  for (const MergeSite* site : SitesOfOne(after.sites, before.sites))
  {
    onTile.Add(*site, others);
  }
  const MomentName moment = after.volumes.empty() ? MomentName::REF : after.volumes.front()->moment;
  return FindDifferences(sites, others, this->RowsFor(after, moment, tile), options.ancillary);
}

GriddedVolume BeamMerger::MergeColumnsOf(
  BeamMergePlan& plan, const VoxelBlock& tile, const std::vector<std::uint8_t>& wanted) const
{
  SitesOnTile onTile(grid, options.beam, tile);
  std::vector<SiteOnBlock> sites;
  for (const std::shared_ptr<const MergeSite>& site : plan.sites)
  {
    onTile.Add(*site, sites);
  }
  GriddedVolume volume = this->Describe(plan);
  volume.grid = PartOf(grid, tile);
  RowOptions rows = this->RowsFor(plan, volume.moment, tile);
  rows.code.reset(); // tiles become bricks, whose coarser levels are made of values
  volume.values.assign(tile.VoxelCount(), volume.fill);
  volume.states.assign(tile.VoxelCount(), VoxelState::NotScanned);
  this->MakeRoom(rows, volume);
  MergeColumns(sites, rows, wanted, volume);
  return volume;
}

} // namespace nexrad
