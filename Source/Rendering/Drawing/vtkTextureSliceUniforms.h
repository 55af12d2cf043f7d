// SPDX-License-Identifier: BSD-3-Clause
// Everything that the shaders of the slices read in one frame.
#ifndef vtkTextureSliceUniforms_h
#define vtkTextureSliceUniforms_h

#include "vtkTextureSliceBlanks.h"
#include "vtkTextureSliceCoordinates.h"
#include "vtkTextureSliceFeatures.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceIntegralTable.h"
#include "vtkTextureSliceLights.h"
#include "vtkTextureSlicePeeling.h"
#include "vtkTextureSlicePlanes.h"
#include "vtkTextureSliceShadows.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTable2D.h"
#include "vtkTextureSliceTexture.h"

#include <array>
#include <functional>
#include <vector>

class vtkShaderProgram;
class vtkTextureObject;
class vtkTextureSliceDistanceMap;

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

/**
 * Everything the shaders read in one frame: the parts of the mapper that hold it, each of which
 * decides for itself what a change makes it do anew, and what each frame sets anew.
 */
struct vtkTextureSliceUniforms
{
  vtkTextureSliceFrame Frame;
  vtkTextureSlicePlanes Planes;
  vtkTextureSliceTexture Texture;
  vtkTextureSliceTable Table;
  vtkTextureSliceCoordinates Coordinates;      ///< used if Features.Rectilinear
  vtkTextureSliceTexture SecondArray;          ///< used if Features.SecondArray is above 0
  vtkTextureSliceTable2D Table2D;              ///< used if Features.Table2D
  vtkTextureSliceBlanks Blanks;                ///< used if Features.Blanked
  vtkTextureSliceTexture Mask;                 ///< used if Features.HasMask()
  vtkTextureSliceTable LabelTable;             ///< used if Features.Labels is above 0
  vtkTextureSliceIntegralTable Integrals;      ///< used if Features.Slabs
  vtkTextureSliceIntegralTable LabelIntegrals; ///< the same, with labels
  vtkTextureSliceLights Lights;
  vtkTextureSliceShadows Shadows; ///< used if Features.Shadows
  vtkTextureSlicePeeling Peeling; ///< used if Features.Peel is above 0

  vtkTextureSliceFeatures Features;
  /// The part of the box with something to see: lower x, upper x, lower y and so on.
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  const vtkTextureSliceDistanceMap* Distances = nullptr; ///< used if Features.Skipping
  vtkTextureObject* GeometryDepth = nullptr;             ///< used if Features.NeedsDepth()
  double PixelSize = 1.0; ///< pixels of the viewport for one of the picture
  /// Texel to 0 to 1 over the range of each component.
  std::array<float, 4> ScalarScale{};
  std::array<float, 4> ScalarBias{};
  std::array<float, 4> SecondScale{}; ///< the same for the second array
  std::array<float, 4> SecondBias{};
  float LabelWeight = 1.0f;                     ///< how much the label's functions count
  std::vector<vtkTextureSliceSurface> Surfaces; ///< one for each component
  int CropFlags = 0;
  std::array<float, 2> AverageRange{0, 1}; ///< 0 to 1 as the scalars are
  std::array<float, 4> ClippedScalars{};   ///< likewise; used if Features.ClippedScalars
  std::vector<float> IsoValues;            ///< ascending, 0 to 1 as the scalars are
  std::vector<float> Contours;             ///< likewise; used if Features.Contours is above 0
  std::array<float, 3> SelectionColor{};   ///< used if Features.Selection

  /// The textures that the features need.
  std::vector<vtkTextureObject*> GetTextures() const;
  /// Draws with a shader that is ready, which gets everything that it reads.
  void Use(vtkShaderProgram* program, const std::function<void()>& draw) const;

private:
  /// The textures must be active.
  void Set(vtkShaderProgram* program) const;
};

#endif
