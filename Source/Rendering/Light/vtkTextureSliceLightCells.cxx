// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceLightCells.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <limits>

namespace
{

using Function = vtkTextureSliceLightCells::Function;
using Source = vtkTextureSliceLightCells::Source;

/// A voxel counts as no denser than this over its shortest edge: light that passes through a few
/// voxels of an opaque cell's edge is not stopped by their mean.
constexpr float MostDepthOfAVoxel = 4.0f;

constexpr float NotANumber = std::numeric_limits<float>::quiet_NaN();

/// A function as the loops over voxels read it.
struct Lookup
{
  explicit Lookup(const Function& function)
    : Entries(function.Entries.data())
    , Component(function.Component)
    , Last(static_cast<float>(function.Entries.size() - 1))
    , Low(static_cast<float>(function.Range[0]))
    , Scale(function.Range[1] > function.Range[0]
              ? this->Last / static_cast<float>(function.Range[1] - function.Range[0])
              : this->Last)
  {
  }

  float operator()(float scalar) const
  {
    const float entry = (scalar - this->Low) * this->Scale;
    // In this order a scalar that is not a number reads the first entry.
    const float inside = entry > 0.0f ? (entry < this->Last ? entry : this->Last) : 0.0f;
    return this->Entries[static_cast<int>(inside + 0.5f)];
  }

  const float* Entries;
  std::size_t Component;
  float Last;
  float Low;
  float Scale;
};

template <typename Scalar>
class RowsOfCells
{
public:
  RowsOfCells(
    const Source& source, const vtkTextureSliceLightGrid& grid, std::vector<float>& values)
    : Input(source)
    , Grid(grid)
    , Values(values)
    , Rows(source.Scalars)
    , Most(MostDepthOfAVoxel /
           static_cast<float>(*std::min_element(source.VoxelEdge.begin(), source.VoxelEdge.end())))
  {
    for (const std::vector<Function>& functions : source.Functions)
    {
      this->Lookups.emplace_back(functions.begin(), functions.end());
    }
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    std::vector<unsigned char> visible(this->Rows.Length, 1);
    std::vector<Sum> sums;
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      const int cellY = row % this->Grid.Size[1];
      const int cellZ = row / this->Grid.Size[1];
      const auto [firstY, endY] = this->Grid.GetRows(cellY, 1);
      const auto [firstZ, endZ] = this->Grid.GetRows(cellZ, 2);
      sums.assign(static_cast<std::size_t>(this->Grid.Size[0]), {});
      for (int z = firstZ; z < endZ; ++z)
      {
        for (int y = firstY; y < endY; ++y)
        {
          this->AddRow(y, z, visible, sums.data());
        }
      }
      const int rows = (endY - firstY) * (endZ - firstZ);
      float* cells = this->Values.data() + std::ptrdiff_t{row} * this->Grid.Size[0];
      for (int x = 0; x < this->Grid.Size[0]; ++x)
      {
        const int first = x * this->Grid.Factor[0];
        const int voxels = std::min(this->Grid.Factor[0], this->Grid.Voxels[0] - first) * rows;
        const bool left =
          !this->Input.Left || this->Input.Left->Leaves({this->Grid.GetPlace(x, 0),
                                 this->Grid.GetPlace(cellY, 1), this->Grid.GetPlace(cellZ, 2)});
        cells[x] = this->Average(left ? sums[static_cast<std::size_t>(x)] : Sum(), voxels);
      }
    }
  }

private:
  /// Over the voxels of a cell.
  struct Sum
  {
    float Value = 0.0f;
    int Visible = 0; ///< with isosurfaces: how many voxels
  };

  bool HasSurfaces() const { return !this->Input.Surfaces.empty(); }

  void AddRow(int y, int z, std::vector<unsigned char>& visible, Sum* sums) const
  {
    if (this->Input.Masked)
    {
      this->Rows.MarkVisible(y, z, 0, this->Rows.Length, visible.data());
    }
    const Scalar* scalars = this->Rows.GetScalars(y, z);
    const unsigned char* mask = this->Input.Mask;
    mask = mask == nullptr ? nullptr
                           : mask + (std::ptrdiff_t{z} * this->Grid.Voxels[1] + y) *
                                      std::ptrdiff_t{this->Grid.Voxels[0]};
    for (std::size_t i = 0; i < this->Rows.Length; ++sums)
    {
      Sum sum = *sums; // a copy, so that the functions need not be read anew
      const std::size_t end =
        std::min(this->Rows.Length, i + static_cast<std::size_t>(this->Grid.Factor[0]));
      for (; i < end; ++i, scalars += this->Rows.Components)
      {
        const std::size_t label = mask == nullptr ? 0 : mask[i];
        if (visible[i] != 0 && !this->HasSurfaces())
        {
          sum.Value += this->FindExtinction(scalars, label);
        }
        else if (visible[i] != 0 && (mask == nullptr || label > 0))
        {
          sum.Value += this->Decode(scalars[this->Input.Component]);
          ++sum.Visible;
        }
      }
      *sums = sum;
    }
  }

  float Decode(Scalar scalar) const
  {
    const auto& codes = this->Input.Scalars.Codes;
    return static_cast<float>(codes ? codes->Values[static_cast<std::size_t>(scalar)] : scalar);
  }

  float FindExtinction(const Scalar* scalars, std::size_t label) const
  {
    float extinction = 0.0f;
    for (const Lookup& lookUp : this->Lookups[std::min(label, this->Lookups.size() - 1)])
    {
      extinction += lookUp(this->Decode(scalars[lookUp.Component]));
    }
    return std::min(extinction, this->Most);
  }

  float Average(const Sum& sum, int voxels) const
  {
    if (!this->HasSurfaces())
    {
      return sum.Value / static_cast<float>(voxels);
    }
    return 2 * sum.Visible >= voxels ? sum.Value / static_cast<float>(sum.Visible) : NotANumber;
  }

  const Source& Input;
  const vtkTextureSliceLightGrid& Grid;
  std::vector<float>& Values;
  vtkTextureSlice::Rows<Scalar> Rows;
  const float Most;
  std::vector<std::vector<Lookup>> Lookups;
};

} // namespace

vtkTextureSliceLightGrid vtkTextureSliceLightGrid::Choose(const std::array<int, 3>& voxels,
  bool cellData, const std::array<double, 3>& voxelEdge, std::size_t mostCells)
{
  vtkTextureSliceLightGrid grid;
  grid.Voxels = voxels;
  grid.Size = voxels;
  grid.CellEdge = voxelEdge;
  grid.CellData = cellData;
  while (grid.CountCells() > mostCells)
  {
    const auto shortest = static_cast<std::size_t>(
      std::min_element(grid.CellEdge.begin(), grid.CellEdge.end()) - grid.CellEdge.begin());
    // An axis of one cell has nothing left to give.
    const auto longest = static_cast<std::size_t>(
      std::max_element(grid.Size.begin(), grid.Size.end()) - grid.Size.begin());
    const std::size_t axis = grid.Size[shortest] > 1 ? shortest : longest;
    if (grid.Size[axis] == 1)
    {
      break;
    }
    grid.Factor[axis] *= 2;
    grid.CellEdge[axis] *= 2.0;
    grid.Size[axis] = (voxels[axis] + grid.Factor[axis] - 1) / grid.Factor[axis];
  }
  return grid;
}

std::size_t vtkTextureSliceLightGrid::CountCells(int more) const
{
  return static_cast<std::size_t>(this->Size[0] + more) *
         static_cast<std::size_t>(this->Size[1] + more) *
         static_cast<std::size_t>(this->Size[2] + more);
}

std::array<int, 2> vtkTextureSliceLightGrid::GetRows(int cell, std::size_t axis) const
{
  constexpr int mostRows = 4;
  const int inset = std::max(0, (this->Factor[axis] - mostRows) / 2);
  const int end = std::min(this->Voxels[axis], (cell + 1) * this->Factor[axis] - inset);
  return {std::min(cell * this->Factor[axis] + inset, end - 1), end};
}

double vtkTextureSliceLightGrid::GetPlace(int cell, std::size_t axis) const
{
  const double low = this->GetMargin(axis, false);
  const double intervals = low + this->Size[axis] - 1 + this->GetMargin(axis, true);
  return (cell + low) / intervals;
}

double vtkTextureSliceLightGrid::GetMargin(std::size_t axis, bool high) const
{
  const double factor = this->Factor[axis];
  const double face = this->CellData ? 0.5 : 0.0; // voxels beyond the centre of the outermost one
  const double centre =
    high ? factor * (this->Size[axis] - 1) + (factor - 1.0) / 2.0 : (factor - 1.0) / 2.0;
  return (high ? this->Voxels[axis] - 1 + face - centre : centre + face) / factor;
}

std::array<float, 3> vtkTextureSliceLightGrid::GetTextureScale() const
{
  std::array<float, 3> scale{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scale[axis] = static_cast<float>(this->Voxels[axis]) /
                  static_cast<float>(this->Factor[axis] * this->Size[axis]);
  }
  return scale;
}

bool vtkTextureSliceCut::Leaves(const std::array<double, 3>& at) const
{
  int region = 0;
  constexpr std::array<int, 3> weights{1, 3, 9};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (at[axis] < this->Part[2 * axis] || at[axis] > this->Part[2 * axis + 1])
    {
      return false;
    }
    region += weights[axis] * ((at[axis] >= this->CropLow[axis] ? 1 : 0) +
                                (at[axis] > this->CropHigh[axis] ? 1 : 0));
  }
  return (this->CropFlags >> region & 1) != 0 &&
         std::all_of(this->Planes.begin(), this->Planes.end(),
           [&](const std::array<double, 4>& plane)
           { return plane[0] * at[0] + plane[1] * at[1] + plane[2] * at[2] + plane[3] >= 0.0; });
}

vtkTextureSliceLightCells::vtkTextureSliceLightCells(const Source& source, std::size_t mostCells)
  : Grid(vtkTextureSliceLightGrid::Choose(
      source.Scalars.Size, source.Scalars.CellData, source.VoxelEdge, mostCells))
  , Surfaces(source.Surfaces)
  , Values(this->Grid.CountCells())
{
  const vtkIdType rows = vtkIdType{this->Grid.Size[1]} * this->Grid.Size[2];
  switch (source.Scalars.Scalars->GetDataType())
  {
    vtkTemplateMacro(
      vtkSMPTools::For(0, rows, RowsOfCells<VTK_TT>(source, this->Grid, this->Values)));
  }
}
