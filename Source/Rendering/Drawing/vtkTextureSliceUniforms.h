// SPDX-License-Identifier: BSD-3-Clause
// Everything that the shaders of the slices read in one frame.
#ifndef vtkTextureSliceUniforms_h
#define vtkTextureSliceUniforms_h

#include "vtkTextureSliceFeatures.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

class vtkShaderProgram;
class vtkTextureObject;
class vtkTextureSliceFrame;
class vtkTextureSlicePlanes;

/// How one component is coloured.
struct vtkTextureSliceSurface
{
  float InverseUnitDistance = 1.0f; ///< one over the data length that its opacity stands for
  float Weight = 1.0f;
  /// How much of a light it returns: vtkVolumeProperty's ambient, diffuse, specular and specular
  /// power.
  std::array<float, 4> Material{};
};

/// Everything the shaders read in one frame.
struct vtkTextureSliceUniforms
{
  vtkTextureSliceFeatures Features;
  const vtkTextureSliceFrame* Frame = nullptr;
  const vtkTextureSlicePlanes* Planes = nullptr;
  /// The part of the box with something to see: lower x, upper x, lower y and so on.
  std::array<double, 6> Seen{0, 1, 0, 1, 0, 1};
  double PixelSize = 1.0;                       ///< pixels of the viewport for one of the picture
  std::vector<vtkTextureSliceSurface> Surfaces; ///< one for each component
  vtkTextureObject* Volume = nullptr;
  std::array<float, 3> SelectionColor{}; ///< used if Features.Selection
  /// The textures that the features need, and the names of their samplers.
  std::vector<std::pair<const char*, vtkTextureObject*>> Textures;
  /// Sets what the parts of the mapper know, beside the textures.
  std::function<void(vtkShaderProgram*)> SetParts;

  /// Draws with a shader that is ready, which gets everything that it reads.
  void Use(vtkShaderProgram* program, const std::function<void()>& draw) const;
};

#endif
