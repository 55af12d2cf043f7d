// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeInterpolation.h"

#include "VolumePair.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace nexrad
{

namespace
{

// What a place in a volume tells.
enum class Told
{
  Nothing,
  NoEcho,
  Echo
};

struct Observation
{
  Told told = Told::Nothing;
  float value = 0.0F; // dBZ; 0 without echo
};

// A blend in which an echo met no echo is one only above 0 dBZ (A1).
Observation EchoAgainstNone(float value)
{
  return value > 0.0F ? Observation{Told::Echo, value} : Observation{Told::NoEcho, 0.0F};
}

Observation ObserveVoxel(const GriddedVolume& volume, std::size_t voxel)
{
  switch (volume.states[voxel])
  {
  case VoxelState::Echo:
    return {Told::Echo, volume.values[voxel]};
  case VoxelState::NoEcho:
    return {Told::NoEcho, 0.0F};
  default:
    return {};
  }
}

// A place between voxels of one layer: the same for all heights.
struct Footprint
{
  std::array<std::size_t, 4> pixel = {}; // in a layer
  std::array<float, 4> weight = {};      // 0 outside the grid
};

// Shares of the two voxels about a place on one axis; those outside the grid have none.
struct AxisFootprint
{
  std::array<std::size_t, 2> index = {};
  std::array<float, 2> weight = {};
};

AxisFootprint OnAxis(double place, int size)
{
  AxisFootprint axis;
  const double low = std::floor(place);
  const auto part = static_cast<float>(place - low);
  const std::array<float, 2> weights = {1.0F - part, part};
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    const double index = low + static_cast<double>(i);
    if (index >= 0.0 && index < size)
    {
      axis.index[i] = static_cast<std::size_t>(index);
      axis.weight[i] = weights[i];
    }
  }
  return axis;
}

Footprint FootprintAt(const std::array<int, 3>& dimensions, double column, double row)
{
  const AxisFootprint x = OnAxis(column, dimensions[0]);
  const AxisFootprint y = OnAxis(row, dimensions[1]);
  Footprint footprint;
  for (std::size_t i = 0; i < footprint.pixel.size(); ++i)
  {
    footprint.pixel[i] = y.index[i / 2] * static_cast<std::size_t>(dimensions[0]) + x.index[i % 2];
    footprint.weight[i] = y.weight[i / 2] * x.weight[i % 2];
  }
  return footprint;
}

Observation ObservePlace(
  const GriddedVolume& volume, const Footprint& footprint, std::size_t firstOfLayer)
{
  float sum = 0.0F;
  float echo = 0.0F;
  float none = 0.0F;
  for (std::size_t i = 0; i < footprint.pixel.size(); ++i)
  {
    const std::size_t voxel = firstOfLayer + footprint.pixel[i];
    switch (volume.states[voxel])
    {
    case VoxelState::Echo:
      sum += footprint.weight[i] * volume.values[voxel];
      echo += footprint.weight[i];
      break;
    case VoxelState::NoEcho:
      none += footprint.weight[i];
      break;
    default:
      break;
    }
  }
  const float telling = echo + none;
  if (telling < 0.5F)
  {
    return {};
  }
  if (echo > 0.0F)
  {
    return none > 0.0F ? EchoAgainstNone(sum / telling) : Observation{Told::Echo, sum / telling};
  }
  return {Told::NoEcho, 0.0F};
}

// A1 for two observations, of which either may tell nothing.
Observation Blend(const Observation& before, const Observation& after, float share)
{
  if (before.told == Told::Nothing || (share >= 1.0F && after.told != Told::Nothing))
  {
    return after;
  }
  if (after.told == Told::Nothing || share <= 0.0F)
  {
    return before;
  }
  if (before.told == Told::NoEcho && after.told == Told::NoEcho)
  {
    return before;
  }
  const float value = (1.0F - share) * before.value + share * after.value;
  return before.told == after.told ? Observation{Told::Echo, value} : EchoAgainstNone(value);
}

float ShareOfAfter(const GriddedVolume& before, const GriddedVolume& after, Time time)
{
  RequirePair(before, after);
  if (time < before.time || time > after.time)
  {
    throw Error("interpolation in time: " + FormatIso8601(time) + " must lie from " +
                FormatIso8601(before.time) + " to " + FormatIso8601(after.time));
  }
  const double part = ToSeconds(time) - ToSeconds(before.time);
  return static_cast<float>(part / (ToSeconds(after.time) - ToSeconds(before.time)));
}

void RequireMotion(const MotionField& motion, const GridSpecification& grid)
{
  if (!motion.Covers(grid))
  {
    throw Error("interpolation in time: the motion must be that of the volumes' own grid");
  }
}

void Store(const Observation& observation, std::size_t voxel, GriddedVolume& volume)
{
  const bool echo = observation.told == Told::Echo;
  volume.states[voxel] = echo ? VoxelState::Echo : VoxelState::NoEcho;
  volume.values[voxel] = echo ? observation.value : volume.fill;
}

// Rows of one interpolation. The places from which the echo of a column came and to which it goes
// are the same at all heights.
class RowFiller
{
public:
  RowFiller(const GriddedVolume& first, const GriddedVolume& second, float shareOfSecond,
    GriddedVolume& target)
    : before(first)
    , after(second)
    , share(shareOfSecond)
    , volume(target)
    , width(static_cast<std::size_t>(target.grid.dimensions[0]))
    , layer(width * static_cast<std::size_t>(target.grid.dimensions[1]))
  {
  }

  void Place(const MotionField& motion, int row)
  {
    const std::array<double, 2> extent = VoxelExtent(volume.grid, row);
    const double seconds = ToSeconds(after.time) - ToSeconds(before.time);
    const double part = static_cast<double>(share);
    sources.clear();
    targets.clear();
    for (int column = 0; column < volume.grid.dimensions[0]; ++column)
    {
      const Velocity velocity = motion.At(column, row);
      const double dx = velocity.east * seconds / extent[0];
      const double dy = velocity.north * seconds / extent[1];
      sources.push_back(FootprintAt(volume.grid.dimensions, column - part * dx, row - part * dy));
      targets.push_back(
        FootprintAt(volume.grid.dimensions, column + (1.0 - part) * dx, row + (1.0 - part) * dy));
    }
  }

  void Fill(int row) const
  {
    for (std::size_t firstOfLayer = 0; firstOfLayer < volume.values.size(); firstOfLayer += layer)
    {
      for (std::size_t column = 0; column < width; ++column)
      {
        this->FillVoxel(firstOfLayer, column, static_cast<std::size_t>(row) * width + column);
      }
    }
  }

private:
  void FillVoxel(std::size_t firstOfLayer, std::size_t column, std::size_t pixel) const
  {
    const std::size_t voxel = firstOfLayer + pixel;
    const Observation own = Blend(ObserveVoxel(before, voxel), ObserveVoxel(after, voxel), share);
    if (own.told == Told::Nothing)
    {
      const bool folded = before.states[voxel] == VoxelState::RangeFolded ||
                          after.states[voxel] == VoxelState::RangeFolded;
      volume.states[voxel] = folded ? VoxelState::RangeFolded : VoxelState::NotScanned;
      volume.values[voxel] = volume.fill;
      return;
    }
    if (sources.empty())
    {
      Store(own, voxel, volume);
      return;
    }
    const Observation source = ObservePlace(before, sources[column], firstOfLayer);
    const Observation target = ObservePlace(after, targets[column], firstOfLayer);
    const bool helpful = source.told != Told::Nothing && target.told != Told::Nothing;
    Store(helpful ? Blend(source, target, share) : own, voxel, volume);
  }

  const GriddedVolume& before;
  const GriddedVolume& after;
  const float share;
  GriddedVolume& volume;
  const std::size_t width;
  const std::size_t layer;
  std::vector<Footprint> sources; // in `before`; empty: linear
  std::vector<Footprint> targets; // in `after`
};

GriddedVolume Interpolate(const TimeInterpolation& interpolation)
{
  GriddedVolume volume = interpolation.MakeVolume();
  interpolation.FillRows(0, volume.grid.dimensions[1], volume);
  return volume;
}

} // namespace

TimeInterpolation::TimeInterpolation(
  const GriddedVolume& first, const GriddedVolume& second, Time between)
  : before(first)
  , after(second)
  , time(between)
  , motion(nullptr)
  , share(ShareOfAfter(first, second, between))
{
}

TimeInterpolation::TimeInterpolation(const GriddedVolume& first, const GriddedVolume& second,
  Time between, const MotionField& motionBetween)
  : before(first)
  , after(second)
  , time(between)
  , motion(&motionBetween)
  , share(ShareOfAfter(first, second, between))
{
  RequireMotion(motionBetween, first.grid);
}

GriddedVolume TimeInterpolation::MakeVolume() const
{
  GriddedVolume volume;
  volume.grid = before.grid;
  volume.time = time;
  volume.moment = before.moment;
  volume.method = before.method;
  volume.sites = before.sites;
  for (const std::string& site : after.sites)
  {
    if (std::find(volume.sites.begin(), volume.sites.end(), site) == volume.sites.end())
    {
      volume.sites.push_back(site);
    }
  }
  volume.synthetic = before.synthetic || after.synthetic;
  volume.fill = before.fill;
  volume.values.assign(before.values.size(), before.fill);
  volume.states.assign(before.states.size(), VoxelState::NotScanned);
  return volume;
}

void TimeInterpolation::FillRows(int begin, int end, GriddedVolume& volume) const
{
  RowFiller filler(before, after, share, volume);
  // At the time of a volume that volume is the answer, wherever it tells something.
  const bool moves = motion != nullptr && share > 0.0F && share < 1.0F;
  for (int row = begin; row < end; ++row)
  {
    if (moves)
    {
      filler.Place(*motion, row);
    }
    filler.Fill(row);
  }
}

GriddedVolume InterpolateLinear(const GriddedVolume& before, const GriddedVolume& after, Time time)
{
  return Interpolate(TimeInterpolation(before, after, time));
}

GriddedVolume InterpolateAlongMotion(
  const GriddedVolume& before, const GriddedVolume& after, Time time, const MotionField& motion)
{
  return Interpolate(TimeInterpolation(before, after, time, motion));
}

} // namespace nexrad
