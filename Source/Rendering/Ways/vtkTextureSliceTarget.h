// SPDX-License-Identifier: BSD-3-Clause
// The picture of the volume before the window sees it.
#ifndef vtkTextureSliceTarget_h
#define vtkTextureSliceTarget_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceBox.h"

#include <array>
#include <functional>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct vtkTextureSliceUniforms;
class vtkWindow;

/**
 * RGBA of associated colour (Formulas R3), as large as the viewport, or coarser or finer, and a
 * copy of the depth of the opaque geometry that the window holds already.
 */
class vtkTextureSliceTarget
{
public:
  vtkTextureSliceTarget();
  ~vtkTextureSliceTarget();

  /// Width and height of the picture for the viewport that OpenGL draws into now; see Begin.
  static std::array<int, 2> GetSize(vtkOpenGLRenderWindow* window, double pixelSize);

  /**
   * Copies the depth of the framebuffer that is bound, clears the picture and directs drawing here.
   * End must follow.
   * @param pixelSize pixels of the viewport that one pixel of the picture stands for along an axis.
   * @param copiesDepth whether GetGeometryDepth is read.
   * @param fullPrecision whether the picture has floats of 32 bits in place of 16.
   * @return false, with one line in @a error, if it cannot be made; then End must not follow.
   */
  bool Begin(vtkOpenGLRenderWindow* window, double pixelSize, bool copiesDepth, bool fullPrecision,
    std::string& error);
  /// The depth of what is drawn already, of the viewport's size.
  vtkTextureObject* GetGeometryDepth() { return this->Depth; }
  vtkTextureObject* GetPicture() { return this->Color; }
  /// Directs drawing back to where it went before Begin.
  void End();

  /**
   * Blends the picture over the viewport of the last Begin.
   * @param smooth whether to interpolate between its pixels if it has another size.
   * @param setUniforms sets what that shader reads besides the picture.
   */
  void Composite(bool smooth, const vtkTextureSliceUniforms& uniforms,
    const std::function<void(vtkShaderProgram*)>& setUniforms);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  bool MakePicture(int width, int height, bool fullPrecision, std::string& error);
  bool CopyDepth(std::string& error);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  vtkTextureSliceBox Box;
  vtkOpenGLRenderWindow* Window = nullptr;
  std::array<int, 4> Viewport{}; ///< left, bottom, width, height
  bool FullPrecision = false;    ///< of Color
  int DepthKey = -1;             ///< the depth format that Depth has
};

#endif
