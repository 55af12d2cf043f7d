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
 * is opaque. All pixels that it is asked about begin and end between cells.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceOpaqueCells
{
public:
  static constexpr int CellSize = 8;

  /**
   * @param size width and height of the picture; it may be asked beyond, up to the next multiple of
   * 64 pixels.
   * @param needed dense slices that make a pixel opaque.
   */
  vtkTextureSliceOpaqueCells(const std::array<int, 2>& size, int needed);

  /// Counts one more dense slice that covers all these pixels.
  void AddLayer(const vtkTextureSlicePixels& pixels);
  /// Whether all of these cells are opaque.
  bool AreAllOpaque(const vtkTextureSlicePixels& pixels) const;
  /// Whether one of these cells is opaque.
  bool IsAnyOpaque(const vtkTextureSlicePixels& pixels) const;

private:
  template <typename Visit>
  void ForEach(const vtkTextureSlicePixels& pixels, Visit visit) const;

  int Needed;
  std::size_t Columns;
  bool Any = false;
  std::vector<int> Layers;
};

#endif
