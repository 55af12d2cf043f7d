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
#include <tuple>
#include <vector>

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

  void Build(
    const vtkTextureSliceLightCells::Source& source, const Lights& lights, std::size_t mostCells);

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
