// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Thesis/ThesisMerge.h"

#include "nexrad/Polar/SweepPairing.h"
#include "nexrad/System/Error.h"
#include "nexrad/Thesis/ThesisGeometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace nexrad
{

namespace
{

constexpr float smallest = 0.0F;                                     // dBZ (T5)
constexpr float largest = 80.0F;                                     // dBZ (T5)
constexpr float uncounted = std::numeric_limits<float>::quiet_NaN(); // a gate that tells nothing
constexpr double beamWidth = 0.95;                                   // degrees (B4)

// A ray with its codes read.
class RayGates
{
public:
  void Read(const PolarSweep& theSweep, std::size_t ray)
  {
    sweep = &theSweep;
    codes.resize(sweep->gates);
    sweep->Read(ray, codes.data());
  }
  void Clear() { sweep = nullptr; }

  // T5: the value with which a gate enters the mean.
  float At(std::size_t gate) const
  {
    const std::uint16_t code = codes[gate];
    return code >= GateCode::FirstValue ? std::clamp(sweep->scale.ValueOf(code), smallest, largest)
           : code == GateCode::NoEcho   ? smallest
                                        : uncounted;
  }

  // Of the gate at a slant range, m.
  float Nearest(double slantRange) const
  {
    if (sweep == nullptr)
    {
      return uncounted;
    }
    const double gate = std::round((slantRange - sweep->firstGate) / sweep->gateSpacing);
    const bool inside = gate >= 0.0 && gate < static_cast<double>(sweep->gates);
    return inside ? this->At(static_cast<std::size_t>(gate)) : uncounted;
  }

private:
  const PolarSweep* sweep = nullptr; // nullptr: no ray
  std::vector<std::uint16_t> codes;
};

// T4 for one sample, when either side may tell nothing.
float Blend(float before, float after, float share)
{
  if (std::isnan(after))
  {
    return before;
  }
  return std::isnan(before) ? after : (1.0F - share) * before + share * after;
}

// s of T4, from the nominal times of the volumes.
float ShareOfAfter(const SiteBracket& site, Time time)
{
  if (site.before == nullptr || site.after == nullptr || site.after->start <= site.before->start)
  {
    return site.before == nullptr ? 1.0F : 0.0F;
  }
  const double share = ToSeconds(time) - ToSeconds(site.before->start);
  const double whole = ToSeconds(site.after->start) - ToSeconds(site.before->start);
  return static_cast<float>(std::clamp(share / whole, 0.0, 1.0));
}

// Sums and counts of the samples in each voxel (T6).
class Accumulator
{
public:
  explicit Accumulator(std::size_t voxels)
    : sums(voxels, 0.0)
    , counts(voxels, 0)
  {
  }

  void Add(std::ptrdiff_t voxel, double sum, std::uint32_t count)
  {
    sums[static_cast<std::size_t>(voxel)] += sum;
    counts[static_cast<std::size_t>(voxel)] += count;
  }

  // NaN where no sample fell.
  std::vector<float> Means() const
  {
    std::vector<float> means(sums.size());
    for (std::size_t i = 0; i < means.size(); ++i)
    {
      means[i] = counts[i] == 0 ? uncounted : static_cast<float>(sums[i] / counts[i]);
    }
    return means;
  }

private:
  std::vector<double> sums;
  std::vector<std::uint32_t> counts;
};

// Drops the samples of one sweep into the voxels.
class SweepDropper
{
public:
  SweepDropper(const Position& site, const ThesisCells& grid, Accumulator& target)
    : position(site)
    , cells(grid)
    , accumulator(target)
  {
  }

  void Drop(const PolarSweep& sweep, const PolarSweep* partner, float share) const
  {
    const bool paired = partner != nullptr && partner->gateSpacing > 0.0;
    const RayFinder finder(paired ? *partner : PolarSweep{});
    RayGates own;
    RayGates after; // the partner's, as seen from the gates of the own ray
    for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
    {
      own.Read(sweep, ray);
      after.Clear();
      if (const auto found =
            finder.Nearest(static_cast<double>(sweep.rays[ray].azimuth), beamWidth))
      {
        after.Read(*partner, *found);
      }
      this->DropRay(sweep, sweep.rays[ray], own, after, share);
    }
  }

private:
  void DropRay(const PolarSweep& sweep, const PolarRay& direction, const RayGates& own,
    const RayGates& after, float share) const
  {
    const ThesisRay geometry(static_cast<double>(direction.azimuth),
      static_cast<double>(direction.elevation), position.altitude);
    // Neighbouring gates mostly fall into the same voxel: they are summed and handed on together.
    std::ptrdiff_t voxel = -1;
    double sum = 0.0;
    std::uint32_t count = 0;
    const auto handOn = [&]
    {
      if (voxel >= 0)
      {
        accumulator.Add(voxel, sum, count);
      }
      sum = 0.0;
      count = 0;
    };
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const double slantRange = sweep.firstGate + static_cast<double>(gate) * sweep.gateSpacing;
      const float value = Blend(own.At(gate), after.Nearest(slantRange), share);
      // A gate before the antenna is an artefact of the receiver's delay.
      if (slantRange >= 0.0 && !std::isnan(value))
      {
        const std::ptrdiff_t where = cells.Find(geometry.Locate(slantRange));
        if (where != voxel)
        {
          handOn();
          voxel = where;
        }
        sum += static_cast<double>(value);
        ++count;
      }
    }
    handOn();
  }

  const Position& position;
  const ThesisCells& cells;
  Accumulator& accumulator;
};

// What is to be dropped: a sweep, and the sweep that it is blended with.
struct SweepTask
{
  const PolarSweep* sweep;
  const PolarSweep* partner; // nullptr: as it is
};

// Sweeps of one side alone (after a change of the coverage pattern, or from a file cut short) go
// in unchanged, as a volume without a partner does.
std::vector<SweepTask> SweepsOf(const SiteBracket& site)
{
  std::vector<SweepTask> tasks;
  if (site.before == nullptr || site.after == nullptr)
  {
    for (const PolarSweep& sweep : site.Any().sweeps)
    {
      tasks.push_back({&sweep, nullptr});
    }
    return tasks;
  }
  const auto pairs = PairSweeps(*site.before, *site.after);
  std::vector<bool> used(site.after->sweeps.size(), false);
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    tasks.push_back({&site.before->sweeps[i], pairs[i] ? &site.after->sweeps[*pairs[i]] : nullptr});
    if (pairs[i])
    {
      used[*pairs[i]] = true;
    }
  }
  for (std::size_t j = 0; j < used.size(); ++j)
  {
    if (!used[j])
    {
      tasks.push_back({&site.after->sweeps[j], nullptr});
    }
  }
  return tasks;
}

double FarthestGate(const std::vector<SweepTask>& tasks)
{
  double farthest = 0.0;
  for (const SweepTask& task : tasks)
  {
    farthest = std::max(farthest,
      task.sweep->firstGate + static_cast<double>(task.sweep->gates) * task.sweep->gateSpacing);
  }
  return farthest;
}

GriddedVolume EmptyVolume(const std::vector<SiteBracket>& sites, const GridSpecification& grid)
{
  GriddedVolume volume;
  volume.grid = grid;
  volume.method = "thesis";
  volume.fill = smallest;
  for (const SiteBracket& site : sites)
  {
    for (const PolarVolume* side : {site.before, site.after})
    {
      volume.synthetic = volume.synthetic || (side != nullptr && side->synthetic);
    }
    const PolarVolume& any = site.Any();
    volume.sites.push_back(any.site.name);
    volume.sitePositions.push_back(any.site.position.value());
    volume.moment = any.moment;
  }
  return volume;
}

// From NaN for "unknown" to a state and the fill value.
void SetStates(GriddedVolume& volume)
{
  volume.states.resize(volume.values.size());
  for (std::size_t i = 0; i < volume.values.size(); ++i)
  {
    float& value = volume.values[i];
    volume.states[i] = std::isnan(value)  ? VoxelState::NotScanned
                       : value > smallest ? VoxelState::Echo
                                          : VoxelState::NoEcho;
    value = volume.states[i] == VoxelState::Echo ? value : volume.fill;
  }
}

// T1 to T6: the mean of all samples in each voxel of a block, NaN without one; empty when asked to
// stop.
std::optional<std::vector<float>> MeansOfSites(const std::vector<SiteBracket>& sites,
  const GridSpecification& grid, const VoxelBlock& block, Time time, const Progress& progress)
{
  constexpr double shareOfWork = 0.9; // the rest is the fill's
  Accumulator accumulator(block.VoxelCount());
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    const Position& position = *sites[i].Any().site.position;
    const std::vector<SweepTask> tasks = SweepsOf(sites[i]);
    const ThesisCells cells(grid, position, FarthestGate(tasks), block);
    const SweepDropper dropper(position, cells, accumulator);
    const float share = ShareOfAfter(sites[i], time);
    for (std::size_t j = 0; j < tasks.size(); ++j)
    {
      const double part = static_cast<double>(j) / static_cast<double>(tasks.size());
      const double done = (static_cast<double>(i) + part) / static_cast<double>(sites.size());
      if (progress && !progress(shareOfWork * done))
      {
        return std::nullopt;
      }
      dropper.Drop(*tasks[j].sweep, tasks[j].partner, share);
    }
  }
  return accumulator.Means();
}

} // namespace

void FillColumns(std::vector<float>& values, const std::array<int, 3>& dimensions)
{
  const auto columns =
    static_cast<std::size_t>(dimensions[0]) * static_cast<std::size_t>(dimensions[1]);
  const auto levels = static_cast<std::size_t>(dimensions[2]);
  for (std::size_t column = 0; column < columns; ++column)
  {
    const auto at = [&](std::size_t level) -> float& { return values[level * columns + column]; };
    std::size_t next = 0; // lowest level not yet dealt with
    for (std::size_t level = 0; level < levels; ++level)
    {
      const float value = at(level);
      if (std::isnan(value))
      {
        continue;
      }
      const bool lowest = next == 0;
      const float below = lowest ? value : at(next - 1);
      const auto gap = static_cast<float>(level - next + 1);
      for (std::size_t empty = next; empty < level; ++empty)
      {
        const float part = static_cast<float>(empty - next + 1) / gap;
        at(empty) = lowest ? value : below + part * (value - below);
      }
      next = level + 1;
    }
  }
}

std::optional<GriddedVolume> MergeThesis(const std::vector<SiteBracket>& sites,
  const GridSpecification& grid, Time time, const Progress& progress,
  const std::optional<VoxelBlock>& block)
{
  if (grid.VoxelCount() == 0)
  {
    throw Error("the grid has no voxels: each dimension must be 1 or more");
  }
  const VoxelBlock part = block.value_or(VoxelBlock::Of(grid));
  GriddedVolume volume = EmptyVolume(sites, PartOf(grid, part));
  // The fill looks along whole columns.
  VoxelBlock columns = part;
  columns.begin[2] = 0;
  columns.end[2] = grid.dimensions[2];
  auto means = MeansOfSites(sites, grid, columns, time, progress);
  if (!means)
  {
    return std::nullopt;
  }
  const auto plane =
    static_cast<std::size_t>(columns.Size(0)) * static_cast<std::size_t>(columns.Size(1));
  FillColumns(*means, PartOf(grid, columns).dimensions);
  const auto levelAt = [&](int level)
  { return means->begin() + static_cast<std::ptrdiff_t>(plane) * level; };
  means->erase(levelAt(part.end[2]), means->end());
  means->erase(means->begin(), levelAt(part.begin[2]));
  volume.time = time;
  volume.values = std::move(*means);
  SetStates(volume);
  if (progress && !progress(1.0))
  {
    return std::nullopt;
  }
  return volume;
}

} // namespace nexrad
