// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Products/ColumnProducts.h"

#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace nexrad
{
namespace
{

// Seeks the highest level that reaches a threshold in one column, from its lowest level up.
class EchoTop
{
public:
  explicit EchoTop(const VoxelLines& voxels, double wantedThreshold)
    : bottom(voxels.grid.Coordinate(2, 0))
    , depth(voxels.grid.spacing[2])
    , threshold(wantedThreshold)
  {
  }

  struct Column
  {
    double top = 0.0;
    double value = 0.0; // of the level below, where that reached the threshold
    bool found = false;
    bool below = false;
  };

  void Add(int level, float voxel, bool echo, Column& column) const
  {
    const auto value = static_cast<double>(voxel);
    if (echo && value >= threshold)
    {
      column = {bottom + level * depth, value, true, true};
      return;
    }
    if (column.below && echo)
    {
      column.top += (column.value - threshold) / (column.value - value) * depth;
    }
    column.below = false;
  }

  std::optional<double> Of(const Column& column, std::size_t) const
  {
    return column.found ? std::optional(column.top) : std::nullopt;
  }

private:
  double bottom;
  double depth;
  double threshold;
};

// Adds up Z^(4/7) in one column.
class Liquid
{
public:
  explicit Liquid(const VoxelLines& voxels)
    : depth(voxels.grid.spacing[2])
  {
  }

  struct Column
  {
    double sum = 0.0;
    bool any = false;
  };

  void Add(int, float voxel, bool echo, Column& column) const
  {
    constexpr float hailCap = 56.0F; // dBZ
    constexpr float perDecibel = 2.302585092994046F / 10.0F * 4.0F / 7.0F;
    if (echo)
    {
      // 10^(dBZ/10) to the power of 4/7; in float, whose 7 digits are more than a value has
      column.sum += static_cast<double>(std::exp(perDecibel * std::min(voxel, hailCap)));
      column.any = true;
    }
  }

  std::optional<double> Of(const Column& column, std::size_t) const
  {
    constexpr double factor = 3.44e-6; // Greene and Clark 1972
    return column.any ? std::optional(factor * column.sum * depth) : std::nullopt;
  }

private:
  double depth;
};

// The liquid of one column, in g, through the height of its echo top above the ground.
class LiquidDensity
{
public:
  LiquidDensity(const VoxelLines& voxels, double threshold)
    : liquid(voxels)
    , top(voxels, threshold)
    , grid(voxels.grid)
    , ground(voxels.ground)
  {
  }

  struct Column
  {
    Liquid::Column liquid;
    EchoTop::Column top;
  };

  void Add(int level, float voxel, bool echo, Column& column) const
  {
    liquid.Add(level, voxel, echo, column.liquid);
    top.Add(level, voxel, echo, column.top);
  }

  std::optional<double> Of(const Column& column, std::size_t index) const
  {
    constexpr double gramsPerKilogram = 1000.0;
    const std::optional<double> highest = top.Of(column.top, index);
    const double height = highest ? *highest - ground.Below(grid, index) : 0.0;
    return height > 0.0
             ? std::optional(gramsPerKilogram * *liquid.Of(column.liquid, index) / height)
             : std::nullopt;
  }

private:
  Liquid liquid;
  EchoTop top;
  GridSpecification grid;
  GroundHeight ground;
};

// The state of a column whose product has no value, with one more voxel of it.
VoxelState StateOfNone(VoxelState column, VoxelState voxel)
{
  return column == VoxelState::NoEcho || IsMeasured(voxel) ? VoxelState::NoEcho
                                                           : MoreKnown(column, voxel);
}

template <class Formula>
ColumnProduct MakeProduct(
  const VoxelLines& voxels, const char* name, const Formula& formula, const RangeLoop& loop)
{
  if (voxels.moment != MomentName::REF)
  {
    throw Error(
      std::string(name) + ": is made of REF, and the volume has " + ToString(voxels.moment));
  }
  ColumnProduct product;
  product.width = voxels.grid.dimensions[0];
  product.height = voxels.grid.dimensions[1];
  const auto count =
    static_cast<std::size_t>(product.width) * static_cast<std::size_t>(product.height);
  std::vector<typename Formula::Column> columns(count);
  product.states.assign(count, VoxelState::NotScanned);
  const auto add = [&](const ColumnStretch& stretch)
  {
    for (std::size_t i = 0; i < stretch.count; ++i)
    {
      const std::size_t column = stretch.first + i;
      const VoxelState state = stretch.states[i];
      formula.Add(stretch.level, stretch.values[i], state == VoxelState::Echo, columns[column]);
      product.states[column] = StateOfNone(product.states[column], state);
    }
  };
  WalkColumns(voxels, 0, voxels.grid.dimensions[2], loop, add);
  product.values.resize(count);
  for (std::size_t column = 0; column < count; ++column)
  {
    const std::optional<double> value = formula.Of(columns[column], column);
    product.values[column] = static_cast<float>(value.value_or(0.0));
    product.states[column] = value ? VoxelState::Echo : product.states[column];
  }
  return product;
}

} // namespace

ColumnProduct MakeEchoTops(const VoxelLines& voxels, double threshold, const RangeLoop& loop)
{
  return MakeProduct(voxels, "echo top", EchoTop(voxels, threshold), loop);
}

ColumnProduct MakeIntegratedLiquid(const VoxelLines& voxels, const RangeLoop& loop)
{
  return MakeProduct(voxels, "vertically integrated liquid", Liquid(voxels), loop);
}

ColumnProduct MakeLiquidDensity(const VoxelLines& voxels, double threshold, const RangeLoop& loop)
{
  return MakeProduct(voxels, "VIL density", LiquidDensity(voxels, threshold), loop);
}

} // namespace nexrad
