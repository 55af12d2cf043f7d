// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceExtinction.h"

#include "vtkDataArray.h"
#include "vtkSMPTools.h"
#include "vtkTextureSliceRows.h"

#include <algorithm>
#include <cstddef>

namespace
{

using Function = vtkTextureSliceExtinction::Function;
using Source = vtkTextureSliceExtinction::Source;

/// A voxel counts as no denser than this over its shortest edge: light that passes through a few
/// voxels of an opaque cell's edge is not stopped by their mean.
constexpr float MostDepthOfAVoxel = 4.0f;

/// A function as the loops over voxels read it.
template <typename Scalar>
struct Lookup
{
  Lookup(const Function& function)
    : Entries(function.Entries.data())
    , Component(function.Component)
    , Last(static_cast<float>(function.Entries.size() - 1))
    , Low(static_cast<float>(function.Range[0]))
    , Scale(function.Range[1] > function.Range[0]
              ? this->Last / static_cast<float>(function.Range[1] - function.Range[0])
              : this->Last)
  {
  }

  float operator()(Scalar scalar) const
  {
    const float entry = (static_cast<float>(scalar) - this->Low) * this->Scale;
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

/// Sums the extinctions of the voxels of one layer of cells after another.
template <typename Scalar>
class LayerSummer
{
public:
  LayerSummer(
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
    std::vector<float> voxels(this->Rows.Length);
    std::vector<float> sums(this->Rows.Length);
    std::vector<unsigned char> visible(this->Rows.Length);
    for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
    {
      const int y = row % this->Grid.Size[1];
      const int z = row / this->Grid.Size[1];
      const int rows = this->SumRows(y, z, voxels, sums, visible);
      this->Average(sums, rows, this->Values.data() + std::ptrdiff_t{row} * this->Grid.Size[0]);
    }
  }

private:
  /// Adds the rows of voxels of a row of cells. @return how many rows there are
  int SumRows(int y, int z, std::vector<float>& voxels, std::vector<float>& sums,
    std::vector<unsigned char>& visible) const
  {
    const vtkTextureSliceLightGrid::Rows ys = this->Grid.GetRows(y, 1);
    const vtkTextureSliceLightGrid::Rows zs = this->Grid.GetRows(z, 2);
    std::fill(sums.begin(), sums.end(), 0.0f);
    for (int k = zs.Begin; k < zs.End; ++k)
    {
      for (int j = ys.Begin; j < ys.End; ++j)
      {
        this->LookUpRow(j, k, voxels);
        if (this->Input.Masked)
        {
          this->Rows.MarkVisible(j, k, 0, this->Rows.Length, visible.data());
          for (std::size_t i = 0; i < voxels.size(); ++i)
          {
            voxels[i] = visible[i] != 0 ? voxels[i] : 0.0f;
          }
        }
        for (std::size_t i = 0; i < voxels.size(); ++i)
        {
          sums[i] += voxels[i] < this->Most ? voxels[i] : this->Most;
        }
      }
    }
    return (ys.End - ys.Begin) * (zs.End - zs.Begin);
  }

  void LookUpRow(int y, int z, std::vector<float>& voxels) const
  {
    const Scalar* scalars = this->Rows.GetScalars(y, z);
    if (this->Input.Mask != nullptr)
    {
      this->LookUpMasked(scalars,
        this->Input.Mask + (std::ptrdiff_t{z} * this->Grid.Voxels[1] + y) * this->Grid.Voxels[0],
        voxels);
      return;
    }
    std::fill(voxels.begin(), voxels.end(), 0.0f);
    for (const Lookup<Scalar>& lookUp : this->Lookups.front())
    {
      const Scalar* scalar = scalars + lookUp.Component;
      for (std::size_t i = 0; i < voxels.size(); ++i, scalar += this->Rows.Components)
      {
        voxels[i] += lookUp(*scalar);
      }
    }
  }

  void LookUpMasked(
    const Scalar* scalars, const unsigned char* mask, std::vector<float>& voxels) const
  {
    for (std::size_t i = 0; i < voxels.size(); ++i, scalars += this->Rows.Components)
    {
      voxels[i] = 0.0f;
      for (const Lookup<Scalar>& lookUp :
        this->Lookups[std::min<std::size_t>(mask[i], this->Lookups.size() - 1)])
      {
        voxels[i] += lookUp(scalars[lookUp.Component]);
      }
    }
  }

  void Average(const std::vector<float>& sums, int rows, float* values) const
  {
    const auto factor = static_cast<std::size_t>(this->Grid.Factor[0]);
    for (std::size_t cell = 0; cell * factor < sums.size(); ++cell)
    {
      const std::size_t end = std::min(sums.size(), (cell + 1) * factor);
      float sum = 0.0f;
      for (std::size_t i = cell * factor; i < end; ++i)
      {
        sum += sums[i];
      }
      values[cell] = sum / static_cast<float>(rows * static_cast<int>(end - cell * factor));
    }
  }

  const Source& Input;
  const vtkTextureSliceLightGrid& Grid;
  std::vector<float>& Values;
  vtkTextureSlice::Rows<Scalar> Rows;
  const float Most;
  std::vector<std::vector<Lookup<Scalar>>> Lookups;
};

/// The function that gives each code what another gives for its value.
Function MakeFunctionOfCodes(const Function& ofValues, const vtkTextureSliceCodes& codes)
{
  const Lookup<double> lookUp(ofValues);
  Function ofCodes;
  ofCodes.Range = {0.0, vtkTextureSliceCodes::Count - 1.0};
  for (std::size_t code = 0; code < vtkTextureSliceCodes::Count; ++code)
  {
    ofCodes.Entries.push_back(lookUp(codes.GetValue(code)));
  }
  return ofCodes;
}

Source WithFunctionsOfCodes(Source source)
{
  for (std::vector<Function>& functions : source.Functions)
  {
    for (Function& function : functions)
    {
      function = MakeFunctionOfCodes(function, *source.Scalars.Codes);
    }
  }
  return source;
}

} // namespace

void vtkTextureSliceExtinction::Build(const Source& source, std::size_t mostCells)
{
  this->Grid = vtkTextureSliceLightGrid::Choose(
    source.Scalars.Size, source.Scalars.CellData, source.VoxelEdge, mostCells);
  this->Values.resize(this->Grid.CountCells());
  source.Scalars.Codes ? this->SumVoxels(WithFunctionsOfCodes(source)) : this->SumVoxels(source);
  this->Grid.Replace(source.IsCut, 0.0f, this->Values);
}

void vtkTextureSliceExtinction::SumVoxels(const Source& source)
{
  const vtkIdType rows = vtkIdType{this->Grid.Size[1]} * this->Grid.Size[2];
  switch (source.Scalars.Scalars->GetDataType())
  {
    vtkTemplateMacro(
      vtkSMPTools::For(0, rows, LayerSummer<VTK_TT>(source, this->Grid, this->Values)));
  }
}
