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

// Edge in pixels, that of the blocks in which software renderers shade.
constexpr int SmallestTile = 4;

/// What drawing a rectangle costs, in shaded pixels: its own, those in blocks on the diagonal,
/// which both triangles share, and the triangles' own cost, as measured with llvmpipe.
double GetCost(const vtkTextureSlicePixels& rectangle)
{
  constexpr double perEdge = 2.0;
  constexpr double perRectangle = 70.0;
  const double width = rectangle.Right - rectangle.Left;
  const double height = rectangle.Top - rectangle.Bottom;
  return width * height + perEdge * std::max(width, height) + perRectangle;
}

vtkTextureSlicePixels Around(const vtkTextureSlicePixels& a, const vtkTextureSlicePixels& b)
{
  return {std::min(a.Left, b.Left), std::min(a.Bottom, b.Bottom), std::max(a.Right, b.Right),
    std::max(a.Top, b.Top)};
}

/// Extends a by b if both are one rectangle.
bool JoinPair(vtkTextureSlicePixels& a, const vtkTextureSlicePixels& b)
{
  const bool beside =
    a.Bottom == b.Bottom && a.Top == b.Top && (a.Right == b.Left || b.Right == a.Left);
  const bool above =
    a.Left == b.Left && a.Right == b.Right && (a.Top == b.Bottom || b.Top == a.Bottom);
  if (beside || above)
  {
    a = Around(a, b);
  }
  return beside || above;
}

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

/// The tiles of the largest size, as one rectangle, that an outline touches in a part of the
/// picture.
vtkTextureSlicePixels FindTiles(const Polygon& outline, const vtkTextureSlicePixels& part)
{
  const Vector first{double(part.Left), double(part.Bottom), 0.0};
  const Vector last{double(part.Right), double(part.Top), 0.0};
  Vector low = last;
  Vector high = first;
  for (const Vector& corner : outline)
  {
    for (std::size_t axis = 0; axis < 2; ++axis)
    {
      low[axis] = std::max(first[axis], std::min(low[axis], corner[axis]));
      high[axis] = std::min(last[axis], std::max(high[axis], corner[axis]));
    }
  }
  constexpr int size = vtkTextureSliceTiles::LargestTile;
  const auto down = [](double x) { return static_cast<int>(std::floor(x / size)) * size; };
  const auto up = [](double x) { return static_cast<int>(std::ceil(x / size)) * size; };
  return {down(low[0]), down(low[1]), up(high[0]), up(high[1])};
}

bool IsEmpty(const vtkTextureSlicePixels& pixels)
{
  return pixels.Left >= pixels.Right || pixels.Bottom >= pixels.Top;
}

/// The box around what the rays cross from where they are in a box to so many slice distances on.
struct Swept
{
  Vector Low;
  Vector High;
};

Swept Move(const vtkTextureSliceSegments& segments, const Swept& box, double distances)
{
  Swept moved;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const double factor = 1.0 + distances * segments.Growth;
    const auto [low, high] = std::minmax({factor * box.Low[axis], factor * box.High[axis]});
    moved.Low[axis] = low + distances * segments.Step[axis];
    moved.High[axis] = high + distances * segments.Step[axis];
  }
  return moved;
}

bool IsInside(const std::array<double, 6>& part, const Swept& box)
{
  bool inside = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    inside = inside && box.Low[axis] >= part[2 * axis] && box.High[axis] <= part[2 * axis + 1];
  }
  return inside;
}

/// Extends a box by the segments of the rays through it.
void Sweep(const vtkTextureSliceSegments& segments, Swept& box)
{
  const Swept plane = box;
  for (const std::size_t side : {0, 1})
  {
    const double reach = segments.Reach[side];
    if (reach == 0.0)
    {
      continue;
    }
    const double direction = side == 0 ? -1.0 : 1.0;
    Swept end = Move(segments, plane, direction);
    if (reach < 1.0 && IsInside(segments.Part, end))
    {
      end = Move(segments, plane, direction * reach);
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box.Low[axis] = std::min(box.Low[axis], end.Low[axis]);
      box.High[axis] = std::max(box.High[axis], end.High[axis]);
    }
  }
}

/// How much of the box around a rectangle of a slice touches bricks.
Share FindIn(const vtkTextureSliceOccupancy& occupancy, const vtkTextureSliceOnScreen& slice,
  const vtkTextureSlicePixels& pixels)
{
  Swept box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto [left, right] =
      std::minmax({pixels.Left * slice.Right[axis], pixels.Right * slice.Right[axis]});
    const auto [bottom, top] =
      std::minmax({pixels.Bottom * slice.Up[axis], pixels.Top * slice.Up[axis]});
    box.Low[axis] = slice.Origin[axis] + left + bottom;
    box.High[axis] = slice.Origin[axis] + right + top;
  }
  Sweep(slice.Segments, box);
  return occupancy.Find(box.Low, box.High);
}

/// That plane, seen from the other side, and so far away from it.
Plane Opposite(const Plane& plane, double distance)
{
  return {-plane[0], -plane[1], -plane[2],
    distance * std::hypot(plane[0], plane[1], plane[2]) - plane[3]};
}

} // namespace

vtkTextureSliceTiles::vtkTextureSliceTiles(const vtkTextureSliceOccupancy& occupancy,
  const vtkTextureSlicePixels& part, const vtkTextureSliceDensity& density)
  : Occupancy(occupancy)
  , Part(part)
  , Density(density)
  , Opaque(part, density.SlicesNeeded)
{
  const auto count = [](int pixels) { return (pixels + LargestTile - 1) / LargestTile; };
  this->Runs.resize(
    static_cast<std::size_t>(count(part.Right - part.Left) * count(part.Top - part.Bottom)));
}

Share vtkTextureSliceTiles::FindVisible(const vtkTextureSliceOccupancy& occupancy,
  const vtkTextureSliceOnScreen& slice, const vtkTextureSlicePixels& picture)
{
  const Rectangle all = FindTiles(slice.Outline, picture);
  return IsEmpty(all) ? Share::Nothing : FindIn(occupancy, slice, all);
}

const std::vector<Polygon>& vtkTextureSliceTiles::Cover(const vtkTextureSliceOnScreen& slice)
{
  this->Parts.clear();
  this->Rectangles.clear();
  this->Slice = &slice;
  ++this->SliceNumber;
  FindSides(slice.Outline, this->Sides);
  if (this->Density.Bricks != nullptr)
  {
    this->LastSides.push_front(this->Sides);
    this->LastSides.resize(
      std::min(this->LastSides.size(), std::size_t(this->Density.SlicesNeeded) + 1));
  }
  const Rectangle all = FindTiles(slice.Outline, this->Part);
  if (IsEmpty(all) || this->Find(this->Occupancy, all) == Share::Nothing)
  {
    return this->Parts;
  }
  for (int bottom = all.Bottom; bottom < all.Top; bottom += LargestTile)
  {
    this->CoverRow(bottom, all.Left, all.Right);
  }
  for (const Rectangle& rectangle : this->Rectangles)
  {
    const std::array<Vector, 4> corners = GetCorners(rectangle);
    this->Add(Polygon(corners.begin(), corners.end()));
  }
  for (int bottom = all.Bottom; this->Density.Bricks != nullptr && bottom < all.Top;
       bottom += LargestTile)
  {
    for (int left = all.Left; left < all.Right; left += LargestTile)
    {
      this->CountDense({left, bottom, left + LargestTile, bottom + LargestTile});
    }
  }
  return this->Parts;
}

Share vtkTextureSliceTiles::Find(
  const vtkTextureSliceOccupancy& occupancy, const Rectangle& tile) const
{
  return FindIn(occupancy, *this->Slice, tile);
}

vtkTextureSliceTiles::Run& vtkTextureSliceTiles::GetRun(const Rectangle& tile)
{
  const int columns = (this->Part.Right - this->Part.Left + LargestTile - 1) / LargestTile;
  return this
    ->Runs[static_cast<std::size_t>((tile.Bottom - this->Part.Bottom) / LargestTile * columns +
                                    (tile.Left - this->Part.Left) / LargestTile)];
}

bool vtkTextureSliceTiles::CutBehindDense(const Rectangle& tile)
{
  const Run& run = this->GetRun(tile);
  if (run.Last != this->SliceNumber - 1 || run.Slices < this->Density.SlicesNeeded)
  {
    return false;
  }
  // A ray meets a convex volume once: between a slice that it crosses some way back and this one
  // it has crossed them all, and the dense ones have made it opaque.
  constexpr double margin = 0.125; // pixels: rasterization decides on those at the outline
  const Plane* border = nullptr;
  for (const Plane& side : this->LastSides.back())
  {
    const Plane outwards = Opposite(side, margin);
    const std::array<Vector, 4> corners = GetCorners(tile);
    const auto outside = std::count_if(corners.begin(), corners.end(),
      [&](const Vector& corner) { return Evaluate(outwards, corner) >= 0.0; });
    // Beyond two sides, what remains is not convex.
    if (outside == 4 || (outside > 0 && border != nullptr))
    {
      return false;
    }
    border = outside > 0 ? &side : border;
  }
  if (border != nullptr)
  {
    const std::array<Vector, 4> corners = GetCorners(tile);
    Polygon rest;
    ClipPolygon(Polygon(corners.begin(), corners.end()), Opposite(*border, margin), rest);
    this->Add(std::move(rest));
  }
  return true;
}

void vtkTextureSliceTiles::CountDense(const Rectangle& tile)
{
  if (this->Opaque.AreAllOpaque(tile))
  {
    return;
  }
  const Share dense = this->Find(*this->Density.Bricks, tile);
  Run& run = this->GetRun(tile);
  run.Slices = dense != Share::Everything          ? 0
               : run.Last == this->SliceNumber - 1 ? run.Slices + 1
                                                   : 1;
  run.Last = this->SliceNumber;
  this->Thicken(tile, dense);
}

void vtkTextureSliceTiles::Thicken(const Rectangle& tile, Share dense)
{
  if (dense == Share::Nothing || this->Opaque.AreAllOpaque(tile))
  {
    return;
  }
  const Share inside = FindShare(this->Sides, tile);
  if (dense == Share::Everything && inside == Share::Everything)
  {
    this->Opaque.AddLayer(tile);
  }
  else if (inside != Share::Nothing &&
           tile.Right - tile.Left > vtkTextureSliceOpaqueCells::CellSize)
  {
    for (const Rectangle& quarter : GetQuarters(tile))
    {
      this->Thicken(
        quarter, dense == Share::Everything ? dense : this->Find(*this->Density.Bricks, quarter));
    }
  }
}

void vtkTextureSliceTiles::CoverRow(int bottom, int left, int right)
{
  std::size_t last = this->Rectangles.size(); // the first rectangle of the tile before
  for (int x = left; x < right; x += LargestTile)
  {
    const Rectangle tile{x, bottom, x + LargestTile, bottom + LargestTile};
    if (this->CutBehindDense(tile))
    {
      continue;
    }
    const std::size_t begin = this->Rectangles.size();
    this->Divide(tile);
    if (this->Rectangles.size() == begin + 1 && begin == last + 1 &&
        JoinPair(this->Rectangles[last], this->Rectangles[begin]))
    {
      this->Rectangles.pop_back();
      continue;
    }
    last = begin;
  }
}

double vtkTextureSliceTiles::Divide(const Rectangle& tile)
{
  if (this->Opaque.AreAllOpaque(tile))
  {
    return 0.0;
  }
  const Share share = this->Find(this->Occupancy, tile);
  if (share == Share::Nothing)
  {
    return 0.0;
  }
  if ((share == Share::Everything && !this->Opaque.IsAnyOpaque(tile)) ||
      tile.Right - tile.Left == SmallestTile)
  {
    this->Rectangles.push_back(tile);
    return GetCost(tile);
  }
  const std::size_t begin = this->Rectangles.size();
  double cost = 0.0;
  for (const Rectangle& quarter : GetQuarters(tile))
  {
    cost += this->Divide(quarter);
  }
  return this->Simplify(begin, cost);
}

double vtkTextureSliceTiles::Simplify(std::size_t begin, double cost)
{
  std::vector<Rectangle>& all = this->Rectangles;
  if (all.size() < begin + 2)
  {
    return cost;
  }
  Rectangle around = all[begin];
  for (std::size_t i = begin + 1; i < all.size(); ++i)
  {
    around = Around(around, all[i]);
  }
  if (GetCost(around) <= cost)
  {
    all.resize(begin);
    all.push_back(around);
    return GetCost(around);
  }
  constexpr std::size_t few = 12; // more have been joined as far as it goes, in smaller tiles
  for (std::size_t i = begin; i < all.size() && all.size() - begin <= few; ++i)
  {
    for (std::size_t k = i + 1; k < all.size(); ++k)
    {
      const double apart = GetCost(all[i]) + GetCost(all[k]);
      if (JoinPair(all[i], all[k]))
      {
        cost += GetCost(all[i]) - apart;
        all[k] = all.back();
        all.pop_back();
        k = i;
      }
    }
  }
  return cost;
}

void vtkTextureSliceTiles::Add(Polygon part)
{
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
