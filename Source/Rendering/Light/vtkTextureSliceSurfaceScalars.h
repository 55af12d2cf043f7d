// SPDX-License-Identifier: BSD-3-Clause
// The scalars of a volume in the cells of a light volume, for the surfaces that light crosses.
#ifndef vtkTextureSliceSurfaceScalars_h
#define vtkTextureSliceSurfaceScalars_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceLightGrid.h"
#include "vtkTextureSliceScalars.h"

#include <array>
#include <cstddef>
#include <vector>

/**
 * The mean scalar of each cell of a grid, over its visible voxels. Not a number where fewer than
 * half of them are visible: no surface has an end there.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceSurfaceScalars
{
public:
  /// An isosurface, and the optical depth of crossing it: -ln(1 - opacity).
  struct Surface
  {
    float Value;
    float Depth;
  };

  /// What the cells are made from.
  struct Source
  {
    vtkTextureSliceScalars Scalars;
    /// Which component has the surfaces.
    std::size_t Component = 0;
    /// Whether a voxel may be hidden or not finite.
    bool Masked = false;
    /// One value a voxel, 0: hidden; nullptr: none is.
    const unsigned char* Mask = nullptr;
    /// Data length of each edge of a voxel.
    std::array<double, 3> VoxelEdge{1, 1, 1};
    vtkTextureSliceLightGrid::Cut IsCut;
    std::vector<Surface> Surfaces;
  };

  /// Goes over the voxels, on several threads. Of large cells, the middle rows stand for all.
  void Build(const Source& source, std::size_t mostCells);

  const vtkTextureSliceLightGrid& GetGrid() const { return this->Grid; }
  /// One for each cell, x varying fastest.
  const std::vector<float>& GetValues() const { return this->Values; }

private:
  vtkTextureSliceLightGrid Grid;
  std::vector<float> Values;
};

#endif
