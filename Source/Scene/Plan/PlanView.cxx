// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Plan/PlanView.h"

#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Shapes/Letters.h"
#include "nexrad/System/Error.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradVoxels.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace nexrad::scene
{
namespace
{

using ReadVoxels = decltype(VoxelLines::read);

ReadVoxels Read(const vtkNexradVoxels& voxels)
{
  return [voxels](std::size_t first, std::size_t count, float* values, VoxelState* states)
  {
    const vtkNexradVoxels copy = voxels; // which the bytes that are written cannot be
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] = copy.Value(first + i);
      states[i] = copy.State(first + i);
    }
  };
}

} // namespace

PlanSource SourceOf(vtkImageData* volume)
{
  const MomentName moment = vtkNexradScalarsMoment(volume);
  const std::string name = ToString(moment);
  vtkPointData* points = volume->GetPointData();
  const vtkIdType voxels = volume->GetNumberOfPoints();
  PlanSource source;
  const GridSpecification grid = vtkNexradImageToGrid(volume);
  const VolumeInformation information = ReadVolumeInformation(volume);
  source.voxels = {grid, moment, Read(vtkNexradVoxels::Require(volume, name)),
    GroundHeight(grid, information.sites, {})};
  source.age = vtkNexradFindValues<vtkFloatArray>(points, name + "_age", voxels);
  source.radars = vtkNexradFindValues<vtkUnsignedCharArray>(points, name + "_radars", voxels);
  source.weight = vtkNexradFindValues<vtkFloatArray>(points, name + "_weight", voxels);
  source.nearestSite = vtkNexradFindValues<vtkUnsignedCharArray>(points, name + "_site", voxels);
  source.sharpened = information.sharpened;
  return source;
}

namespace
{

std::string Kilometres(double metres)
{
  return NumberWord(std::round(metres / 10.0) / 100.0) + " km";
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

// The voxel of one column that a map shows, sought from its lowest level up.
struct ShownVoxel
{
  float value = 0.0F;
  int level = -1;
  VoxelState state = VoxelState::NotScanned;
  bool settled = false; // no voxel above is taken for having been scanned
};

// The lowest that was measured; without one the lowest that is range folded, else the lowest that
// is filtered, or the lowest of all.
struct LowestVoxel
{
  void operator()(const ShownVoxel& voxel, ShownVoxel& shown) const
  {
    if (shown.settled)
    {
      return;
    }
    const bool measured = IsMeasured(voxel.state);
    if (shown.level < 0 || measured || MoreKnown(shown.state, voxel.state) != shown.state)
    {
      shown = voxel;
      shown.settled = measured;
    }
  }
};

// The strongest echo, of moments of two signs the farthest from 0; without one the lowest voxel.
struct LargestVoxel
{
  bool twoSigns = false;

  float Strength(float value) const { return twoSigns ? std::abs(value) : value; }
  void operator()(const ShownVoxel& voxel, ShownVoxel& shown) const
  {
    if (voxel.state != VoxelState::Echo)
    {
      LowestVoxel()(voxel, shown);
    }
    else if (shown.state != VoxelState::Echo ||
             this->Strength(voxel.value) > this->Strength(shown.value))
    {
      shown = voxel;
      shown.settled = true;
    }
  }
};

std::size_t ColumnCount(const GridSpecification& grid)
{
  return static_cast<std::size_t>(grid.dimensions[0]) *
         static_cast<std::size_t>(grid.dimensions[1]);
}

// Of each column the voxel that `seek` finds among levels `first` to before `last`.
template <class Seek>
std::vector<ShownVoxel> FindAmong(
  const VoxelLines& voxels, int first, int last, const Seek& seek, const RangeLoop& loop)
{
  std::vector<ShownVoxel> shown(ColumnCount(voxels.grid));
  const auto visit = [&](const ColumnStretch& stretch)
  {
    ShownVoxel* found = shown.data() + stretch.first;
    for (std::size_t i = 0; i < stretch.count; ++i)
    {
      seek({stretch.values[i], stretch.level, stretch.states[i], false}, found[i]);
    }
  };
  WalkColumns(voxels, first, last, loop, visit);
  return shown;
}

// The voxel of each column that a map shows; `level`: of a map at a height.
std::vector<ShownVoxel> FindShown(
  const VoxelLines& voxels, PlanLevel kind, int level, const RangeLoop& loop)
{
  const int levels = voxels.grid.dimensions[2];
  if (kind == PlanLevel::Composite)
  {
    return FindAmong(voxels, 0, levels, LargestVoxel{HasTwoSigns(voxels.moment)}, loop);
  }
  return kind == PlanLevel::Height ? FindAmong(voxels, level, level + 1, LowestVoxel(), loop)
                                   : FindAmong(voxels, 0, levels, LowestVoxel(), loop);
}

// The phase grows with range, and the correlation is near 1 in some voxel of nearly every column.
void CheckComposite(MomentName moment)
{
  if (moment == MomentName::PHI || moment == MomentName::RHO)
  {
    throw Error("composite: the largest " + std::string(ToString(moment)) +
                " of a column has no meaning; choose the lowest voxels, or those at a height");
  }
}

std::string WhereText(const VoxelLines& volume, const PlanOptions& plan, int level)
{
  const GridSpecification& grid = volume.grid;
  switch (plan.level)
  {
  case PlanLevel::Composite:
    return IsRadialVelocity(volume.moment) ? "Composite: where the column's speed is largest"
           : HasTwoSigns(volume.moment) ? "Composite: where the column's value is farthest from 0"
                                        : "Composite: where the column's value is largest";
  case PlanLevel::Lowest:
    return "At the lowest voxel of each column that was scanned";
  default:
    return "At " + Kilometres(grid.Coordinate(2, level)) + " above mean sea level";
  }
}

[[noreturn]] void RefuseArray(const PlanSource& source, const std::string& name)
{
  const MomentName moment = source.voxels.moment;
  std::string has = ToString(moment);
  const auto add = [&](const char* end, const auto* values)
  { has += values == nullptr ? "" : ", " + AncillaryArrayName(moment, end); };
  ForEachAncillaryArray(source, add);
  throw Error("the volume has no array " + name + "; it has " + has +
              " (merge with ancillary arrays for more)");
}

// Whether some radar measured the voxel; column filling also gives values to others.
VoxelState StateOfAncillaryArray(const PlanSource& source, std::size_t voxel, VoxelState state)
{
  const bool unseen =
    (source.radars != nullptr && source.radars[voxel] == 0) ||
    (source.nearestSite != nullptr && source.nearestSite[voxel] == AncillaryArrays::NoSite);
  if (!IsMeasured(state))
  {
    return state;
  }
  return unseen ? VoxelState::NotScanned : VoxelState::Echo;
}

// The values and states of an ancillary array in the voxels that are shown.
void TakeAncillaryArray(const PlanSource& source, const std::string& name,
  const std::vector<ShownVoxel>& shown, PlanView& view)
{
  const auto take = [&](const char* end, const auto* values)
  {
    if (values == nullptr || name != AncillaryArrayName(source.voxels.moment, end))
    {
      return;
    }
    for (std::size_t column = 0; column < shown.size(); ++column)
    {
      const std::size_t voxel =
        column + shown.size() * static_cast<std::size_t>(shown[column].level);
      view.values.push_back(static_cast<float>(values[voxel]));
      view.states.push_back(StateOfAncillaryArray(source, voxel, shown[column].state));
    }
  };
  ForEachAncillaryArray(source, take);
  if (view.values.empty())
  {
    RefuseArray(source, name);
  }
}

void TakeMoment(const std::vector<ShownVoxel>& shown, PlanView& view)
{
  for (const ShownVoxel& voxel : shown)
  {
    view.values.push_back(voxel.value);
    view.states.push_back(voxel.state);
  }
}

ColumnProduct MakeProduct(const VoxelLines& volume, const PlanOptions& plan, const RangeLoop& loop)
{
  switch (plan.level)
  {
  case PlanLevel::EchoTop:
    return MakeEchoTops(volume, plan.threshold, loop);
  case PlanLevel::LiquidDensity:
    return MakeLiquidDensity(volume, plan.threshold, loop);
  default:
    return MakeIntegratedLiquid(volume, loop);
  }
}

std::string ProductText(const PlanOptions& plan)
{
  const std::string capped = "above 56 dBZ as 56 dBZ";
  const std::string threshold = NumberWord(plan.threshold) + " dBZ";
  switch (plan.level)
  {
  case PlanLevel::EchoTop:
    return "Highest place of each column with " + threshold + ", in km above mean sea level";
  case PlanLevel::LiquidDensity:
    return "Liquid of each column (" + capped + ") through the height of its echo top at " +
           threshold + " above the ground at the nearest radar";
  default:
    return "Of all voxels of each column; " + capped;
  }
}

} // namespace

PlanView MakePlanView(const PlanSource& source, const PlanOptions& plan, const RangeLoop& loop)
{
  const VoxelLines& volume = source.voxels;
  const bool moment = plan.array.empty() || plan.array == ToString(volume.moment);
  const char* sharpened = source.sharpened && moment && volume.moment == MomentName::REF
                            ? "; the beam width is deconvolved in elevation"
                            : "";
  if (IsColumnProduct(plan.level))
  {
    if (!plan.array.empty() && plan.array != ToString(volume.moment))
    {
      throw Error("echo tops and liquid are computed of REF, not of " + plan.array);
    }
    return {MakeProduct(volume, plan, loop), ProductText(plan) + sharpened};
  }
  if (plan.level == PlanLevel::Composite)
  {
    CheckComposite(volume.moment);
  }
  const int level = plan.level == PlanLevel::Height ? LevelAt(volume.grid, plan.height) : 0;
  const std::vector<ShownVoxel> shown = FindShown(volume, plan.level, level, loop);
  PlanView view;
  view.width = volume.grid.dimensions[0];
  view.height = volume.grid.dimensions[1];
  moment ? TakeMoment(shown, view) : TakeAncillaryArray(source, plan.array, shown, view);
  view.where = WhereText(volume, plan, level) + sharpened;
  return view;
}

} // namespace nexrad::scene
