// SPDX-License-Identifier: BSD-3-Clause
// The ways to draw the same picture of the volume, and which of them draws it.
#ifndef vtkTextureSliceWays_h
#define vtkTextureSliceWays_h

#include "vtkTextureSliceBox.h"
#include "vtkTextureSliceCompute.h"

#include <set>
#include <string>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
struct vtkTextureSliceUniforms;

/**
 * For each pixel, one fragment or one invocation of a compute shader goes along the pixel's ray.
 * Polygons are slices as graphics cards have drawn them since they have textures: the outline of
 * the volume's box once a plane, the nearest plane first, each blended behind those before. A
 * fragment is then the one sample of its ray on that plane. This is what the other ways are
 * compared with, and what is left where their shaders do not compile. Polygons draw composite
 * blending of samples alone; of a ray that is shorter than two slices they have the samples on
 * planes alone.
 */
class vtkTextureSliceWays
{
public:
  /// The values are those of vtkOpenGLTextureSliceVolumeMapper::Ways.
  enum Way
  {
    Automatic, ///< fragments, or compute where it is much faster (vtkTextureSliceTrial)
    Fragments,
    Compute,
    Polygons ///< what they cannot draw is drawn as by Automatic
  };

  /// What the environment variable VTK_TEXTURE_SLICE_WAY names takes precedence.
  void SetAsked(int way) { this->Asked = static_cast<Way>(way); }

  /**
   * Chooses the way of the next picture and makes its shader ready.
   * @return false if there is none whose shaders compile
   */
  bool Choose(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  /// That of the last picture; Automatic: there was none.
  Way GetDrawn() const { return this->Drawn; }
  /// Why the last picture was not drawn as asked for, in one line; or an empty text.
  const std::string& GetFallback() const { return this->Fallback; }
  /// Whether the picture must have 32-bit floats: polygons round hundreds of samples in it, one
  /// after the other.
  bool NeedsFullPrecision() const { return this->Drawn == Polygons; }
  /// After Choose: draws the picture, which is bound.
  void Draw(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms,
    vtkTextureObject* picture);

  void ReleaseGraphicsResources(vtkOpenGLRenderWindow* window);

private:
  Way FindAsked();
  /// What Automatic stands for. The first picture is drawn by fragments where there was no trial
  /// yet, because a trial takes longer than a program with one picture can gain by it.
  Way ChooseByTrial(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  /// @param instead says what draws the volume where the shader of that way does not compile.
  bool Ready(Way way, vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms,
    const char* instead);

  vtkTextureSliceBox Box; ///< of fragments and polygons
  vtkTextureSliceCompute ComputeShaders;
  vtkShaderProgram* Program = nullptr; ///< that is ready
  Way Asked = Automatic;
  Way Drawn = Automatic;
  std::string Fallback;
  std::set<std::string> Failed; ///< shaders that do not compile are not tried in each frame
};

#endif
