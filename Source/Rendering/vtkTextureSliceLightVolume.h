// SPDX-License-Identifier: BSD-3-Clause
// How much light arrives in each part of a volume: from one light, and from the sky.
#ifndef vtkTextureSliceLightVolume_h
#define vtkTextureSliceLightVolume_h

#include "vtkFloatArray.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkTextureSliceScalars.h"

#include <array>
#include <cstddef>
#include <functional>
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
struct VTKNEXRADRENDERING_EXPORT vtkTextureSliceLightCells
{
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

  vtkTextureSliceLightGrid Grid;
  std::vector<Surface> Surfaces;
  std::vector<float> Values; ///< one for each cell, x varying fastest
};

/// A direction of light as steps from plane to plane of cells, the first one where the light
/// enters. Parallel rays lie at whole places of a raster across the planes: 0 is along the rows, 1
/// from row to row. The cell i of plane p lies at the place i + Slope * p + Offset, at which the
/// same ray crosses all planes. TextureSliceLightCS reads this as it is.
struct vtkTextureSliceLightCourse
{
  std::array<int, 2> Cells;
  std::array<int, 2> Stride; ///< from one cell to the next
  std::array<int, 2> Rays;
  std::array<float, 2> Slope; ///< 0: rays come in by no side
  std::array<float, 2> Offset;
  std::array<float, 2> LowMargin; ///< cells from the centres of the outermost ones to the faces
  std::array<float, 2> HighMargin;
  int Planes;
  int First;       ///< the cell 0, 0 of the first plane
  int PlaneStride; ///< away from the light
  float Step;      ///< length of a ray from plane to plane
  float Margin;    ///< steps from where light enters to the first plane
  float Weight;    ///< of what arrives
};

/// Two components for each cell of a vtkTextureSliceLightGrid, 0 to 1 (all light): the
/// transmittance to the light, and its mean over directions all over the upper half of the sky
/// (Formulas L2). A component that is not asked for is 1 everywhere. It needs no OpenGL.
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceLightVolume
{
public:
  /// Directions of the sky. The shadows of surfaces have edges that a mean of few of them shows.
  static constexpr int SkyDirections = 12;
  static constexpr int SkyDirectionsOfSurfaces = 36;

  /// Where light comes from. Directions are data lengths along the axes of the volume.
  struct Lights
  {
    bool Shadow = false;    ///< whether the first component is asked for
    bool Occlusion = false; ///< whether the second one is
    std::array<double, 3> ToLight{0, 0, 1};
    /// The columns of a matrix from directions about the sky's zenith (0, 0, 1).
    std::array<std::array<double, 3>, 3> Sky{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

    bool operator==(const Lights& other) const
    {
      return std::tie(this->Shadow, this->Occlusion, this->ToLight, this->Sky) ==
             std::tie(other.Shadow, other.Occlusion, other.ToLight, other.Sky);
    }
  };

  using Courses = std::vector<vtkTextureSliceLightCourse>;
  /// Adds to each cell the transmittance from where each direction enters the volume, by weight.
  /// @return false if it cannot and has added nothing
  using Sweep =
    std::function<bool(const vtkTextureSliceLightCells&, const Courses&, std::vector<float>&)>;

  /// @param sweep where it cannot, or is nullptr, the processor does it
  void Build(
    const vtkTextureSliceLightCells& cells, const Lights& lights, const Sweep& sweep = nullptr);

  const vtkTextureSliceLightGrid& GetGrid() const { return this->Grid; }
  /// A new array with each Build.
  vtkFloatArray* GetLight() const { return this->Light; }

  /// Unit directions that are spread evenly over the half of the sky about (0, 0, 1).
  static std::vector<std::array<double, 3>> GetSkyDirections(int count = SkyDirections);

private:
  vtkTextureSliceLightGrid Grid;
  vtkSmartPointer<vtkFloatArray> Light;
};

#endif
