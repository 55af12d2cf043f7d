// SPDX-License-Identifier: BSD-3-Clause
// Draws the volume: for each pixel, one fragment or one invocation of a compute shader goes along
// its ray.
#ifndef vtkTextureSliceMarch_h
#define vtkTextureSliceMarch_h

#include "vtkTextureSliceBox.h"
#include "vtkTextureSliceCompute.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;
struct vtkTextureSliceUniforms;

class vtkTextureSliceMarch
{
public:
  /// @return false if the shaders do not compile
  bool ReadyFragments(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  bool ReadyCompute(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  /// Draws into the framebuffer that is bound; after ReadyFragments.
  void DrawFragments(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  /// Stores into a picture of 16-bit floats; after ReadyCompute.
  void DrawCompute(const vtkTextureSliceUniforms& uniforms, vtkTextureObject* picture);
  void ReleaseGraphicsResources(vtkOpenGLRenderWindow* window);

private:
  vtkTextureSliceBox Box;
  vtkTextureSliceCompute Compute;
  vtkShaderProgram* Program = nullptr; ///< that is ready
};

#endif
