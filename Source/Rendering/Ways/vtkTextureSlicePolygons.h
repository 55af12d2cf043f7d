// SPDX-License-Identifier: BSD-3-Clause
// The volume as polygons, one for each plane, which OpenGL blends.
#ifndef vtkTextureSlicePolygons_h
#define vtkTextureSlicePolygons_h

#include "vtkNew.h"

#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
struct vtkTextureSliceFeatures;
struct vtkTextureSliceUniforms;

/**
 * Slices as graphics cards have drawn them since they have textures: what is seen of each plane is
 * a convex polygon, the nearest one is drawn first, and each one is blended behind those before.
 * A fragment is the one sample of its ray on the polygon's plane. This is what the march is
 * compared with, and what is left where its shader does not compile. It draws composite blending of
 * samples alone; all other modes are the march's, whatever way is asked for. Of a ray that is
 * shorter than two slices it has the samples on planes alone, at box faces and edges.
 */
class vtkTextureSlicePolygons
{
public:
  vtkTextureSlicePolygons();
  ~vtkTextureSlicePolygons();

  /// Whether these features are drawn by polygons at all.
  static bool CanDraw(const vtkTextureSliceFeatures& features);
  /// @return false if the shaders do not compile
  bool Ready(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  /// After Ready: draws into the framebuffer that is bound, whose picture has 32-bit floats,
  /// because hundreds of samples are rounded one after the other.
  void Draw(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  void ReleaseGraphicsResources();

private:
  void DrawTriangles(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);

  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkNew<vtkOpenGLBufferObject> Corners;
  vtkShaderProgram* Program = nullptr; ///< the shader cache owns it
  std::string Key;
};

#endif
