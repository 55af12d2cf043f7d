// SPDX-License-Identifier: BSD-3-Clause
// How much the cells of a volume weaken light.
#ifndef vtkTextureSliceExtinction_h
#define vtkTextureSliceExtinction_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceLightGrid.h"
#include "vtkTextureSliceScalars.h"

#include <array>
#include <cstddef>
#include <vector>

/**
 * The extinction (Formulas L2: -ln(1 - opacity) over a length) of each cell of a grid: the mean of
 * its voxels', which the transfer functions give. Voxels that are hidden, that are not finite, or
 * that a mask leaves out let all light through. Gradient opacity does not count.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceExtinction
{
public:
  /// The extinction of a data length over the scalars of one component.
  struct Function
  {
    std::size_t Component = 0;
    /// Scalars of the first and the last entry.
    std::array<double, 2> Range{0.0, 1.0};
    std::vector<float> Entries;
  };

  /// What the cells are made from.
  struct Source
  {
    vtkTextureSliceScalars Scalars;
    /// Whether a voxel may be hidden or not finite.
    bool Masked = false;
    /// The functions of each value of the mask; greater values have those of the last one. A
    /// voxel's extinction is the sum of theirs.
    std::vector<std::vector<Function>> Functions;
    /// One value a voxel; nullptr: all have the first functions.
    const unsigned char* Mask = nullptr;
    /// Data length of each edge of a voxel.
    std::array<double, 3> VoxelEdge{1, 1, 1};
    vtkTextureSliceLightGrid::Cut IsCut;
  };

  /// Goes over the voxels, on several threads. Of large cells, the middle rows stand for all.
  void Build(const Source& source, std::size_t mostCells);

  const vtkTextureSliceLightGrid& GetGrid() const { return this->Grid; }
  /// One for each cell, x varying fastest.
  const std::vector<float>& GetValues() const { return this->Values; }

private:
  void SumVoxels(const Source& source);

  vtkTextureSliceLightGrid Grid;
  std::vector<float> Values;
};

#endif
