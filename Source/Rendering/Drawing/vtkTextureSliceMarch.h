// SPDX-License-Identifier: BSD-3-Clause
// Draws the volume: one fragment for each pixel goes along its ray.
#ifndef vtkTextureSliceMarch_h
#define vtkTextureSliceMarch_h

#include "vtkTextureSliceBox.h"

class vtkOpenGLRenderWindow;
struct vtkTextureSliceUniforms;

class vtkTextureSliceMarch
{
public:
  /// Draws into the framebuffer that is bound. @return false if the shaders do not compile
  bool Draw(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  void ReleaseGraphicsResources() { this->Box.ReleaseGraphicsResources(); }

private:
  vtkTextureSliceBox Box;
};

#endif
