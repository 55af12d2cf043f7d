// SPDX-License-Identifier: BSD-3-Clause
// Scalars as texels.
#ifndef vtkTextureSliceTexels_h
#define vtkTextureSliceTexels_h

#include "vtkTextureSliceBlocks.h"
#include "vtkTextureSliceBricks.h"
#include "vtkTextureSliceScalars.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

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

/**
 * How scalars become texels. Scalars of 8 and 16 bits keep their size and all their values; float
 * stays as it is; wider types become float, spread over 0 to 1 so that large values keep their
 * differences. Codes become bytes of even steps where their values allow that, else float values:
 * what lies between two texels is then what lies between their values. Where some are invisible,
 * each texel has one more component, 1 where it is visible, else 0 as the others are then.
 */
class vtkTextureSliceTexels
{
public:
  vtkTextureSliceTexels() = default;
  vtkTextureSliceTexels(const vtkTextureSliceScalars& source, const vtkTextureSliceBricks& bricks);

  /// VTK_UNSIGNED_CHAR, VTK_UNSIGNED_SHORT or VTK_FLOAT.
  int GetScalarType() const { return this->ScalarType; }
  /// Whether the texels are bytes that stand for the values of codes.
  bool AreCodeBytes() const { return this->Codes && this->Codes->HasBytes(); }
  /// Whether the component of the mask is there.
  bool IsMasked() const { return this->Masked; }
  /// Of a texel: those of the scalars, and the mask.
  int CountChannels() const
  {
    return static_cast<int>(this->Components.size()) + (this->Masked ? 1 : 0);
  }
  const std::vector<vtkTextureSliceComponent>& GetComponents() const { return this->Components; }

  /// Whether the same scalars become the same texels.
  bool IsLike(const vtkTextureSliceTexels& other) const;

  /// The texels of some boxes, made on several threads.
  vtkTextureSliceChanges Encode(
    const vtkTextureSliceScalars& source, std::vector<vtkTextureSliceBlocks::Box> boxes) const;

private:
  void EncodeBox(const vtkTextureSliceScalars& source, const vtkTextureSliceBlocks::Box& box,
    unsigned char* texels) const;

  int SourceType = VTK_VOID;
  int ScalarType = VTK_FLOAT;
  std::array<int, 3> Size{};
  bool Masked = false;
  std::optional<vtkTextureSliceCodes> Codes;
  std::vector<vtkTextureSliceComponent> Components;
};

#endif
