// SPDX-License-Identifier: BSD-3-Clause
// Ends rays early: where the picture is opaque, slices behind are not drawn.
#ifndef vtkTextureSliceOpaquePixels_h
#define vtkTextureSliceOpaquePixels_h

#include "vtkNew.h"

class vtkMatrix4x4;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;

/**
 * Slices are drawn nearest first. After a group of them, the last one is drawn once more into the
 * depth alone: where the picture has become opaque, the nearest depth there is, so that the depth
 * test stops all that follows before its shader runs.
 */
class vtkTextureSliceOpaquePixels
{
public:
  /// What adds less than a quarter of 1/255 to any channel is not seen.
  static constexpr double Opaque = 1.0 - 1.0 / 1024.0;

  vtkTextureSliceOpaquePixels();
  ~vtkTextureSliceOpaquePixels();

  /**
   * Slices in the first group, for the greatest opacity that one sample can have: as many as that
   * needs to become opaque, and so many that looking for opaque pixels costs little beside drawing.
   * @return 0 if the slices cannot become opaque soon enough to be worth it
   */
  static int ChooseGroup(double mostOpacity, int slices);

  /**
   * Marks the opaque pixels. The framebuffer that is bound must have the depth and no colour.
   * @param vertices the slices' vertices; @a first and @a count choose some of them.
   * @param picture the associated colours of all slices so far.
   * @return false if the shader does not compile
   */
  bool Mark(vtkOpenGLRenderWindow* window, vtkOpenGLBufferObject* vertices, int first, int count,
    vtkMatrix4x4* boxToClip, vtkTextureObject* picture);
  /// The window that owns the resources must be current.
  void ReleaseGraphicsResources();

private:
  bool Connect(vtkShaderProgram* program, vtkOpenGLBufferObject* vertices);

  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkShaderProgram* Program = nullptr; ///< of the last Mark; the shader cache owns it
};

#endif
