// SPDX-License-Identifier: BSD-3-Clause
// Scalars as texels, their ranges in each small part of a volume, and where it differs from another
// one.
#ifndef vtkTextureSliceTexels_h
#define vtkTextureSliceTexels_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceScalars.h"
#include "vtkTimeStamp.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

/// A volume cut into small bricks of voxels (those of a rectilinear grid are equal parts of its
/// box), and for each the least and the greatest scalar that a sample inside it can meet: those on
/// its faces, or just outside where cell scalars are interpolated across them, count as well.
/// Points (or cells) that are hidden, or of which a component is not finite, do not count.
struct VTKNEXRADRENDERING_EXPORT vtkTextureSliceBricks
{
  /// Low is above High where there is nothing that counts.
  struct Range
  {
    double Low = std::numeric_limits<double>::infinity();
    double High = -std::numeric_limits<double>::infinity();
  };

  /// Goes once over all scalars, on several threads.
  void Build(const vtkTextureSliceScalars& source);
  /// The scalars of a brick whose texels are all equal: an empty vector where none of them counts,
  /// nothing where they differ.
  std::optional<std::vector<double>> FindScalars(const std::array<int, 3>& brick) const;

  std::array<int, 3> Count{};   ///< along each axis
  std::array<double, 3> Edge{}; ///< in box coordinates (0 to 1 along each axis)
  int Intervals = 1;            ///< between voxels along an edge
  /// One for each component of each brick; the component varies fastest, then x.
  std::vector<Range> Ranges;
  std::vector<unsigned char> Hides; ///< of each brick, 1 where it has texels that do not count
  vtkMTimeType BuildTime = 0;
};

/// A volume cut into blocks of 8 x 8 x 8 texels (the last ones along an axis may be shorter), and
/// for each a checksum of 64 bits of its scalars and its hidden texels. A change of one scalar
/// always changes it.
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

/// One component of the scalars.
struct vtkTextureSliceComponent
{
  std::array<double, 2> Range{0.0, 1.0}; ///< least and greatest visible scalar
  double Scale = 1.0;                    ///< the scalar of a texel t: t * Scale + Bias
  double Bias = 0.0;
};

/// Boxes of a texture, and their texels one after the other, x fastest.
struct vtkTextureSliceChanges
{
  std::vector<vtkTextureSliceBlocks::Box> Boxes;
  std::vector<std::size_t> Begins; ///< of each box in Bytes
  /// Not set to 0 first: the threads that encode are the first to touch it.
  std::unique_ptr<unsigned char[]> Bytes;
};

/// How scalars become texels. Scalars of 8 and 16 bits and floats keep their values; wider types
/// become float, spread over 0 to 1 so that large values keep their differences. Codes become bytes
/// of even steps where their values allow that, else floats. Where some are invisible, each texel
/// has one more component, 1 where it is visible, else 0 as the others are then.
struct vtkTextureSliceTexels
{
  vtkTextureSliceTexels() = default;
  vtkTextureSliceTexels(const vtkTextureSliceScalars& source, const vtkTextureSliceBricks& bricks);

  /// Whether the texels are bytes that stand for the values of codes.
  bool AreCodeBytes() const { return this->Codes && this->Codes->Step > 0.0; }
  /// Of a texel: those of the scalars, and the mask.
  int CountChannels() const
  {
    return static_cast<int>(this->Components.size()) + (this->Masked ? 1 : 0);
  }

  /// Bytes of so many texels along each axis.
  std::size_t CountBytes(const std::array<int, 3>& size) const;

  /// Whether the same scalars become the same texels.
  bool IsLike(const vtkTextureSliceTexels& other) const;

  /// The texels of some boxes, made on several threads.
  vtkTextureSliceChanges Encode(
    const vtkTextureSliceScalars& source, std::vector<vtkTextureSliceBlocks::Box> boxes) const;

  int SourceType = VTK_VOID;
  int ScalarType = VTK_FLOAT; ///< VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT or VTK_FLOAT
  std::array<int, 3> Size{};
  bool Masked = false; ///< whether the component of the mask is there
  std::optional<vtkTextureSliceCodes> Codes;
  std::vector<vtkTextureSliceComponent> Components;

private:
  void EncodeBox(const vtkTextureSliceScalars& source, const vtkTextureSliceBlocks::Box& box,
    unsigned char* texels) const;
};

#endif
