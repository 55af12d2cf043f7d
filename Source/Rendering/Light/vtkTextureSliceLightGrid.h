// SPDX-License-Identifier: BSD-3-Clause
// The cells in which the light of a volume is computed.
#ifndef vtkTextureSliceLightGrid_h
#define vtkTextureSliceLightGrid_h

#include "vtkNexradRenderingModule.h" // for the export macro

#include <array>
#include <cstddef>

/**
 * A volume cut into cells of whole voxels, as near to cubes as they can be. Lengths are data
 * lengths: those of the volume before its actor's matrix.
 */
struct VTKNEXRADRENDERING_EXPORT vtkTextureSliceLightGrid
{
  std::array<int, 3> Voxels{1, 1, 1}; ///< along each axis: points, or cells of the volume
  std::array<int, 3> Factor{1, 1, 1}; ///< voxels along each edge of a cell
  std::array<int, 3> Size{1, 1, 1};   ///< cells along each axis; the last one may be incomplete
  std::array<double, 3> CellEdge{1, 1, 1};
  /// Whether the volume ends at the faces of its outermost voxels, and not at their centres.
  bool CellData = false;

  /// Halves the resolution along the axis of the shortest cell edge until there are no more cells
  /// than that.
  static vtkTextureSliceLightGrid Choose(const std::array<int, 3>& voxels, bool cellData,
    const std::array<double, 3>& voxelEdge, std::size_t mostCells);

  std::size_t CountCells() const;
  /// Rows of voxels along an axis: [Begin, End).
  struct Rows
  {
    int Begin;
    int End;
  };
  /// The rows of a cell that are looked at: of large cells, the middle rows stand for all.
  Rows GetRows(int cell, std::size_t axis) const;
  /// Where the centre of a cell lies in the volume, 0 to 1 along an axis.
  double GetPlace(int cell, std::size_t axis) const;
  /// Cells from the centre of the outermost cell to the face of the volume; below 0 where the
  /// centre of an incomplete cell is outside.
  double GetMargin(std::size_t axis, bool high) const;
  /// The volume's texture coordinates times these are those of a texture of the cells.
  std::array<float, 3> GetTextureScale() const;
};

#endif
