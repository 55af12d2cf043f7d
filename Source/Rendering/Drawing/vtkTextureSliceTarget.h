// SPDX-License-Identifier: BSD-3-Clause
// A floating-point picture in which the slices are blended before the window sees them.
#ifndef vtkTextureSliceTarget_h
#define vtkTextureSliceTarget_h

#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceFeatures.h"

#include <array>
#include <functional>
#include <memory>
#include <string>

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkShaderProgram;
class vtkWindow;

/**
 * As large as the renderer's viewport, or coarser or finer: RGBA of 32-bit floats with associated
 * colour (Formulas R3), and the depth of the opaque geometry that the window holds already. 16-bit
 * floats would stop counting: at an opacity of one half, a slice that adds less than 1/4096 adds
 * nothing.
 */
class vtkTextureSliceTarget
{
public:
  vtkTextureSliceTarget();
  ~vtkTextureSliceTarget();

  /// Width and height of the picture for a renderer's viewport; see Begin.
  static std::array<int, 2> GetSize(vtkRenderer* renderer, double pixelSize);

  /**
   * Copies the depth of the framebuffer that is bound, clears all channels of the colour to one
   * value and directs drawing here. End must follow.
   * @param pixelSize pixels of the viewport that one pixel of the picture stands for along an axis.
   * @return false, with one line in @a error, if
   * it cannot be made; then End must not follow.
   */
  bool Begin(vtkRenderer* renderer, float clearValue, double pixelSize, std::string& error);
  ///@{
  /**
   * Between Begin and End: directs drawing to the depth alone, so that the picture can be read, and
   * back to both.
   */
  void BeginDepthOnly();
  void EndDepthOnly();
  ///@}
  /// Between Begin and End: keeps the depth as it is now for GetGeometryDepth.
  bool KeepDepth(std::string& error);
  /// The depth of what is drawn already, of the picture's size: a texture that may be read while
  /// drawing.
  vtkTextureObject* GetGeometryDepth() { return this->GeometryDepth; }
  vtkTextureObject* GetPicture() { return this->Color; }
  /// Directs drawing back to where it went before Begin.
  void End();

  /**
   * Blends the picture over the renderer's viewport.
   * @param smooth whether to interpolate between its pixels if it has another size.
   * @param features what TextureSliceCompositeFS must be able to do.
   * @param setUniforms sets what that shader reads besides the picture.
   */
  void Composite(vtkRenderer* renderer, bool smooth, const vtkTextureSliceFeatures& features,
    const std::function<void(vtkShaderProgram*)>& setUniforms);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct DepthFormat;
  static DepthFormat QueryDepthFormat();
  /// Pixels.
  struct Size
  {
    unsigned int Width = 0;
    unsigned int Height = 0;
  };
  static bool HasSize(vtkTextureObject* texture, vtkOpenGLRenderWindow* window, const Size& size);
  static bool AllocateDepth(vtkTextureObject* texture, vtkOpenGLRenderWindow* window,
    const Size& size, const DepthFormat& format);
  bool Resize(vtkOpenGLRenderWindow* window, const Size& size, const DepthFormat& format);
  bool Attach(vtkOpenGLRenderWindow* window, std::string& error);
  bool CopyDepth(vtkOpenGLRenderWindow* window, unsigned int source,
    const std::array<int, 4>& viewport, const DepthFormat& format);

  vtkNew<vtkOpenGLFramebufferObject> Framebuffer;
  vtkNew<vtkOpenGLFramebufferObject> DepthFramebuffer;
  vtkNew<vtkTextureObject> Color;
  vtkNew<vtkTextureObject> Depth;
  vtkNew<vtkTextureObject> GeometryDepth;
  vtkNew<vtkOpenGLFramebufferObject> ResolveFramebuffer;
  vtkNew<vtkTextureObject> ResolvedDepth; ///< the viewport's, for a picture of another size
  void ReadyQuad(vtkOpenGLRenderWindow* window, const vtkTextureSliceFeatures& features);

  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::string QuadDefines; ///< those that Quad was compiled with
  vtkOpenGLRenderWindow* Window = nullptr;
  int DepthKey = -1; ///< the depth format that Depth has
};

#endif
