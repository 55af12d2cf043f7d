// SPDX-License-Identifier: BSD-3-Clause
// Everything that the shaders of the slices read in one frame.
#ifndef vtkTextureSliceUniforms_h
#define vtkTextureSliceUniforms_h

#include "vtkTextureSliceFeatures.h"

#include <array>
#include <functional>
#include <vector>

class vtkShaderProgram;
class vtkTextureObject;
class vtkTextureSliceBlanks;
class vtkTextureSliceCoordinates;
class vtkTextureSliceDistanceMap;
class vtkTextureSliceFrame;
class vtkTextureSlicePlanes;
class vtkTextureSliceIntegralTable;
class vtkTextureSliceLights;
class vtkTextureSlicePeeling;
class vtkTextureSliceShadows;
class vtkTextureSliceTable;
class vtkTextureSliceTable2D;

/// How much of a light a component returns: vtkVolumeProperty's ambient, diffuse, specular and
/// specular power.
using vtkTextureSliceMaterial = std::array<float, 4>;

/// How one component is coloured.
struct vtkTextureSliceSurface
{
  float InverseUnitDistance = 1.0f; ///< one over the data length that its opacity stands for
  float Weight = 1.0f;
  vtkTextureSliceMaterial Material{};
};

/// Everything the shaders read in one frame.
struct vtkTextureSliceUniforms
{
  vtkTextureSliceFeatures Features;
  const vtkTextureSliceFrame* Frame = nullptr;
  const vtkTextureSlicePlanes* Planes = nullptr;
  /// The part of the box with something to see: lower x, upper x, lower y and so on.
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  const vtkTextureSliceDistanceMap* Distances = nullptr; ///< used if Features.Skipping
  vtkTextureObject* Volume = nullptr;
  /// Texel to 0 to 1 over the range of each component.
  std::array<float, 4> ScalarScale{1, 1, 1, 1};
  std::array<float, 4> ScalarBias{0, 0, 0, 0};
  vtkTextureSliceTable* Table = nullptr;
  const vtkTextureSliceCoordinates* Coordinates = nullptr; ///< used if Features.Rectilinear
  vtkTextureObject* SecondArray = nullptr; ///< used if Features.SecondArray is above 0
  std::array<float, 4> SecondScale{1, 1, 1, 1};
  std::array<float, 4> SecondBias{0, 0, 0, 0};
  vtkTextureSliceTable2D* Table2D = nullptr;              ///< used if Features.Table2D
  vtkTextureSliceBlanks* Blanks = nullptr;                ///< used if Features.Blanked
  vtkTextureObject* Mask = nullptr;                       ///< used if Features.HasMask()
  vtkTextureSliceTable* LabelTable = nullptr;             ///< used if Features.Labels is above 0
  float LabelWeight = 1.0f;                               ///< how much the label's functions count
  vtkTextureSliceIntegralTable* Integrals = nullptr;      ///< used if Features.Slabs
  vtkTextureSliceIntegralTable* LabelIntegrals = nullptr; ///< the same, with labels
  vtkTextureObject* GeometryDepth = nullptr;              ///< used if Features.NeedsDepth()
  const vtkTextureSlicePeeling* Peeling = nullptr;        ///< used if Features.Peel is above 0
  double PixelSize = 1.0;                       ///< pixels of the viewport for one of the picture
  std::vector<vtkTextureSliceSurface> Surfaces; ///< one for each component
  const vtkTextureSliceLights* Lights = nullptr;
  const vtkTextureSliceShadows* Shadows = nullptr; ///< used if Features.Shadows
  int CropFlags = 0;
  std::array<float, 2> AverageRange{0, 1}; ///< 0 to 1 as the scalars are
  std::array<float, 4> ClippedScalars{};   ///< likewise; used if Features.ClippedScalars
  std::vector<float> IsoValues;            ///< ascending, 0 to 1 as the scalars are

  std::array<float, 3> SelectionColor{}; ///< used if Features.Selection

  /// The textures that the features need.
  std::vector<vtkTextureObject*> GetTextures() const;
  /// Draws with a shader that is ready, which gets everything that it reads.
  void Use(vtkShaderProgram* program, const std::function<void()>& draw) const;

private:
  /// The textures must be active.
  void Set(vtkShaderProgram* program) const;
};

#endif
