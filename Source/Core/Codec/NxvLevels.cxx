// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/NxvLevels.h"

#include "nexrad/Grid/MomentCode.h"
#include "nexrad/Polar/GateCode.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numeric>

namespace nexrad
{

namespace
{

constexpr int mostColumns = 512; // of the last level, along x and along y
constexpr int fewLayers = 32;    // that are not halved

// Of the states of two voxels the one that says more: an echo, then no echo, then MoreKnown.
VoxelState SayingMore(VoxelState first, VoxelState second)
{
  return IsMeasured(first) || IsMeasured(second) ? std::min(first, second)
                                                 : MoreKnown(first, second);
}

// Rows of voxels along x, by their layer and their place in it.
struct Rows
{
  std::size_t length;
  std::size_t inLayer;

  explicit Rows(const GridSpecification& grid)
    : length(static_cast<std::size_t>(grid.dimensions[0]))
    , inLayer(static_cast<std::size_t>(grid.dimensions[1]))
  {
  }
  std::size_t First(std::size_t row, std::size_t layer) const
  {
    return (layer * inLayer + row) * length;
  }
};

// The mean of voxels with echo among others.
class EchoMean
{
public:
  explicit EchoMean(MomentName moment)
    : rule(ValueRule::Of(moment, true))
  {
  }

  void Add(float value, VoxelState state)
  {
    measured += IsMeasured(state) ? 1 : 0;
    if (state != VoxelState::Echo)
    {
      return;
    }
    first = echoes == 0 ? value : first;
    sum += rule.linear ? std::exp2(decibel * value) : value;
    ++echoes;
  }

  float Value() const
  {
    if (rule.nearest || rule.period > 0.0F)
    {
      return first;
    }
    return rule.linear ? std::log2(sum / static_cast<float>(measured)) / decibel
                       : sum / static_cast<float>(echoes);
  }

private:
  static constexpr float decibel = 0.33219281F; // log2(10)/10

  ValueRule rule;
  float first = 0.0F;
  float sum = 0.0F;
  int echoes = 0;
  int measured = 0;
};

// Sets one moment's voxels from those that they take the place of.
class MomentLevel
{
public:
  MomentLevel(const GriddedVolume& theFine, const VoxelsInOne& theVoxels, int theRow,
    GriddedVolume& theCoarse)
    : fine(theFine)
    , coarse(theCoarse)
    , from(theFine.grid)
    , to(theCoarse.grid)
    , firstRow(static_cast<std::size_t>(theRow))
  {
    std::copy(theVoxels.begin(), theVoxels.end(), voxels.begin());
    layers = static_cast<std::size_t>(fine.grid.dimensions[2]);
    rows = (from.inLayer - 1) / voxels[1] + 1;
  }

  std::size_t CountRows() const
  {
    return rows * static_cast<std::size_t>(coarse.grid.dimensions[2]);
  }

  void SetRow(std::size_t number)
  {
    const std::size_t row = number % rows;
    const std::size_t layer = number / rows;
    const std::size_t start = to.First(firstRow + row, layer);
    VoxelState* states = coarse.states.data() + start;
    std::vector<VoxelState> most(from.length, VoxelState::NotScanned);
    this->ForRowsOf(row, layer, [&](std::size_t first) { this->SayMore(first, most); });
    for (std::size_t x = 0; x < to.length; ++x)
    {
      const auto begin = most.begin() + static_cast<std::ptrdiff_t>(x * voxels[0]);
      const auto end =
        most.begin() + static_cast<std::ptrdiff_t>(std::min((x + 1) * voxels[0], from.length));
      states[x] = std::accumulate(begin + 1, end, *begin, SayingMore);
    }
    ForEachEcho(states, to.length,
      [&](std::size_t x) { coarse.values[start + x] = this->MeanAt(x, row, layer); });
  }

private:
  // Of each voxel of a row, and of one in the same place, the state that says more. Nearly all are
  // alike: several at once are compared.
  void SayMore(std::size_t first, std::vector<VoxelState>& most) const
  {
    constexpr std::size_t together = 32;
    const VoxelState* own = fine.states.data() + first;
    for (std::size_t begin = 0; begin < from.length; begin += together)
    {
      const std::size_t end = std::min(begin + together, from.length);
      if (std::memcmp(own + begin, most.data() + begin, end - begin) != 0)
      {
        std::transform(most.begin() + static_cast<std::ptrdiff_t>(begin),
          most.begin() + static_cast<std::ptrdiff_t>(end), own + begin,
          most.begin() + static_cast<std::ptrdiff_t>(begin), SayingMore);
      }
    }
  }

  // Calls `visit` with the first voxel of each row that a row takes the place of.
  template <class Visit>
  void ForRowsOf(std::size_t row, std::size_t layer, const Visit& visit) const
  {
    for (std::size_t z = layer * voxels[2]; z < std::min((layer + 1) * voxels[2], layers); ++z)
    {
      for (std::size_t y = row * voxels[1]; y < std::min((row + 1) * voxels[1], from.inLayer); ++y)
      {
        visit(from.First(y, z));
      }
    }
  }

  float MeanAt(std::size_t x, std::size_t row, std::size_t layer) const
  {
    EchoMean mean(coarse.moment);
    this->ForRowsOf(row, layer,
      [&](std::size_t first)
      {
        const std::size_t end = std::min((x + 1) * voxels[0], from.length);
        for (std::size_t i = first + x * voxels[0]; i < first + end; ++i)
        {
          mean.Add(fine.values[i], fine.states[i]);
        }
      });
    return mean.Value();
  }

  const GriddedVolume& fine;
  GriddedVolume& coarse;
  const Rows from;
  const Rows to;
  std::array<std::size_t, 3> voxels{};
  std::size_t layers;
  std::size_t rows; // of the coarser volume
  std::size_t firstRow;
};

} // namespace

GridSpecification CoarserGrid(const GridSpecification& grid, const VoxelsInOne& voxels)
{
  GridSpecification coarser = grid;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    coarser.dimensions[axis] = (grid.dimensions[axis] - 1) / voxels[axis] + 1;
    coarser.spacing[axis] = grid.spacing[axis] * voxels[axis];
    coarser.origin[axis] = grid.origin[axis] + 0.5 * (coarser.spacing[axis] - grid.spacing[axis]);
  }
  return coarser;
}

std::vector<VoxelsInOne> CoarserLevels(const GridSpecification& grid)
{
  std::vector<VoxelsInOne> levels;
  VoxelsInOne voxels = {1, 1, 1};
  const auto isFine = [&grid, &voxels]
  {
    const auto [x, y, z] = CoarserGrid(grid, voxels).dimensions;
    return x > mostColumns || y > mostColumns;
  };
  while (isFine())
  {
    const bool halvesLayers = CoarserGrid(grid, voxels).dimensions[2] > fewLayers;
    voxels = {2 * voxels[0], 2 * voxels[1], (halvesLayers ? 2 : 1) * voxels[2]};
    levels.push_back(voxels);
  }
  return levels;
}

VoxelsInOne VoxelsBetween(const VoxelsInOne& fine, const VoxelsInOne& coarse)
{
  return {coarse[0] / fine[0], coarse[1] / fine[1], coarse[2] / fine[2]};
}

GriddedVolume VolumeLike(const GriddedVolume& volume, const GridSpecification& grid)
{
  GriddedVolume like = WithoutVoxels(volume);
  like.grid = grid;
  like.values.assign(grid.VoxelCount(), like.fill);
  like.states.assign(grid.VoxelCount(), VoxelState::NotScanned);
  for (const GriddedVolume& further : volume.further)
  {
    like.further.push_back(VolumeLike(further, grid));
  }
  return like;
}

void SetCoarser(const GriddedVolume& fine, const VoxelsInOne& voxels, int row,
  GriddedVolume& coarse, const RangeLoop& loop)
{
  MomentLevel level(fine, voxels, row, coarse);
  RunEach(loop, level.CountRows(), [&level](std::size_t number) { level.SetRow(number); });
  for (std::size_t i = 0; i < fine.further.size(); ++i)
  {
    SetCoarser(fine.further[i], voxels, row, coarse.further[i], loop);
  }
}

} // namespace nexrad
