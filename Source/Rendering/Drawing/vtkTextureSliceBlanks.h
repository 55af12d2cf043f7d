// SPDX-License-Identifier: BSD-3-Clause
// Ghost flags of the cells about scalars of the points, or of the points about scalars of the
// cells.
#ifndef vtkTextureSliceBlanks_h
#define vtkTextureSliceBlanks_h

#include "vtkTextureSliceTexture.h"

#include <array>
#include <string>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * A sample is left out where the cell that it lies in, or the point that is nearest to it, has a
 * flag. Flags that belong to the scalars themselves are part of vtkTextureSliceTexture.
 */
class vtkTextureSliceBlanks
{
public:
  /**
   * Uploads the flags if they or the window changed.
   * @param cellData whether the scalars are those of cells.
   * @return false, with one line in @a error, if they do not fit a texture.
   */
  bool Update(
    vtkOpenGLRenderWindow* window, vtkImageData* image, bool cellData, std::string& error);
  /// Whether there is a flag that hides something.
  bool IsUsed() const { return this->Used; }
  vtkTextureObject* GetTexture() const { return this->Texture.GetTexture(); }
  void SetUniforms(vtkShaderProgram* program) const;

private:
  vtkTextureSliceTexture Texture;
  bool Used = false;
  /// From texture coordinates of the scalars to those of the flags.
  std::array<float, 3> Scale{};
  std::array<float, 3> Bias{};
};

#endif
