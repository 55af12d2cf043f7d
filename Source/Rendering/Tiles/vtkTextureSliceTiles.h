// SPDX-License-Identifier: BSD-3-Clause
// The parts of one slice in which there is something to see, as tiles of pixels.
#ifndef vtkTextureSliceTiles_h
#define vtkTextureSliceTiles_h

#include "vtkNexradRenderingModule.h" // for the export macro
#include "vtkTextureSliceOccupancy.h"
#include "vtkTextureSliceOpaqueCells.h"
#include "vtkTextureSlicePolygon.h"

#include <array>
#include <deque>
#include <vector>

/// Where the rays that cross a slice go, from a point p of it to p + t*(Step + Growth*p), t slice
/// distances before (below 0) or after it.
struct vtkTextureSliceSegments
{
  vtkTextureSlice::Vector Step{}; ///< box coordinates
  double Growth = 0.0;
  /// What a pixel shows of its ray beside the slice: that many slice distances before and after it,
  /// and up to a face of the part of the box that is drawn if it is within one slice distance.
  /// 0: nothing on that side.
  std::array<double, 2> Reach{};
  std::array<double, 6> Part{0, 1, 0, 1, 0, 1}; ///< lower x, upper x, lower y and so on
};

/// A slice as the window sees it. Pixels are counted from the lower left corner of the picture;
/// pixel (x, y) is the square from there to (x + 1, y + 1).
struct vtkTextureSliceOnScreen
{
  vtkTextureSlice::Polygon Outline; ///< x and y in pixels, z is 0
  vtkTextureSlice::Vector Origin{}; ///< box coordinates of the pixel coordinates' origin
  vtkTextureSlice::Vector Right{};  ///< box coordinates a pixel to the right
  vtkTextureSlice::Vector Up{};     ///< box coordinates a pixel upwards
  vtkTextureSliceSegments Segments;
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
 * centre: each pixel is drawn once, however the squares meet. Slices must come nearest first and
 * without gaps; where dense ones have made the picture opaque, squares are left out.
 */
class VTKNEXRADRENDERING_EXPORT vtkTextureSliceTiles
{
public:
  /// Edge of the largest squares, in pixels.
  static constexpr int LargestTile = 64;

  /// @param part the pixels of the picture to cover; it begins at a multiple of LargestTile.
  vtkTextureSliceTiles(const vtkTextureSliceOccupancy& occupancy, const vtkTextureSlicePixels& part,
    const vtkTextureSliceDensity& density = {});

  /// The visible parts of a slice, convex polygons in pixels; valid until the next call.
  const std::vector<vtkTextureSlice::Polygon>& Cover(const vtkTextureSliceOnScreen& slice);

  /// How much of a whole slice is visible, as far as the picture shows it.
  static vtkTextureSliceOccupancy::Share FindVisible(const vtkTextureSliceOccupancy& occupancy,
    const vtkTextureSliceOnScreen& slice, const vtkTextureSlicePixels& picture);

private:
  using Rectangle = vtkTextureSlicePixels;
  using Share = vtkTextureSliceOccupancy::Share;

  Share Find(const vtkTextureSliceOccupancy& occupancy, const Rectangle& tile) const;
  void CoverRow(int bottom, int left, int right);
  /// Adds rectangles around the visible parts of a tile. @return what they cost
  double Divide(const Rectangle& tile);
  /// Replaces the rectangles from that index on, which cost so much, by fewer if that is cheaper.
  /// @return what they cost now
  double Simplify(std::size_t begin, double cost);
  void Add(vtkTextureSlice::Polygon part);

  /// Consecutive slices, dense all over a tile of the largest size.
  struct Run
  {
    int Slices = 0;
    int Last = -1; ///< the slice that it ends with
  };
  Run& GetRun(const Rectangle& tile);
  /**
   * Adds what is not hidden of a tile of the largest size, if it has been dense for so long that
   * the outline of an earlier slice tells it.
   * @return whether that is all there is to draw
   */
  bool CutBehindDense(const Rectangle& tile);
  /// Counts the dense samples of a tile of the largest size.
  void CountDense(const Rectangle& tile);
  /// Counts the dense samples of the cells in a tile, of which so much is dense.
  void Thicken(const Rectangle& tile, Share dense);

  const vtkTextureSliceOccupancy& Occupancy;
  Rectangle Part;
  vtkTextureSliceDensity Density;
  vtkTextureSliceOpaqueCells Opaque;
  std::vector<Run> Runs; ///< one for each tile of the largest size
  const vtkTextureSliceOnScreen* Slice = nullptr;
  int SliceNumber = -1;
  std::vector<vtkTextureSlice::Plane> Sides; ///< of the slice's outline
  /// With density: the sides of this slice and of those before it, as many as are needed.
  std::deque<std::vector<vtkTextureSlice::Plane>> LastSides;
  std::vector<Rectangle> Rectangles;
  std::vector<vtkTextureSlice::Polygon> Parts;
  vtkTextureSlice::Polygon Kept;
};

#endif
