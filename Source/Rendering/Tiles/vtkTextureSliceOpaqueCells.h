// SPDX-License-Identifier: BSD-3-Clause
// Where a picture is known to be opaque before it is drawn.
#ifndef vtkTextureSliceOpaqueCells_h
#define vtkTextureSliceOpaqueCells_h

#include "vtkNexradRenderingModule.h" // for the export macro

#include <array>
#include <cstddef>
#include <vector>

/// Pixels [Left, Right) x [Bottom, Top).
struct vtkTextureSlicePixels
{
  int Left;
  int Bottom;
  int Right;
  int Top;
};

/**
 * Cells of 8 x 8 pixels, and how many dense slices cover each. A cell that enough of them cover
 * is opaque. It is asked about squares of 8, 16, 32 or 64 pixels, each aligned to its own size as
 * counted from the lower left corner, and answers at once.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceOpaqueCells
{
public:
  static constexpr int CellSize = 8;

  /**
   * @param part the pixels that it may be asked about; beyond, up to the next multiple of 64.
   * @param needed dense slices that make a pixel opaque.
   */
  vtkTextureSliceOpaqueCells(const vtkTextureSlicePixels& part, int needed);

  /// Counts one more dense slice that covers all of a square.
  void AddLayer(const vtkTextureSlicePixels& square);
  /// Whether all cells of a square are opaque.
  bool AreAllOpaque(const vtkTextureSlicePixels& square) const;
  /// Whether one of them is opaque.
  bool IsAnyOpaque(const vtkTextureSlicePixels& square) const;

private:
  static constexpr std::size_t Levels = 4;
  static std::size_t GetLevel(const vtkTextureSlicePixels& square);
  std::size_t GetIndex(std::size_t level, int x, int y) const;

  vtkTextureSlicePixels Part;
  int Needed;
  std::vector<int> Layers;
  /// Opaque cells in each square of 8, 16, 32 and 64 pixels.
  std::array<std::vector<int>, Levels> OpaqueIn;
};

#endif
