// SPDX-License-Identifier: BSD-3-Clause
// How much light arrives in each part of a volume: from one light, and from the sky.
#ifndef vtkTextureSliceLightVolume_h
#define vtkTextureSliceLightVolume_h

#include "vtkFloatArray.h"
#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkSmartPointer.h"
#include "vtkTextureSliceLightCells.h"

#include <array>
#include <cstddef>
#include <functional>
#include <tuple>
#include <vector>

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
  static bool SweepOnProcessor(
    const vtkTextureSliceLightCells& cells, const Courses& courses, std::vector<float>& sums);

  /// @param sweep where it cannot, the processor does it
  void Build(const vtkTextureSliceLightCells& cells, const Lights& lights,
    const Sweep& sweep = SweepOnProcessor);

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
