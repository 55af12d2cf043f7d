// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceSurfaceScalars.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkTextureSliceRows.h"

#include <algorithm>
#include <limits>

namespace
{

using Source = vtkTextureSliceSurfaceScalars::Source;

constexpr float NotANumber = std::numeric_limits<float>::quiet_NaN();

/// Averages the scalars of the voxels of one row of cells after another.
template <typename Scalar>
class CellAverager
{
public:
  CellAverager(
    const Source& source, const vtkTextureSliceLightGrid& grid, std::vector<float>& values)
    : Input(source)
    , Grid(grid)
    , Values(values)
    , Rows(source.Scalars)
  {
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    std::vector<float> sums(this->Rows.Length);
    std::vector<float> counts(this->Rows.Length);
    std::vector<unsigned char> visible(this->Rows.Length, 1);
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      const auto ys = this->Grid.GetRows(row % this->Grid.Size[1], 1);
      const auto zs = this->Grid.GetRows(row / this->Grid.Size[1], 2);
      std::fill(sums.begin(), sums.end(), 0.0f);
      std::fill(counts.begin(), counts.end(), 0.0f);
      for (int z = zs.Begin; z < zs.End; ++z)
      {
        for (int y = ys.Begin; y < ys.End; ++y)
        {
          this->MarkVisible(y, z, visible);
          this->AddRow(y, z, visible, sums, counts);
        }
      }
      const int rows = (ys.End - ys.Begin) * (zs.End - zs.Begin);
      this->Average(
        sums, counts, rows, this->Values.data() + std::ptrdiff_t{row} * this->Grid.Size[0]);
    }
  }

private:
  void MarkVisible(int y, int z, std::vector<unsigned char>& visible) const
  {
    if (this->Input.Masked)
    {
      this->Rows.MarkVisible(y, z, 0, this->Rows.Length, visible.data());
    }
    if (this->Input.Mask != nullptr)
    {
      const unsigned char* mask =
        this->Input.Mask + (std::ptrdiff_t{z} * this->Grid.Voxels[1] + y) * this->Grid.Voxels[0];
      for (std::size_t i = 0; i < visible.size(); ++i)
      {
        const bool before = !this->Input.Masked || visible[i] != 0;
        visible[i] = before && mask[i] != 0 ? 1 : 0;
      }
    }
  }

  void AddRow(int y, int z, const std::vector<unsigned char>& visible, std::vector<float>& sums,
    std::vector<float>& counts) const
  {
    const Scalar* scalar = this->Rows.GetScalars(y, z) + this->Input.Component;
    for (std::size_t i = 0; i < sums.size(); ++i, scalar += this->Rows.Components)
    {
      sums[i] += visible[i] != 0 ? this->GetValue(*scalar) : 0.0f;
      counts[i] += visible[i] != 0 ? 1.0f : 0.0f;
    }
  }

  float GetValue(Scalar scalar) const
  {
    const auto& codes = this->Input.Scalars.Codes;
    return static_cast<float>(
      codes ? codes->GetValue(static_cast<std::size_t>(scalar)) : static_cast<double>(scalar));
  }

  void Average(
    const std::vector<float>& sums, const std::vector<float>& counts, int rows, float* values) const
  {
    const auto factor = static_cast<std::size_t>(this->Grid.Factor[0]);
    for (std::size_t cell = 0; cell * factor < sums.size(); ++cell)
    {
      const std::size_t end = std::min(sums.size(), (cell + 1) * factor);
      float sum = 0.0f;
      float count = 0.0f;
      for (std::size_t i = cell * factor; i < end; ++i)
      {
        sum += sums[i];
        count += counts[i];
      }
      const auto voxels = static_cast<float>(rows * static_cast<int>(end - cell * factor));
      values[cell] = 2.0f * count < voxels ? NotANumber : sum / count;
    }
  }

  const Source& Input;
  const vtkTextureSliceLightGrid& Grid;
  std::vector<float>& Values;
  vtkTextureSlice::Rows<Scalar> Rows;
};

} // namespace

void vtkTextureSliceSurfaceScalars::Build(const Source& source, std::size_t mostCells)
{
  this->Grid = vtkTextureSliceLightGrid::Choose(
    source.Scalars.Size, source.Scalars.CellData, source.VoxelEdge, mostCells);
  this->Values.resize(this->Grid.CountCells());
  const vtkIdType rows = vtkIdType{this->Grid.Size[1]} * this->Grid.Size[2];
  switch (source.Scalars.Scalars->GetDataType())
  {
    vtkTemplateMacro(
      vtkSMPTools::For(0, rows, CellAverager<VTK_TT>(source, this->Grid, this->Values)));
  }
  this->Grid.Replace(source.IsCut, NotANumber, this->Values);
}
