// SPDX-License-Identifier: BSD-3-Clause
// The cells in which the light of a volume is computed, and what light meets in them.
#ifndef vtkTextureSliceLightCells_h
#define vtkTextureSliceLightCells_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceScalars.h"

#include <array>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

/// A volume cut into cells of whole voxels, as near to cubes as they can be. Lengths are data
/// lengths: those of the volume before its actor's matrix.
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

  /// @param more than there are along each axis
  std::size_t CountCells(int more = 0) const;
  /// The rows of a cell that are looked at, and their end: of large cells, the middle ones.
  std::array<int, 2> GetRows(int cell, std::size_t axis) const;
  /// Where the centre of a cell lies in the volume, 0 to 1 along an axis.
  double GetPlace(int cell, std::size_t axis) const;
  /// Cells from the centre of the outermost cell to the face of the volume; below 0: outside of it.
  double GetMargin(std::size_t axis, bool high) const;
  /// The volume's texture coordinates times these are those of a texture of the cells.
  std::array<float, 3> GetTextureScale() const;
};

/// What cropping and clipping leave of the volume, in box coordinates.
struct VTKNEXRADRENDERING_EXPORT vtkTextureSliceCut
{
  std::array<double, 6> Part{0, 1, 0, 1, 0, 1};   ///< lower x, upper x, lower y and so on
  std::vector<std::array<double, 4>> Planes = {}; ///< a*x + b*y + c*z + d < 0 is cut away
  std::array<double, 3> CropLow{};                ///< the planes between 27 regions
  std::array<double, 3> CropHigh{};
  int CropFlags = -1; ///< one bit for each region that is left; -1: the part is all that is left

  bool Leaves(const std::array<double, 3>& at) const;
  bool operator==(const vtkTextureSliceCut& other) const
  {
    return std::tie(this->Part, this->Planes, this->CropLow, this->CropHigh, this->CropFlags) ==
           std::tie(other.Part, other.Planes, other.CropLow, other.CropHigh, other.CropFlags);
  }
};

/// The extinction of each cell of a grid (Formulas L2: -ln(1 - opacity) over a length): the mean of
/// its voxels', which the transfer functions give. Voxels that are hidden, not finite or left out
/// by a mask let all light through. With isosurfaces, the mean scalar of its visible voxels; not a
/// number where fewer than half of them are visible: no surface has an end there.
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceLightCells
{
public:
  /// The extinction of a data length over the scalars of one component.
  struct Function
  {
    std::size_t Component = 0;
    /// Scalars of the first and the last entry.
    std::array<double, 2> Range{0.0, 1.0};
    std::vector<float> Entries;

    bool operator==(const Function& other) const
    {
      return std::tie(this->Component, this->Range, this->Entries) ==
             std::tie(other.Component, other.Range, other.Entries);
    }
  };

  /// The value of an isosurface, and the optical depth of crossing it: -ln(1 - opacity).
  using Surface = std::pair<float, float>;

  /// What the cells are made from.
  struct Source
  {
    vtkTextureSliceScalars Scalars;
    /// Whether a voxel may be hidden or not finite.
    bool Masked = false;
    /// One value a voxel; nullptr: there is no mask.
    const unsigned char* Mask = nullptr;
    /// The functions of each value of the mask; greater values have those of the last one, voxels
    /// without a mask those of the first. A voxel's extinction is the sum of theirs.
    std::vector<std::vector<Function>> Functions;
    /// In place of functions: isosurfaces of one component. Where the mask is 0, a voxel is hidden.
    std::vector<Surface> Surfaces;
    std::size_t Component = 0;
    /// Data length of each edge of a voxel.
    std::array<double, 3> VoxelEdge{1, 1, 1};
    std::optional<vtkTextureSliceCut> Left = {}; ///< nothing: the whole volume

    /// Whether all but the contents of scalars and mask is the same.
    bool IsLike(const Source& other) const
    {
      return std::tie(this->Functions, this->Surfaces, this->VoxelEdge, this->Left) ==
             std::tie(other.Functions, other.Surfaces, other.VoxelEdge, other.Left);
    }
  };

  /// Goes over the voxels, on several threads. Of large cells, the middle rows stand for all.
  vtkTextureSliceLightCells(const Source& source, std::size_t mostCells);

  const vtkTextureSliceLightGrid& GetGrid() const { return this->Grid; }
  const std::vector<Surface>& GetSurfaces() const { return this->Surfaces; }
  /// One for each cell, x varying fastest.
  const std::vector<float>& GetValues() const { return this->Values; }

private:
  vtkTextureSliceLightGrid Grid;
  std::vector<Surface> Surfaces;
  std::vector<float> Values;
};

#endif
