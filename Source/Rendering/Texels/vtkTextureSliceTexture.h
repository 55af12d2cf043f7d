// SPDX-License-Identifier: BSD-3-Clause
// The scalars of a volume, and flags that hide parts of it, as 3-D textures.
#ifndef vtkTextureSliceTexture_h
#define vtkTextureSliceTexture_h

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceBricks.h"
#include "vtkTextureSliceScalars.h"
#include "vtkTextureSliceTexels.h"

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

class vtkImageData;
class vtkInformationObjectBaseKey;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/**
 * How scalars become texels, their bricks and the checksums of their blocks. Making one takes a
 * look at all scalars, several times as long as uploading what a time step changes; it needs no
 * OpenGL and can be done on another thread, before the scalars are handed to the mapper. Then it
 * stays with the array (in its information). It takes 16 bytes a brick and 8 a block: 2 MB at 256 x
 * 256 x 128.
 */
class vtkTextureSliceChecksums : public vtkObject
{
public:
  static vtkTextureSliceChecksums* New();
  vtkTypeMacro(vtkTextureSliceChecksums, vtkObject);

  /// All that a checksum is made from; pointers are compared, never followed.
  using Key = std::tuple<const void*, vtkMTimeType, const void*, vtkMTimeType, std::array<int, 3>,
    bool, std::optional<vtkTextureSliceCodes>, std::array<std::vector<double>, 3>>;
  static Key MakeKey(const vtkTextureSliceScalars& source);

  /**
   * Makes the checksum and leaves it with the array, whose size must be that of the source. With
   * the checksum of the scalars that are expected to be in the texture before, the texels that
   * change are encoded as well, to stay until TakeChanges.
   */
  static vtkSmartPointer<vtkTextureSliceChecksums> Prepare(
    const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before);
  /// The checksum that was prepared, if nothing has changed since, or a new one.
  static vtkSmartPointer<vtkTextureSliceChecksums> Get(const vtkTextureSliceScalars& source);

  /// What has to be uploaded over a texture that holds `before`; nullptr: what it holds is not
  /// known. Of what Prepare encoded, this has the last copy.
  vtkTextureSliceChanges TakeChanges(
    const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before);

  /// How the scalars become texels, masked if one is hidden or not finite.
  const vtkTextureSliceTexels& GetTexels() const { return this->Texels; }
  const vtkTextureSliceBricks& GetBricks() const { return this->Bricks; }

protected:
  vtkTextureSliceChecksums() = default;
  ~vtkTextureSliceChecksums() override = default;

private:
  vtkTextureSliceChecksums(const vtkTextureSliceChecksums&) = delete;
  void operator=(const vtkTextureSliceChecksums&) = delete;

  /// Where it is kept in an array's information.
  static vtkInformationObjectBaseKey* PREPARED();
  void Build(const vtkTextureSliceScalars& source);

  Key Made;
  vtkTextureSliceTexels Texels;
  vtkTextureSliceBricks Bricks;
  vtkTextureSliceBlocks Blocks;
  Key PreparedOver; ///< what Prepared has to be uploaded over
  std::optional<vtkTextureSliceChanges> Prepared;
};

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
