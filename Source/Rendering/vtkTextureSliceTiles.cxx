// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceTiles.h"

#include "vtkTextureSliceOccupancy.h"

#include <algorithm>
#include <cmath>

using vtkTextureSlice::ClipPolygon;
using vtkTextureSlice::Evaluate;
using vtkTextureSlice::Plane;
using vtkTextureSlice::Polygon;
using vtkTextureSlice::Vector;
using Share = vtkTextureSliceOccupancy::Share;

namespace
{

// Edges in pixels. Below, the triangles' own cost and the pixels that are shaded twice along their
// diagonals outweigh what they leave out; above, tiles save nothing more.
constexpr int LargestTile = 64;
constexpr int SmallestTile = 8;

/// The half-planes whose intersection is a convex polygon, whichever way round it is given.
void FindSides(const Polygon& outline, std::vector<Plane>& sides)
{
  sides.clear();
  double area = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i)
  {
    const Vector& a = outline[i];
    const Vector& b = outline[(i + 1) % outline.size()];
    area += a[0] * b[1] - a[1] * b[0];
    sides.push_back({a[1] - b[1], b[0] - a[0], 0.0, a[0] * b[1] - a[1] * b[0]});
  }
  if (area < 0.0)
  {
    for (Plane& side : sides)
    {
      side = {-side[0], -side[1], 0.0, -side[3]};
    }
  }
}

std::array<Vector, 4> GetCorners(const vtkTextureSlicePixels& pixels)
{
  const double left = pixels.Left;
  const double bottom = pixels.Bottom;
  const double right = pixels.Right;
  const double top = pixels.Top;
  return {Vector{left, bottom, 0.0}, {right, bottom, 0.0}, {right, top, 0.0}, {left, top, 0.0}};
}

std::array<vtkTextureSlicePixels, 4> GetQuarters(const vtkTextureSlicePixels& tile)
{
  const int middle = (tile.Left + tile.Right) / 2;
  const int level = (tile.Bottom + tile.Top) / 2;
  return {vtkTextureSlicePixels{tile.Left, tile.Bottom, middle, level},
    {middle, tile.Bottom, tile.Right, level}, {tile.Left, level, middle, tile.Top},
    {middle, level, tile.Right, tile.Top}};
}

/// How much of a tile lies within all sides of a convex polygon: Something may be nothing.
Share FindShare(const std::vector<Plane>& sides, const vtkTextureSlicePixels& tile)
{
  const std::array<Vector, 4> corners = GetCorners(tile);
  Share share = Share::Everything;
  for (const Plane& side : sides)
  {
    const auto inside = std::count_if(corners.begin(), corners.end(),
      [&](const Vector& corner) { return Evaluate(side, corner) >= 0.0; });
    if (inside == 0)
    {
      return Share::Nothing;
    }
    share = inside < 4 ? Share::Something : share;
  }
  return share;
}

} // namespace

vtkTextureSliceTiles::vtkTextureSliceTiles(const vtkTextureSliceOccupancy& occupancy,
  const std::array<int, 2>& viewport, const vtkTextureSliceDensity& density)
  : Occupancy(occupancy)
  , Viewport(viewport)
  , Density(density)
  , Opaque(viewport, density.SlicesNeeded)
{
}

vtkTextureSliceTiles::Rectangle vtkTextureSliceTiles::FindTiles() const
{
  Vector low{double(this->Viewport[0]), double(this->Viewport[1]), 0.0};
  Vector high{0.0, 0.0, 0.0};
  for (const Vector& corner : this->Slice->Outline)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::max(0.0, std::min(low[axis], corner[axis]));
      high[axis] = std::min(double(this->Viewport[axis]), std::max(high[axis], corner[axis]));
    }
  }
  const auto down = [](double x)
  { return static_cast<int>(std::floor(x / LargestTile)) * LargestTile; };
  const auto up = [](double x)
  { return static_cast<int>(std::ceil(x / LargestTile)) * LargestTile; };
  return {down(low[0]), down(low[1]), up(high[0]), up(high[1])};
}

const std::vector<Polygon>& vtkTextureSliceTiles::Cover(const vtkTextureSliceOnScreen& slice)
{
  this->Parts.clear();
  this->Slice = &slice;
  FindSides(slice.Outline, this->Sides);
  const Rectangle all = this->FindTiles();
  if (all.Left >= all.Right || all.Bottom >= all.Top)
  {
    return this->Parts;
  }
  const Share share = this->Find(this->Occupancy, all);
  if (share == Share::Nothing)
  {
    return this->Parts;
  }
  if (share == Share::Everything && !this->Opaque.IsAnyOpaque(all))
  {
    this->Add(all);
  }
  else
  {
    for (int bottom = all.Bottom; bottom < all.Top; bottom += LargestTile)
    {
      this->CoverRow(bottom, all.Left, all.Right);
    }
  }
  for (int bottom = all.Bottom; this->Density.Bricks != nullptr && bottom < all.Top;
       bottom += LargestTile)
  {
    for (int left = all.Left; left < all.Right; left += LargestTile)
    {
      this->Thicken({left, bottom, left + LargestTile, bottom + LargestTile});
    }
  }
  return this->Parts;
}

Share vtkTextureSliceTiles::Find(
  const vtkTextureSliceOccupancy& occupancy, const Rectangle& tile) const
{
  Vector low;
  Vector high;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [left, right] =
      std::minmax({tile.Left * this->Slice->Right[axis], tile.Right * this->Slice->Right[axis]});
    const auto [bottom, top] =
      std::minmax({tile.Bottom * this->Slice->Up[axis], tile.Top * this->Slice->Up[axis]});
    low[axis] = this->Slice->Origin[axis] + left + bottom;
    high[axis] = this->Slice->Origin[axis] + right + top;
  }
  return occupancy.Find(low, high);
}

void vtkTextureSliceTiles::Thicken(const Rectangle& tile)
{
  const Share inside = FindShare(this->Sides, tile);
  if (inside == Share::Nothing || this->Opaque.AreAllOpaque(tile))
  {
    return;
  }
  const Share dense = this->Find(*this->Density.Bricks, tile);
  if (dense == Share::Everything && inside == Share::Everything)
  {
    this->Opaque.AddLayer(tile);
  }
  else if (dense != Share::Nothing && tile.Right - tile.Left > vtkTextureSliceOpaqueCells::CellSize)
  {
    for (const Rectangle& quarter : GetQuarters(tile))
    {
      this->Thicken(quarter);
    }
  }
}

void vtkTextureSliceTiles::CoverRow(int bottom, int left, int right)
{
  // Tiles that are visible as a whole become one rectangle.
  Rectangle run{left, bottom, left, bottom + LargestTile};
  for (int x = left; x < right; x += LargestTile)
  {
    const bool whole = this->Divide({x, bottom, x + LargestTile, bottom + LargestTile});
    if (!whole)
    {
      this->Add(run);
      run.Left = x + LargestTile;
    }
    run.Right = x + LargestTile;
  }
  this->Add(run);
}

bool vtkTextureSliceTiles::Divide(const Rectangle& tile)
{
  const Share share = this->Find(this->Occupancy, tile);
  const int size = tile.Right - tile.Left;
  const bool hasCells = size >= vtkTextureSliceOpaqueCells::CellSize;
  if (share == Share::Nothing || (hasCells && this->Opaque.AreAllOpaque(tile)))
  {
    return false;
  }
  const bool mixed = hasCells && this->Opaque.IsAnyOpaque(tile);
  if ((share == Share::Everything && !mixed) || size < 2 * SmallestTile)
  {
    return true;
  }
  const std::array<Rectangle, 4> quarters = GetQuarters(tile);
  std::array<bool, 4> whole;
  for (std::size_t i = 0; i < 4; ++i)
  {
    whole[i] = this->Divide(quarters[i]);
  }
  if (whole[0] && whole[1] && whole[2] && whole[3])
  {
    return true;
  }
  for (const std::size_t row : {std::size_t{0}, std::size_t{2}})
  {
    if (whole[row] && whole[row + 1])
    {
      this->Add({tile.Left, quarters[row].Bottom, tile.Right, quarters[row].Top});
      whole[row] = whole[row + 1] = false;
    }
  }
  for (std::size_t i = 0; i < 4; ++i)
  {
    if (whole[i])
    {
      this->Add(quarters[i]);
    }
  }
  return false;
}

void vtkTextureSliceTiles::Add(const Rectangle& rectangle)
{
  if (rectangle.Left >= rectangle.Right)
  {
    return;
  }
  const std::array<Vector, 4> corners = GetCorners(rectangle);
  Polygon part(corners.begin(), corners.end());
  for (const Plane& side : this->Sides)
  {
    const auto outside = [&](const Vector& corner) { return Evaluate(side, corner) < 0.0; };
    if (std::any_of(part.begin(), part.end(), outside))
    {
      ClipPolygon(part, side, this->Kept);
      std::swap(part, this->Kept);
    }
  }
  if (part.size() >= 3)
  {
    this->Parts.push_back(std::move(part));
  }
}
