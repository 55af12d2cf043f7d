// SPDX-License-Identifier: BSD-3-Clause
// The ways to draw the same picture of the volume, and which of them draws it.
#ifndef vtkTextureSliceWays_h
#define vtkTextureSliceWays_h

#include "vtkTextureSliceMarch.h"
#include "vtkTextureSlicePolygons.h"

#include <string>

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
  /// Whether the picture must have 32-bit floats.
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
  bool ReadyCompute(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  bool ReadyFragments(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);

  vtkTextureSliceMarch March;
  vtkTextureSlicePolygons PolygonsOfPlanes;
  Way Asked = Automatic;
  Way Drawn = Automatic;
  std::string Fallback;
  // What failed is not tried again in each frame.
  bool ComputeFails = false;
  bool FragmentsFail = false;
};

#endif
