// SPDX-License-Identifier: BSD-3-Clause
// The parts of one slice in which there is something to see, as tiles of pixels.
#ifndef vtkTextureSliceTiles_h
#define vtkTextureSliceTiles_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceOccupancy.h"
#include "vtkTextureSliceOpaqueCells.h"
#include "vtkTextureSlicePolygon.h"

#include <array>
#include <vector>

/// A slice as the window sees it. Pixels are counted from the lower left corner of the picture;
/// pixel (x, y) is the square from there to (x + 1, y + 1).
struct vtkTextureSliceOnScreen
{
  vtkTextureSlice::Polygon Outline; ///< x and y in pixels, z is 0
  vtkTextureSlice::Vector Origin{}; ///< box coordinates of the pixel coordinates' origin
  vtkTextureSlice::Vector Right{};  ///< box coordinates a pixel to the right
  vtkTextureSlice::Vector Up{};     ///< box coordinates a pixel upwards
};

/// What hides what is behind it.
struct vtkTextureSliceDensity
{
  /// Bricks whose samples are dense; nullptr: none.
  const vtkTextureSliceOccupancy* Bricks = nullptr;
  int SlicesNeeded = 1; ///< dense samples that make a pixel opaque
};

/**
 * Divides a slice into squares of pixels, larger ones into smaller ones where they are visible in
 * part, and keeps those that touch visible bricks. Seams lie between pixels, never on a pixel's
 * centre: each pixel is drawn once, however the squares meet. Slices must come nearest first; where
 * dense ones have made the picture opaque, squares are left out.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceTiles
{
public:
  vtkTextureSliceTiles(const vtkTextureSliceOccupancy& occupancy,
    const std::array<int, 2>& viewport, const vtkTextureSliceDensity& density = {});

  /// The visible parts of a slice, convex polygons in pixels; valid until the next call.
  const std::vector<vtkTextureSlice::Polygon>& Cover(const vtkTextureSliceOnScreen& slice);

private:
  using Rectangle = vtkTextureSlicePixels;
  using Share = vtkTextureSliceOccupancy::Share;

  Rectangle FindTiles() const;
  Share Find(const vtkTextureSliceOccupancy& occupancy, const Rectangle& tile) const;
  void CoverRow(int bottom, int left, int right);
  /// Adds the visible parts of a tile. @return whether all of it is to be drawn; it is not added
  /// then
  bool Divide(const Rectangle& tile);
  void Add(const Rectangle& rectangle);

  /// Counts the dense samples of a tile.
  void Thicken(const Rectangle& tile);

  const vtkTextureSliceOccupancy& Occupancy;
  std::array<int, 2> Viewport;
  vtkTextureSliceDensity Density;
  vtkTextureSliceOpaqueCells Opaque;
  const vtkTextureSliceOnScreen* Slice = nullptr;
  std::vector<vtkTextureSlice::Plane> Sides; ///< of the slice's outline
  std::vector<vtkTextureSlice::Polygon> Parts;
  vtkTextureSlice::Polygon Kept;
};

#endif
