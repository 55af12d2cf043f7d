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

// One column of a volume, by level.
class Column
{
public:
  Column(const GriddedVolume& theVolume, std::size_t place)
    : volume(theVolume)
    , first(place)
    , stride(static_cast<std::size_t>(volume.grid.dimensions[0]) *
             static_cast<std::size_t>(volume.grid.dimensions[1]))
  {
  }

  int Levels() const { return volume.grid.dimensions[2]; }
  VoxelState State(int level) const { return volume.states[this->Voxel(level)]; }
  bool HasEcho(int level) const { return this->State(level) == VoxelState::Echo; }
  double Value(int level) const { return static_cast<double>(volume.values[this->Voxel(level)]); }
  double Height(int level) const { return volume.grid.Coordinate(2, level); }
  double Depth() const { return volume.grid.spacing[2]; }

  // The state of a column whose product has no value.
  VoxelState StateOfNone() const
  {
    VoxelState found = VoxelState::NotScanned;
    for (int level = 0; level < this->Levels(); ++level)
    {
      const VoxelState state = this->State(level);
      if (state == VoxelState::Echo || state == VoxelState::NoEcho)
      {
        return VoxelState::NoEcho;
      }
      found = state == VoxelState::RangeFolded ? state : found;
    }
    return found;
  }

private:
  std::size_t Voxel(int level) const { return first + stride * static_cast<std::size_t>(level); }

  const GriddedVolume& volume;
  std::size_t first;
  std::size_t stride;
};

std::optional<double> EchoTopOf(const Column& column, double threshold)
{
  for (int level = column.Levels() - 1; level >= 0; --level)
  {
    if (!column.HasEcho(level) || column.Value(level) < threshold)
    {
      continue;
    }
    if (level + 1 == column.Levels() || !column.HasEcho(level + 1))
    {
      return column.Height(level);
    }
    const double above = column.Value(level + 1); // below the threshold, or the top were there
    const double share = (column.Value(level) - threshold) / (column.Value(level) - above);
    return column.Height(level) + share * column.Depth();
  }
  return std::nullopt;
}

std::optional<double> LiquidOf(const Column& column)
{
  constexpr double factor = 3.44e-6; // Greene and Clark 1972
  constexpr double hailCap = 56.0;   // dBZ
  constexpr double perDecibel = 2.302585092994046 / 10.0 * 4.0 / 7.0;
  double sum = 0.0;
  bool any = false;
  for (int level = 0; level < column.Levels(); ++level)
  {
    if (column.HasEcho(level))
    {
      // 10^(dBZ/10) to the power of 4/7
      sum += std::exp(perDecibel * std::min(column.Value(level), hailCap));
      any = true;
    }
  }
  return any ? std::optional(factor * sum * column.Depth()) : std::nullopt;
}

template <class Formula>
ColumnProduct MakeProduct(const GriddedVolume& volume, const char* name, const Formula& formula)
{
  if (volume.moment != MomentName::REF)
  {
    throw Error(
      std::string(name) + ": is made of REF, and the volume has " + ToString(volume.moment));
  }
  ColumnProduct product;
  product.width = volume.grid.dimensions[0];
  product.height = volume.grid.dimensions[1];
  const auto columns =
    static_cast<std::size_t>(product.width) * static_cast<std::size_t>(product.height);
  for (std::size_t place = 0; place < columns; ++place)
  {
    const Column column(volume, place);
    const std::optional<double> value = formula(column);
    product.values.push_back(static_cast<float>(value.value_or(0.0)));
    product.states.push_back(value ? VoxelState::Echo : column.StateOfNone());
  }
  return product;
}

} // namespace

ColumnProduct MakeEchoTops(const GriddedVolume& volume, double threshold)
{
  return MakeProduct(
    volume, "echo top", [threshold](const Column& column) { return EchoTopOf(column, threshold); });
}

ColumnProduct MakeIntegratedLiquid(const GriddedVolume& volume)
{
  return MakeProduct(volume, "vertically integrated liquid", LiquidOf);
}

} // namespace nexrad
