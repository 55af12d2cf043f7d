// SPDX-License-Identifier: BSD-3-Clause
// A floating-point picture in which the slices are blended before the window sees them.
#ifndef vtkTextureSliceTarget_h
#define vtkTextureSliceTarget_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"

#include <memory>
#include <string>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkWindow;

/**
 * As large as the renderer's viewport: RGBA of 32-bit floats with associated colour (Formulas R3),
 * and the depth of the opaque geometry that the window holds already. 16-bit floats would stop
 * counting: at an opacity of one half, a slice that adds less than 1/4096 adds nothing.
 */
class vtkTextureSliceTarget
{
public:
  vtkTextureSliceTarget();
  ~vtkTextureSliceTarget();

  /**
   * Copies the depth of the framebuffer that is bound, clears the colour and directs drawing here.
   * End must follow. @return false, with one line in @a error, if it cannot be made; then End must
   * not follow.
   */
  bool Begin(vtkRenderer* renderer, std::string& error);
  /// Directs drawing back to where it went before Begin.
  void End();

  /**
   * Blends the picture over the renderer's viewport.
   * @param scale, bias colour c becomes scale * c + bias * opacity (final window and level).
   */
  void Composite(vtkRenderer* renderer, float scale, float bias);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct DepthFormat;
  static DepthFormat QueryDepthFormat();
  bool Resize(vtkOpenGLRenderWindow* window, int width, int height, const DepthFormat& format);

  bool Attach(vtkOpenGLRenderWindow* window, std::string& error);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  vtkOpenGLRenderWindow* Window = nullptr;
  int DepthKey = -1; ///< the depth format that Depth has
};

#endif
