// SPDX-License-Identifier: BSD-3-Clause
// The lights of a renderer, as the shader reads them.
#ifndef vtkTextureSliceLights_h
#define vtkTextureSliceLights_h

#include <array>
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
  using Vector = std::array<float, 3>;

  void Append(vtkRenderer* renderer, vtkLight* light);

  bool OnlyHeadlight = false;
  bool TwoSided = true;
  Vector Ambient{}; ///< of all lights
  std::vector<Vector> Diffuse;
  std::vector<Vector> Specular;
  std::vector<Vector> Direction; ///< in camera coordinates
  std::vector<Vector> Position;  ///< in camera coordinates
  std::vector<Vector> Attenuation;
  std::vector<Vector> Cone; ///< whether it has a position, cosine of the cone or -2, exponent
};

#endif
