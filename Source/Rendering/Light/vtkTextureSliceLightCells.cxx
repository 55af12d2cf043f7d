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
    Sums sums{std::vector<float>(this->Rows.Length), std::vector<float>(this->Rows.Length)};
    Voxels voxels{std::vector<float>(this->Rows.Length * this->Rows.Components),
      std::vector<float>(this->Rows.Length), std::vector<unsigned char>(this->Rows.Length, 1)};
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      const int cellY = row % this->Grid.Size[1];
      const int cellZ = row / this->Grid.Size[1];
      const auto [firstY, endY] = this->Grid.GetRows(cellY, 1);
      const auto [firstZ, endZ] = this->Grid.GetRows(cellZ, 2);
      std::fill(sums.Values.begin(), sums.Values.end(), 0.0f);
      std::fill(sums.Visible.begin(), sums.Visible.end(), 0.0f);
      for (int z = firstZ; z < endZ; ++z)
      {
        for (int y = firstY; y < endY; ++y)
        {
          this->AddRow(y, z, voxels, sums);
        }
      }
      float* cells = this->Values.data() + std::ptrdiff_t{row} * this->Grid.Size[0];
      this->Average(sums, (endY - firstY) * (endZ - firstZ), cells);
      if (this->Input.Left)
      {
        this->Cut(this->Grid.GetPlace(cellY, 1), this->Grid.GetPlace(cellZ, 2), cells);
      }
    }
  }

private:
  /// Over the rows of voxels of a row of cells.
  struct Sums
  {
    std::vector<float> Values;
    std::vector<float> Visible; ///< how many voxels
  };

  struct Voxels
  {
    std::vector<float> Scalars; ///< component by component
    std::vector<float> Values;
    std::vector<unsigned char> Visible;
  };

  bool HasSurfaces() const { return !this->Input.Surfaces.empty(); }

  void AddRow(int y, int z, Voxels& voxels, Sums& sums) const
  {
    const std::size_t length = this->Rows.Length;
    const unsigned char* mask = this->Input.Mask;
    mask = mask == nullptr ? nullptr
                           : mask + (std::ptrdiff_t{z} * this->Grid.Voxels[1] + y) *
                                      std::ptrdiff_t{this->Grid.Voxels[0]};
    if (this->Input.Masked)
    {
      this->Rows.MarkVisible(y, z, 0, length, voxels.Visible.data());
    }
    this->Decode(this->Rows.GetScalars(y, z), voxels.Scalars.data());
    const float* values = voxels.Values.data();
    if (this->HasSurfaces())
    {
      values = voxels.Scalars.data() + this->Input.Component * length;
    }
    else
    {
      this->LookUp(voxels.Scalars.data(), mask, voxels.Values);
    }
    for (std::size_t i = 0; i < length; ++i)
    {
      const bool hidden = this->HasSurfaces() && mask != nullptr && mask[i] == 0;
      const bool visible = voxels.Visible[i] != 0 && !hidden;
      sums.Values[i] += visible ? values[i] : 0.0f;
      sums.Visible[i] += visible ? 1.0f : 0.0f;
    }
  }

  void Decode(const Scalar* scalars, float* decoded) const
  {
    const std::size_t components = this->Rows.Components;
    for (std::size_t component = 0; component < components; ++component)
    {
      for (std::size_t i = 0; i < this->Rows.Length; ++i)
      {
        const Scalar scalar = scalars[i * components + component];
        *decoded++ = this->Input.Scalars.Codes
                       ? static_cast<float>(
                           this->Input.Scalars.Codes->Values[static_cast<std::size_t>(scalar)])
                       : static_cast<float>(scalar);
      }
    }
  }

  void LookUp(
    const float* scalars, const unsigned char* mask, std::vector<float>& extinctions) const
  {
    std::fill(extinctions.begin(), extinctions.end(), 0.0f);
    for (std::size_t i = 0; mask != nullptr && i < extinctions.size(); ++i)
    {
      for (const Lookup& lookUp :
        this->Lookups[std::min<std::size_t>(mask[i], this->Lookups.size() - 1)])
      {
        extinctions[i] += lookUp(scalars[lookUp.Component * this->Rows.Length + i]);
      }
    }
    for (std::size_t set = 0; mask == nullptr && set < this->Lookups[0].size(); ++set)
    {
      const Lookup& lookUp = this->Lookups[0][set];
      const float* scalar = scalars + lookUp.Component * this->Rows.Length;
      for (std::size_t i = 0; i < extinctions.size(); ++i)
      {
        extinctions[i] += lookUp(scalar[i]);
      }
    }
    for (float& extinction : extinctions)
    {
      extinction = extinction < this->Most ? extinction : this->Most;
    }
  }

  void Average(const Sums& sums, int rows, float* cells) const
  {
    const auto factor = static_cast<std::size_t>(this->Grid.Factor[0]);
    for (std::size_t cell = 0; cell * factor < this->Rows.Length; ++cell)
    {
      const std::size_t end = std::min(this->Rows.Length, (cell + 1) * factor);
      float sum = 0.0f;
      float visible = 0.0f;
      for (std::size_t i = cell * factor; i < end; ++i)
      {
        sum += sums.Values[i];
        visible += sums.Visible[i];
      }
      const auto all = static_cast<float>(rows * static_cast<int>(end - cell * factor));
      cells[cell] = !this->HasSurfaces()    ? sum / all
                    : 2.0f * visible >= all ? sum / visible
                                            : NotANumber;
    }
  }

  void Cut(double y, double z, float* cells) const
  {
    for (int x = 0; x < this->Grid.Size[0]; ++x)
    {
      if (!this->Input.Left->Leaves({this->Grid.GetPlace(x, 0), y, z}))
      {
        cells[x] = this->HasSurfaces() ? NotANumber : 0.0f;
      }
    }
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
