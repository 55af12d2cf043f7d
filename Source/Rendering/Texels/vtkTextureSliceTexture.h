// SPDX-License-Identifier: BSD-3-Clause
// The scalars of a volume, and flags that hide parts of it, as 3-D textures.
#ifndef vtkTextureSliceTexture_h
#define vtkTextureSliceTexture_h

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceChecksums.h"
#include "vtkTextureSliceTexels.h"

#include <array>
#include <string>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * One to four components of scalars of any type, one texel for each point (or cell), as
 * vtkTextureSliceTexels encodes them. Of scalars that take the place of others of the same size and
 * type, only the blocks that differ are uploaded.
 *
 * Points (or cells) that vtkGhostType marks with any flag and those with a scalar that is not
 * finite are masked: the texture then has one more component, 1 at visible points and 0 at hidden
 * ones, where the others are 0 as well. OpenGL's textures have four components at most, so four
 * components of scalars cannot be masked.
 */
class vtkTextureSliceTexture
{
public:
  /**
   * Uploads the scalars if they, the ghost array, the dimensions or the window changed.
   * @param nearest whether scalars are not interpolated.
   * @return false, with one line in @a error, if the volume does not fit.
   */
  bool Update(vtkOpenGLRenderWindow* window, const vtkTextureSliceScalars& source, bool nearest,
    std::string& error);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  /// The scalars' ranges in small parts of the volume; after an Update without error.
  const vtkTextureSliceBricks& GetBricks() const { return this->Checksum->GetBricks(); }
  /// Whether the component of the mask is there.
  bool IsMasked() const { return this->Texels.IsMasked(); }
  /// How a texel t (0 to 1 unless float) of each component becomes its scalar.
  const std::vector<vtkTextureSliceComponent>& GetComponents() const
  {
    return this->Texels.GetComponents();
  }

private:
  bool Allocate(vtkOpenGLRenderWindow* window, const std::array<int, 3>& size, std::string& error);
  void Upload(vtkOpenGLRenderWindow* window, const vtkTextureSliceChanges& changes);

  vtkNew<vtkTextureObject> Texture;
  vtkTextureSliceTexels Texels;
  /// Of what is in the texture; nullptr: not known.
  vtkSmartPointer<vtkTextureSliceChecksums> Checksum;
  vtkTextureSliceChecksums::Key Last;
  std::array<int, 4> Allocated{}; ///< size and internal format
};

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
