// SPDX-License-Identifier: BSD-3-Clause
// Formulas L2: how much light arrives in the cells of volumes whose shadows are known.
#include "vtkTextureSliceLightVolume.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>
#include <vector>

namespace
{

using Lights = vtkTextureSliceLightVolume::Lights;

/// The length from a place to the face of a box from 0 on, where a direction leaves it.
double LengthInside(const std::array<double, 3>& at, const std::array<double, 3>& towards,
  const std::array<double, 3>& box)
{
  double length = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (towards[axis] != 0.0)
    {
      const double face = towards[axis] > 0.0 ? box[axis] : 0.0;
      length = std::min(length, (face - at[axis]) / towards[axis]);
    }
  }
  return length * std::hypot(towards[0], towards[1], towards[2]);
}

/// Whether the light of a place, and of places a cell beside it, comes in by the same face, that of
/// the axis on which the direction takes the fewest steps.
bool EntersByOneFace(const std::array<double, 3>& at, const std::array<double, 3>& towards,
  const std::array<double, 3>& box, const std::array<double, 3>& cellEdge)
{
  std::size_t through = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    through =
      std::abs(towards[axis]) / cellEdge[axis] > std::abs(towards[through]) / cellEdge[through]
        ? axis
        : through;
  }
  const double face = towards[through] > 0.0 ? box[through] : 0.0;
  const double way = (face - at[through]) / towards[through];
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double entry = at[axis] + way * towards[axis];
    if (axis != through && (entry < cellEdge[axis] || entry > box[axis] - cellEdge[axis]))
    {
      return false;
    }
  }
  return true;
}

/// A volume whose scalars are extinctions (0 to 1), and its light.
class LightVolume : public ::testing::Test
{
protected:
  void Make(const std::array<int, 3>& voxels, const std::array<double, 3>& edge,
    const std::function<double(double, double, double)>& extinction)
  {
    this->Scalars->SetNumberOfValues(vtkIdType{voxels[0]} * voxels[1] * voxels[2]);
    this->Source.Scalars = {this->Scalars, voxels, false, nullptr};
    this->Source.VoxelEdge = edge;
    this->Source.Functions = {{{0, {0.0, 1.0}, {}}}};
    for (int i = 0; i <= 1000; ++i)
    {
      this->Source.Functions[0][0].Entries.push_back(static_cast<float>(i / 1000.0));
    }
    vtkIdType id = 0;
    for (int z = 0; z < voxels[2]; ++z)
    {
      for (int y = 0; y < voxels[1]; ++y)
      {
        for (int x = 0; x < voxels[0]; ++x, ++id)
        {
          this->Scalars->SetValue(
            id, static_cast<float>(extinction(x * edge[0], y * edge[1], z * edge[2])));
        }
      }
    }
  }

  /// With an eighth as many cells as voxels, unless another share is asked for.
  void Build(const Lights& lights, std::size_t voxelsOfACell = 8)
  {
    const auto voxels = static_cast<std::size_t>(this->Scalars->GetNumberOfValues());
    this->Volume.Build({this->Source, voxels / voxelsOfACell}, lights);
  }

  /// Light at a cell, 0 to 1.
  double At(const std::array<int, 3>& cell, int component = 0) const
  {
    const auto& size = this->Volume.GetGrid().Size;
    const vtkIdType index = (cell[2] * size[1] + cell[1]) * size[0] + cell[0];
    return static_cast<double>(this->Volume.GetLight()->GetValue(2 * index + component));
  }

  /// Where a cell's centre lies; the volume begins at 0.
  std::array<double, 3> Centre(const std::array<int, 3>& cell) const
  {
    const vtkTextureSliceLightGrid& grid = this->Volume.GetGrid();
    std::array<double, 3> centre{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      centre[axis] = (cell[axis] * grid.Factor[axis] + (grid.Factor[axis] - 1) / 2.0) *
                     this->Source.VoxelEdge[axis];
    }
    return centre;
  }

  /// How far the cells of a homogeneous volume are from exp(-depth).
  struct Errors
  {
    /// The largest relative difference of cells that the light reaches through one face alone.
    double OfSlab = 0.0;
    /// The largest difference of the other cells, in the depths of a cell.
    double OfEdges = 0.0;
    int Cells = 0; ///< of the slab
  };

  Errors FindErrors(
    const std::array<double, 3>& towards, const std::array<double, 3>& box, double extinction)
  {
    Lights lights;
    lights.Shadow = true;
    lights.ToLight = towards;
    this->Build(lights);
    const auto& size = this->Volume.GetGrid().Size;
    const auto& cellEdge = this->Volume.GetGrid().CellEdge;
    const double cellDepth = extinction * std::hypot(cellEdge[0], cellEdge[1], cellEdge[2]);
    Errors errors;
    for (int z = 0; z < size[2]; ++z)
    {
      for (int y = 0; y < size[1]; ++y)
      {
        for (int x = 0; x < size[0]; ++x)
        {
          // The centre of an incomplete cell may be outside.
          const std::array<double, 3> centre = this->Centre({x, y, z});
          const double depth = extinction * std::max(0.0, LengthInside(centre, towards, box));
          const double light = this->At({x, y, z});
          if (EntersByOneFace(centre, towards, box, cellEdge))
          {
            errors.OfSlab = std::max(errors.OfSlab, std::abs(light / std::exp(-depth) - 1.0));
            ++errors.Cells;
          }
          errors.OfEdges = std::max(errors.OfEdges, std::abs(-std::log(light) - depth) / cellDepth);
        }
      }
    }
    return errors;
  }

  vtkNew<vtkFloatArray> Scalars;
  vtkTextureSliceLightCells::Source Source;
  vtkTextureSliceLightVolume Volume;
};

} // namespace

// Whatever the axis that a direction mostly follows, its sign, and the shape of the voxels.
TEST_F(LightVolume, AHomogeneousSlabTransmitsExpOfItsDepth)
{
  constexpr double extinction = 0.05;
  const std::array<double, 3> edge{1.0, 0.9, 1.3};
  for (const std::array<int, 3>& voxels : {std::array<int, 3>{61, 64, 47}, {64, 63, 48}})
  {
    const std::array<double, 3> box{
      (voxels[0] - 1) * edge[0], (voxels[1] - 1) * edge[1], (voxels[2] - 1) * edge[2]};
    this->Make(voxels, edge, [](double, double, double) { return extinction; });
    for (const std::array<double, 3>& towards :
      {std::array<double, 3>{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0},
        {0.4, -0.3, 1.0}, {1.0, 0.5, -0.4}, {0.3, -1.0, 0.6}, {-1, -1, 2}, {-1.0, 1.0, 1.0}})
    {
      const Errors errors = this->FindErrors(towards, box, extinction);
      std::cout << "towards " << towards[0] << ' ' << towards[1] << ' ' << towards[2] << ": "
                << 100.0 * errors.OfSlab << " % of " << errors.Cells << " cells, at the edges "
                << errors.OfEdges << " cells\n";
      EXPECT_GT(errors.Cells, 2000);
      EXPECT_LE(errors.OfSlab, 0.01);
      EXPECT_LE(errors.OfEdges, 1.0);
    }
  }
}

// An opaque block over nothing: its shadow lies where the light draws it, whatever the height, and
// is as sharp below as a cell.
TEST_F(LightVolume, ABlockShadesWhatIsBehindIt)
{
  constexpr double low = 24.0;
  constexpr double high = 40.0;
  this->Make({64, 64, 64}, {1.0, 1.0, 1.0},
    [&](double x, double y, double z)
    { return x > low && x < high && y > low && y < high && z > 44.0 && z < 52.0 ? 1.0 : 0.0; });
  Lights lights;
  lights.Shadow = true;
  for (const double slope : {0.0, 0.45, -0.3})
  {
    lights.ToLight = {slope, 0.0, 1.0};
    this->Build(lights);
    for (const int layer : {1, 10, 18})
    {
      for (int x = 0; x < 32; ++x)
      {
        const std::array<double, 3> centre = this->Centre({x, 16, layer});
        // Where the light of the cell passes the lower and the upper face of the block.
        const double below = centre[0] + slope * (44.0 - centre[2]);
        const double above = centre[0] + slope * (52.0 - centre[2]);
        constexpr double cell = 2.0;
        const double nearest = std::min(below, above);
        const double farthest = std::max(below, above);
        if (nearest > low + cell && farthest < high - cell)
        {
          EXPECT_LT(this->At({x, 16, layer}), 0.01) << slope << ' ' << x << ' ' << layer;
        }
        else if (farthest < low - cell || nearest > high + cell)
        {
          EXPECT_GT(this->At({x, 16, layer}), 0.999) << slope << ' ' << x << ' ' << layer;
        }
      }
    }
    EXPECT_EQ(this->At({16, 16, 30}), 1.0) << "above the block";
  }
}

TEST_F(LightVolume, OcclusionIsTheMeanOverTheSky)
{
  constexpr double extinction = 0.02;
  const std::array<double, 3> box{63.0, 63.0, 63.0};
  this->Make({64, 64, 64}, {1.0, 1.0, 1.0}, [](double, double, double) { return extinction; });
  Lights lights;
  lights.Occlusion = true;
  this->Build(lights);
  EXPECT_EQ(this->At({3, 4, 5}, 0), 1.0) << "no shadow was asked for";
  double meanHeight = 0.0;
  for (const std::array<int, 3>& cell :
    {std::array<int, 3>{16, 16, 16}, {10, 20, 3}, {20, 12, 28}, {16, 16, 1}})
  {
    double expected = 0.0;
    meanHeight = 0.0;
    for (const auto& direction : vtkTextureSliceLightVolume::GetSkyDirections())
    {
      EXPECT_NEAR(std::hypot(direction[0], direction[1], direction[2]), 1.0, 1e-12);
      EXPECT_GT(direction[2], 0.0);
      meanHeight += direction[2] / vtkTextureSliceLightVolume::SkyDirections;
      expected += std::exp(-extinction * LengthInside(this->Centre(cell), direction, box)) /
                  vtkTextureSliceLightVolume::SkyDirections;
    }
    EXPECT_NEAR(this->At(cell, 1) / expected, 1.0, 0.01);
  }
  EXPECT_NEAR(meanHeight, 0.5, 1e-12) << "that of an even sky";
}

TEST_F(LightVolume, HiddenVoxelsAndThoseThatAreNotNumbersLetLightThrough)
{
  this->Make({32, 32, 32}, {1.0, 1.0, 1.0},
    [](double, double, double z)
    { return z > 20.0 ? std::numeric_limits<double>::quiet_NaN() : 1.0; });
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetNumberOfTuples(this->Scalars->GetNumberOfValues());
  for (vtkIdType id = 0; id < ghosts->GetNumberOfTuples(); ++id)
  {
    ghosts->SetValue(id, id % 32 < 16 ? 1 : 0);
  }
  this->Source.Scalars.Ghosts = ghosts;
  this->Source.Masked = true;
  Lights lights;
  lights.Shadow = true;
  this->Build(lights);
  EXPECT_EQ(this->At({4, 8, 0}), 1.0);
  EXPECT_LT(this->At({12, 8, 0}), 1e-4);
  EXPECT_EQ(this->At({12, 8, 12}), 1.0);
}

// Of voxels that are unlike, a cell has the mean extinction, and its light the same in the mean.
TEST_F(LightVolume, ACellHasTheMeanOfItsVoxels)
{
  this->Make({32, 32, 32}, {1.0, 1.0, 1.0},
    [](double x, double y, double z) { return static_cast<int>(x + y + z) % 2 == 0 ? 0.08 : 0.0; });
  Lights lights;
  lights.Shadow = true;
  for (const std::size_t voxelsOfACell : {1, 8, 64, 512})
  {
    this->Build(lights, voxelsOfACell);
    const double depth = 0.04 * (31.0 - this->Centre({2, 2, 0})[2]);
    EXPECT_NEAR(this->At({2, 2, 0}) / std::exp(-depth), 1.0, voxelsOfACell == 1 ? 0.05 : 0.01);
  }
}

// Cells are halved where they are flattest, so that those of flat voxels come near to cubes.
TEST(LightGrid, CellsAreNearToCubes)
{
  const auto size =
    [](const std::array<int, 3>& voxels, const std::array<double, 3>& edge, std::size_t mostCells)
  { return vtkTextureSliceLightGrid::Choose(voxels, false, edge, mostCells).Size; };
  EXPECT_EQ(size({256, 256, 128}, {1, 1, 1}, 1048576), (std::array<int, 3>{128, 128, 64}));
  EXPECT_EQ(size({256, 256, 128}, {1, 1, 1}, 131072), (std::array<int, 3>{64, 64, 32}));
  EXPECT_EQ(size({512, 512, 256}, {1, 1, 1}, 1048576), (std::array<int, 3>{128, 128, 64}));
  EXPECT_EQ(size({256, 256, 128}, {8, 8, 1}, 1048576), (std::array<int, 3>{256, 256, 16}));
  EXPECT_EQ(size({128, 128, 64}, {1, 1, 1}, 1048576), (std::array<int, 3>{128, 128, 64}));
  EXPECT_EQ(size({1, 1, 64}, {1, 1, 9}, 8), (std::array<int, 3>{1, 1, 8}));
}

TEST(LightGrid, IncompleteCellsEndWhereTheVolumeDoes)
{
  const auto grid = vtkTextureSliceLightGrid::Choose({33, 32, 32}, false, {1, 1, 1}, 5000);
  EXPECT_EQ(grid.GetMargin(1, false), 0.25);
  EXPECT_EQ(grid.GetMargin(1, true), 0.25);
  EXPECT_EQ(grid.GetMargin(0, true), grid.Factor[0] == 2 ? -0.25 : 0.0);
  const auto cells = vtkTextureSliceLightGrid::Choose({32, 32, 32}, true, {1, 1, 1}, 5000);
  EXPECT_EQ(cells.GetMargin(2, false), 0.5);
  EXPECT_EQ(cells.GetTextureScale(), (std::array<float, 3>{1.0f, 1.0f, 1.0f}));
}
