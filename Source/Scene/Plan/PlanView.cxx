// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Plan/PlanView.h"

#include "nexrad/Products/ColumnProducts.h"
#include "nexrad/System/Error.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace nexrad::scene
{
namespace
{

std::string Kilometres(double metres)
{
  std::ostringstream stream;
  stream << std::round(metres / 10.0) / 100.0 << " km";
  return stream.str();
}

// The level whose voxels hold a height.
int LevelAt(const GridSpecification& grid, double height)
{
  const double bottom = grid.origin[2] - 0.5 * grid.spacing[2];
  const double top = bottom + grid.spacing[2] * grid.dimensions[2];
  if (!(height >= bottom && height <= top))
  {
    throw Error("plan view at " + Kilometres(height) + ": the volume reaches from " +
                Kilometres(bottom) + " to " + Kilometres(top) + " above mean sea level");
  }
  const int level = static_cast<int>((height - bottom) / grid.spacing[2]);
  return std::min(level, grid.dimensions[2] - 1);
}

// Walks up the columns of a volume.
class ColumnWalk
{
public:
  explicit ColumnWalk(const GriddedVolume& theVolume)
    : volume(theVolume)
    , columns(static_cast<std::size_t>(volume.grid.dimensions[0]) *
              static_cast<std::size_t>(volume.grid.dimensions[1]))
    , levels(static_cast<std::size_t>(volume.grid.dimensions[2]))
  {
  }

  std::size_t Columns() const { return columns; }

  // Index of the voxel of a column that is shown.
  std::size_t Shown(std::size_t column, PlanLevel level, int heightLevel) const
  {
    switch (level)
    {
    case PlanLevel::Composite:
      return this->Largest(column);
    case PlanLevel::Lowest:
      return this->Lowest(column);
    default:
      return column + static_cast<std::size_t>(heightLevel) * columns;
    }
  }

private:
  // The lowest that was scanned; without one the lowest that is range folded.
  std::size_t Lowest(std::size_t column) const
  {
    std::size_t folded = column;
    for (std::size_t level = 0; level < levels; ++level)
    {
      const std::size_t voxel = column + level * columns;
      const VoxelState state = volume.states[voxel];
      if (state == VoxelState::Echo || state == VoxelState::NoEcho)
      {
        return voxel;
      }
      const bool first = volume.states[folded] != VoxelState::RangeFolded;
      folded = first && state == VoxelState::RangeFolded ? voxel : folded;
    }
    return folded;
  }

  // What a composite looks for: the strongest, of velocities the fastest either way.
  float Strength(std::size_t voxel) const
  {
    const float value = volume.values[voxel];
    return volume.moment == MomentName::VEL ? std::abs(value) : value;
  }

  // The strongest echo; without one the lowest.
  std::size_t Largest(std::size_t column) const
  {
    std::size_t best = this->Lowest(column);
    for (std::size_t voxel = column; voxel < columns * levels; voxel += columns)
    {
      const bool larger =
        volume.states[best] != VoxelState::Echo || this->Strength(voxel) > this->Strength(best);
      best = volume.states[voxel] == VoxelState::Echo && larger ? voxel : best;
    }
    return best;
  }

  const GriddedVolume& volume;
  std::size_t columns;
  std::size_t levels;
};

// The phase grows with range, and the correlation is near 1 in some voxel of nearly every column.
void CheckComposite(MomentName moment)
{
  if (moment == MomentName::PHI || moment == MomentName::RHO)
  {
    throw Error("composite: the largest " + std::string(ToString(moment)) +
                " of a column has no meaning; choose the lowest voxels, or those at a height");
  }
}

std::string WhereText(const GriddedVolume& volume, const PlanOptions& plan, int level)
{
  const GridSpecification& grid = volume.grid;
  switch (plan.level)
  {
  case PlanLevel::Composite:
    return volume.moment == MomentName::VEL ? "Composite: where the column's speed is largest"
                                            : "Composite: where the column's value is largest";
  case PlanLevel::Lowest:
    return "At the lowest voxel of each column that was scanned";
  default:
    return "At " + Kilometres(grid.Coordinate(2, level)) + " above mean sea level";
  }
}

[[noreturn]] void RefuseArray(const GriddedVolume& volume, const std::string& name)
{
  std::string has = ToString(volume.moment);
  const auto add = [&](const char* end, const auto& values)
  { has += values.empty() ? "" : ", " + AncillaryArrayName(volume.moment, end); };
  ForEachAncillaryArray(volume.ancillary, add);
  throw Error("the volume has no array " + name + "; it has " + has +
              " (merge with ancillary arrays for more)");
}

// Whether some radar scanned the voxel; column filling also gives values to others.
VoxelState StateOfAncillaryArray(const GriddedVolume& volume, std::size_t voxel)
{
  const VoxelState state = volume.states[voxel];
  const auto& radars = volume.ancillary.radars;
  const auto& sites = volume.ancillary.nearestSite;
  const bool unseen = (!radars.empty() && radars[voxel] == 0) ||
                      (!sites.empty() && sites[voxel] == AncillaryArrays::NoSite);
  return state == VoxelState::RangeFolded            ? state
         : unseen || state == VoxelState::NotScanned ? VoxelState::NotScanned
                                                     : VoxelState::Echo;
}

// The values that are asked for, of each voxel.
std::vector<float> ValuesOf(
  const GriddedVolume& volume, const std::string& name, const std::vector<std::size_t>& voxels)
{
  std::vector<float> taken;
  const auto take = [&](const auto& values)
  {
    for (const std::size_t voxel : voxels)
    {
      taken.push_back(static_cast<float>(values[voxel]));
    }
  };
  if (name.empty() || name == ToString(volume.moment))
  {
    take(volume.values);
    return taken;
  }
  const auto takeNamed = [&](const char* end, const auto& values)
  {
    if (!values.empty() && name == AncillaryArrayName(volume.moment, end))
    {
      take(values);
    }
  };
  ForEachAncillaryArray(volume.ancillary, takeNamed);
  if (taken.empty())
  {
    RefuseArray(volume, name);
  }
  return taken;
}

bool IsProduct(PlanLevel level)
{
  return level == PlanLevel::EchoTop || level == PlanLevel::Liquid;
}

PlanView MakeProductView(const GriddedVolume& volume, const PlanOptions& plan)
{
  if (!plan.array.empty() && plan.array != ToString(volume.moment))
  {
    throw Error("echo tops and liquid are computed of REF, not of " + plan.array);
  }
  const bool top = plan.level == PlanLevel::EchoTop;
  ColumnProduct product = top ? MakeEchoTops(volume, plan.threshold) : MakeIntegratedLiquid(volume);
  PlanView view;
  view.width = product.width;
  view.height = product.height;
  view.values = std::move(product.values);
  view.states = std::move(product.states);
  std::ostringstream where;
  where << "Highest place of each column with " << plan.threshold
        << " dBZ, in km above mean sea level";
  view.where = top ? where.str() : "Of all voxels of each column; above 56 dBZ as 56 dBZ";
  return view;
}

} // namespace

PlanView MakePlanView(const GriddedVolume& volume, const PlanOptions& plan)
{
  if (IsProduct(plan.level))
  {
    return MakeProductView(volume, plan);
  }
  if (plan.level == PlanLevel::Composite)
  {
    CheckComposite(volume.moment);
  }
  const int level = plan.level == PlanLevel::Height ? LevelAt(volume.grid, plan.height) : 0;
  const ColumnWalk walk(volume);
  std::vector<std::size_t> voxels;
  for (std::size_t column = 0; column < walk.Columns(); ++column)
  {
    voxels.push_back(walk.Shown(column, plan.level, level));
  }
  PlanView view;
  view.width = volume.grid.dimensions[0];
  view.height = volume.grid.dimensions[1];
  view.values = ValuesOf(volume, plan.array, voxels);
  const bool moment = plan.array.empty() || plan.array == ToString(volume.moment);
  for (const std::size_t voxel : voxels)
  {
    view.states.push_back(moment ? volume.states[voxel] : StateOfAncillaryArray(volume, voxel));
  }
  view.where = WhereText(volume, plan, level);
  return view;
}

} // namespace nexrad::scene
