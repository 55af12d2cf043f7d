// SPDX-License-Identifier: BSD-3-Clause
// The shader program of the slices and the buffer of their vertices.
#ifndef vtkTextureSliceProgram_h
#define vtkTextureSliceProgram_h

#include "vtkNew.h"

#include <array>

class vtkMatrix4x4;
class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkOpenGLVertexArrayObject;
class vtkShaderProgram;
class vtkTextureObject;
class vtkTextureSliceGeometry;

/// Everything the shaders read in one frame.
struct vtkTextureSliceUniforms
{
  vtkMatrix4x4* BoxToClip = nullptr; ///< column by column
  std::array<float, 3> TextureScale{1, 1, 1};
  std::array<float, 3> TextureBias{0, 0, 0};
  vtkTextureObject* Volume = nullptr;
  bool Masked = false; ///< the volume's second component is its mask
  vtkTextureObject* Table = nullptr;
  double TableScale = 1.0; ///< texel to table coordinate
  double TableBias = 0.0;
  double UnitDistance = 1.0; ///< data length that the table's opacity stands for
  bool CropTest = false;
  std::array<float, 3> CropLow{};
  std::array<float, 3> CropHigh{};
  int CropFlags = 0;
};

class vtkTextureSliceProgram
{
public:
  vtkTextureSliceProgram();
  ~vtkTextureSliceProgram();

  /// Draws all slices in one call. @return false if the shaders do not compile.
  bool Draw(vtkOpenGLRenderWindow* window, const vtkTextureSliceGeometry& geometry,
    const vtkTextureSliceUniforms& uniforms);
  /// The window that owns the resources must be current.
  void ReleaseGraphicsResources();

private:
  vtkShaderProgram* Ready(vtkOpenGLRenderWindow* window, const vtkTextureSliceUniforms& uniforms);
  bool Upload(vtkShaderProgram* program, const vtkTextureSliceGeometry& geometry);

  vtkNew<vtkOpenGLVertexArrayObject> VertexArray;
  vtkNew<vtkOpenGLBufferObject> Vertices;
  vtkShaderProgram* Program = nullptr; ///< of the last Draw; the shader cache owns it
};

#endif
