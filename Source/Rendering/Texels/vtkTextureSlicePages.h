// SPDX-License-Identifier: BSD-3-Clause
// The texels of a large volume, of which equal parts are stored once.
#ifndef vtkTextureSlicePages_h
#define vtkTextureSlicePages_h

#include "vtkNew.h"
#include "vtkTextureObject.h"
#include "vtkTextureSliceTexels.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

/// A volume cut into pages of about 17 texels along each axis, which stand side by side in one
/// texture, the atlas; a table has the place of each. Pages in which all texels are equal or all
/// are hidden share one place. Two neighbours share the texels of the face between them, so that a
/// sample lies between texels of one page: it has the value that it has in a texture of the whole
/// volume.
class vtkTextureSlicePages
{
public:
  using Box = vtkTextureSliceBlocks::Box;
  /// Bytes of a volume's texture above which pages are looked for, unless a mapper says another
  /// number.
  static constexpr std::size_t UsualMemory = std::size_t(256) << 20;

  /// Finds the pages.
  /// @param size texels of the volume along each axis
  /// @param bricks of the same volume, which must not be a rectilinear grid
  /// @param most texels that a texture can have along an axis
  /// @return false where the atlas would have more
  bool Build(const std::array<int, 3>& size, const vtkTextureSliceBricks& bricks, int most);

  /// Texels of the atlas along each axis.
  const std::array<int, 3>& GetAtlasSize() const { return this->AtlasSize; }
  /// The texels of the volume that each page of the atlas has.
  const std::vector<Box>& GetBoxes() const { return this->Boxes; }
  /// The first texel of each of them in the atlas.
  const std::vector<std::array<int, 3>>& GetPlaces() const { return this->Places; }

  /// Makes the table a texture.
  void Upload(vtkOpenGLRenderWindow* window);
  vtkTextureObject* GetTable() const { return this->Table; }
  void SetUniforms(vtkShaderProgram* program) const;

private:
  /// Places of the atlas, counted in pages; red, green and blue of the table's texels.
  using Entry = std::array<unsigned char, 4>;

  void Divide(const std::array<int, 3>& size, int intervalsOfBrick);
  /// As vtkTextureSliceBricks::FindScalars, of a page.
  std::optional<std::vector<double>> FindScalars(
    const std::array<int, 3>& page, const vtkTextureSliceBricks& bricks) const;
  /// The texels of a page.
  Box BoxOf(const std::array<int, 3>& page) const;
  /// Chooses the size of the atlas, and where its pages stand; `numbers`: of each page of the
  /// volume, which one of the atlas it is. False where an axis has more than `most` texels.
  bool Place(const std::vector<int>& numbers, int most);

  std::array<int, 3> Size{1, 1, 1};      ///< texels of the volume
  std::array<int, 3> Intervals{1, 1, 1}; ///< between the first texels of two pages
  std::array<int, 3> Texels{1, 1, 1};    ///< of a page
  std::array<int, 3> Count{1, 1, 1};     ///< pages of the volume
  std::array<int, 3> AtlasSize{1, 1, 1};
  int BricksOfPage = 1; ///< along an axis
  std::vector<Box> Boxes;
  std::vector<std::array<int, 3>> Places;
  std::vector<Entry> Entries; ///< for each page, x fastest
  vtkNew<vtkTextureObject> Table;
};

#endif
