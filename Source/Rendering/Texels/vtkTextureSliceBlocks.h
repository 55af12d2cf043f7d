// SPDX-License-Identifier: BSD-3-Clause
// Where a volume differs from another one.
#ifndef vtkTextureSliceBlocks_h
#define vtkTextureSliceBlocks_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceScalars.h"

#include <array>
#include <cstdint>
#include <vector>

/**
 * A volume cut into blocks of 8 x 8 x 8 texels (the last ones along an axis may be shorter), and
 * for each a checksum of 64 bits of its scalars and its hidden texels. A change of one scalar
 * always changes the checksum; that two different blocks have the same by chance has a probability
 * of 2 to the power of -64.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceBlocks
{
public:
  static constexpr int Edge = 8;

  /// Texels from Begin to before End along each axis.
  struct Box
  {
    std::array<int, 3> Begin;
    std::array<int, 3> End;
  };

  /// Goes once over all scalars, on several threads.
  void Build(const vtkTextureSliceScalars& source);

  /// Boxes that do not overlap, at most 8 texels high, and hold all texels that differ from those
  /// of another volume of the same size and type; all texels where that is nullptr.
  std::vector<Box> FindChanges(const vtkTextureSliceBlocks* other) const;

private:
  /// The box of the blocks from `first` to `last` of a row of blocks.
  Box GetBox(int first, int last, int y, int z) const;

  std::array<int, 3> Size{};  ///< texels along each axis
  std::array<int, 3> Count{}; ///< blocks along each axis
  std::vector<std::uint64_t> Checksums;
};

#endif
