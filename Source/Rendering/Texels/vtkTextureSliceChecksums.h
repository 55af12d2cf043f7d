// SPDX-License-Identifier: BSD-3-Clause
// What has to be known of a volume's scalars before they are uploaded.
#ifndef vtkTextureSliceChecksums_h
#define vtkTextureSliceChecksums_h

#include "vtkObject.h"
#include "vtkSmartPointer.h"
#include "vtkTextureSliceBricks.h"
#include "vtkTextureSliceScalars.h"
#include "vtkTextureSliceTexels.h"

#include <optional>
#include <tuple>

class vtkInformationObjectBaseKey;

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

#endif
