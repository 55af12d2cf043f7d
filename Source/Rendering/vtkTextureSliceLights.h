// SPDX-License-Identifier: BSD-3-Clause
// The lights of a renderer, as the shader reads them.
#ifndef vtkTextureSliceLights_h
#define vtkTextureSliceLights_h

#include <array>
#include <map>
#include <vector>

class vtkLight;
class vtkRenderer;
class vtkShaderProgram;
struct vtkTextureSliceFrame;

/**
 * The lights that are switched on. As in VTK's ray caster, a single headlight shines along each ray
 * and is reckoned in data coordinates, everything else in camera coordinates; a headlight's ambient
 * colour is ignored and the sample's own used in its place.
 */
class vtkTextureSliceLights
{
public:
  void Update(vtkRenderer* renderer);
  /// For vtkTextureSliceFeatures: -1 without lights, 0 for a single headlight, else their number.
  int CountForShader() const;
  void SetUniforms(vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const;

private:
  void Append(vtkRenderer* renderer, vtkLight* light);

  int Count = 0;
  bool OnlyHeadlight = false;
  bool TwoSided = true;
  std::array<float, 3> Ambient{}; ///< of all lights
  /// The uniforms that have a vector for each light.
  std::map<const char*, std::vector<std::array<float, 3>>> Vectors;
};

#endif
