// SPDX-License-Identifier: BSD-3-Clause
// The scalars of a volume, and flags that hide parts of it, as 3-D textures.
#ifndef vtkTextureSliceTexture_h
#define vtkTextureSliceTexture_h

#include "vtkNew.h"
#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureObject.h"
#include "vtkTextureSlicePages.h"
#include "vtkTextureSliceScalars.h"
#include "vtkTextureSliceTexels.h"

#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

class vtkInformationObjectBaseKey;
class vtkOpenGLRenderWindow;

/// How scalars become texels, their bricks and the checksums of their blocks: 2 MB at 256 x 256 x
/// 128. Making one takes a look at all scalars, without OpenGL, and can be done on another thread,
/// before the scalars are handed to the mapper; then it stays with the array (in its information).
class vtkTextureSliceChecksums : public vtkObject
{
public:
  static vtkTextureSliceChecksums* New();
  vtkTypeMacro(vtkTextureSliceChecksums, vtkObject);

  /// All that a checksum is made from; pointers are compared, never followed.
  using Key = std::tuple<const void*, vtkMTimeType, const void*, vtkMTimeType, std::array<int, 3>,
    bool, std::optional<vtkTextureSliceCodes>, std::array<std::vector<double>, 3>>;
  static Key MakeKey(const vtkTextureSliceScalars& source);

  /// Makes the checksum and leaves it with the array. With that of the scalars that are expected to
  /// be in the texture before, the texels that change are encoded as well, until TakeChanges.
  static vtkSmartPointer<vtkTextureSliceChecksums> Prepare(
    const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before);
  /// The checksum that was prepared, if nothing has changed since, or a new one.
  static vtkSmartPointer<vtkTextureSliceChecksums> Get(const vtkTextureSliceScalars& source);

  /// What has to be uploaded over a texture that holds `before`; nullptr: that is not known.
  vtkTextureSliceChanges TakeChanges(
    const vtkTextureSliceScalars& source, const vtkTextureSliceChecksums* before);

  vtkTextureSliceTexels Texels; ///< how the scalars become them
  vtkTextureSliceBricks Bricks;

protected:
  vtkTextureSliceChecksums() = default;
  ~vtkTextureSliceChecksums() override = default;

private:
  vtkTextureSliceChecksums(const vtkTextureSliceChecksums&) = delete;
  void operator=(const vtkTextureSliceChecksums&) = delete;

  /// Where it is kept in an array's information.
  static vtkInformationObjectBaseKey* PREPARED();
  static vtkSmartPointer<vtkTextureSliceChecksums> Make(const vtkTextureSliceScalars& source);

  Key Made;
  vtkTextureSliceBlocks Blocks;
  Key PreparedOver; ///< what Prepared has to be uploaded over
  std::optional<vtkTextureSliceChanges> Prepared;
};

/// One to four components of scalars, one texel for each point (or cell), as vtkTextureSliceTexels
/// encodes them. Of scalars that take the place of others of the same size and type, only the
/// blocks that differ are uploaded. Four components cannot be masked, because texels have four at
/// most. A volume that is larger than a texture, or than the memory that is given to it and equal
/// in large parts, is stored in pages.
class vtkTextureSliceTexture
{
public:
  /// Uploads the scalars if they, the ghost array, the dimensions or the window changed.
  /// @param mostBytes of texture memory, above which pages are used where they take less; 0: the
  /// volume is never stored in pages
  /// @return why the volume does not fit, in one line; or nothing
  std::string Update(vtkOpenGLRenderWindow* window, const vtkTextureSliceScalars& source,
    bool nearest, std::size_t mostBytes = 0);

  vtkTextureObject* GetTexture() const { return this->Texture; }
  bool IsPaged() const { return this->Paged; }
  const vtkTextureSlicePages& GetPages() const { return this->Pages; }
  /// Bytes of the texture; 0 before an Update.
  std::size_t CountBytes() const;
  /// The scalars' ranges in small parts of the volume; after an Update without error.
  const vtkTextureSliceBricks& GetBricks() const { return this->Checksum->Bricks; }
  bool IsMasked() const { return this->Texels.Masked; }
  /// How a texel t (0 to 1 unless float) of each component becomes its scalar.
  const std::vector<vtkTextureSliceComponent>& GetComponents() const
  {
    return this->Texels.Components;
  }

private:
  /// Whether the volume is stored in pages, which are built then; with `error` in one line where it
  /// does not fit either way.
  bool TryPages(vtkOpenGLRenderWindow* window, const vtkTextureSliceScalars& source,
    const vtkTextureSliceBricks& bricks, std::string& error);
  std::string Allocate(vtkOpenGLRenderWindow* window, const std::array<int, 3>& size);
  void Upload(vtkOpenGLRenderWindow* window, const vtkTextureSliceChanges& changes);

  vtkNew<vtkTextureObject> Texture;
  bool Paged = false;
  vtkTextureSlicePages Pages;
  std::size_t MostBytes = 0;
  vtkTextureSliceTexels Texels;
  /// Of what is in the texture; nullptr: not known.
  vtkSmartPointer<vtkTextureSliceChecksums> Checksum;
  vtkTextureSliceChecksums::Key Last;
  std::array<int, 4> Allocated{}; ///< size and internal format
};

#endif
