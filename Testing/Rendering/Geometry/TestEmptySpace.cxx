// SPDX-License-Identifier: BSD-3-Clause
// What is left out of a volume, against a look at every voxel and every pixel.
#include "Tolerance.h"
#include "vtkTextureSliceBricks.h"
#include "vtkTextureSliceOccupancy.h"
#include "vtkTextureSliceTiles.h"
#include "vtkTextureSliceVisibility.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace
{

using Share = vtkTextureSliceOccupancy::Share;
using vtkTextureSlice::Polygon;
using vtkTextureSlice::Vector;

constexpr std::array<int, 3> Size{11, 7, 9};

vtkIdType Id(int x, int y, int z)
{
  return (vtkIdType{z} * Size[1] + y) * Size[0] + x;
}

/// Scalars of two components; some are not finite, some are hidden.
class RandomVolume
{
public:
  explicit RandomVolume(bool cellData)
  {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> scalar(-5.0f, 5.0f);
    this->Scalars->SetNumberOfComponents(2);
    this->Scalars->SetNumberOfTuples(Id(0, 0, Size[2]));
    this->Ghosts->SetNumberOfTuples(this->Scalars->GetNumberOfTuples());
    for (vtkIdType id = 0; id < this->Scalars->GetNumberOfTuples(); ++id)
    {
      this->Ghosts->SetValue(id, random() % 4 == 0 ? 2 : 0);
      this->Scalars->SetTuple2(
        id, random() % 5 == 0 ? std::nan("") : scalar(random), scalar(random));
    }
    this->Source = {this->Scalars, Size, cellData, this->Ghosts};
  }

  bool Counts(vtkIdType id)
  {
    return this->Ghosts->GetValue(id) != 2 && std::isfinite(this->Scalars->GetComponent(id, 0));
  }

  vtkNew<vtkFloatArray> Scalars;
  vtkNew<vtkUnsignedCharArray> Ghosts;
  vtkTextureSliceBricks::Source Source;
};

/// The range of the texels whose weight can be above 0 somewhere in a part of the box.
vtkTextureSliceBricks::Range FindRange(
  RandomVolume& volume, int component, const Vector& low, const Vector& high)
{
  vtkTextureSliceBricks::Range range;
  std::array<int, 3> begin;
  std::array<int, 3> end;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // Texel i stands at i of size - 1 intervals, or in the middle of cell i.
    const bool cells = volume.Source.CellData;
    const double scale = cells ? Size[axis] : Size[axis] - 1;
    const double shift = cells ? 0.5 : 0.0;
    begin[axis] = std::max(0, int(std::floor(low[axis] * scale - shift + 1e-9)));
    end[axis] = std::min(Size[axis] - 1, int(std::ceil(high[axis] * scale - shift - 1e-9)));
  }
  for (int z = begin[2]; z <= end[2]; ++z)
  {
    for (int y = begin[1]; y <= end[1]; ++y)
    {
      for (int x = begin[0]; x <= end[0]; ++x)
      {
        if (volume.Counts(Id(x, y, z)))
        {
          const double scalar = volume.Scalars->GetComponent(Id(x, y, z), component);
          range.Low = std::min(range.Low, scalar);
          range.High = std::max(range.High, scalar);
        }
      }
    }
  }
  return range;
}

void ExpectRangesOfVoxels(bool cellData)
{
  RandomVolume volume(cellData);
  vtkTextureSliceBricks bricks;
  bricks.Build(volume.Source);
  const auto [nx, ny, nz] = bricks.GetCount();
  ASSERT_GT(nx * ny * nz, 20);
  auto range = bricks.GetRanges().begin();
  for (int brick = 0; brick < nx * ny * nz; ++brick)
  {
    Vector low;
    Vector high;
    const std::array<int, 3> index{brick % nx, brick / nx % ny, brick / (nx * ny)};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = index[axis] * bricks.GetEdge()[axis];
      high[axis] = std::min(1.0, (index[axis] + 1) * bricks.GetEdge()[axis]);
    }
    for (int component = 0; component < 2; ++component, ++range)
    {
      const auto expected = FindRange(volume, component, low, high);
      EXPECT_EQ(range->Low, expected.Low) << "brick " << brick;
      EXPECT_EQ(range->High, expected.High) << "brick " << brick;
    }
  }
  EXPECT_EQ(range, bricks.GetRanges().end());
}

} // namespace

TEST(EmptySpace, RangesOfBricksAreThoseOfTheirVoxels)
{
  ExpectRangesOfVoxels(false);
}

TEST(EmptySpace, RangesOfBricksOfCellsReachAcrossTheirFaces)
{
  ExpectRangesOfVoxels(true);
}

TEST(EmptySpace, VisibilityIsThatOfTheInterpolatedTable)
{
  // Entries 3 and 10 of 0 to 15 are visible, and so is what lies between them and their neighbours.
  std::array<float, 32> opacities{};
  opacities[2 * 3] = 0.5f;
  opacities[2 * 10] = 1.0f;
  vtkTextureSliceVisibility visibility;
  visibility.Build(opacities.data(), 16, 2, [](float opacity) { return opacity > 0.0f; });
  const auto visible = [&](double from, double to)
  { return visibility.IsVisible(from / 15.0, to / 15.0); };
  EXPECT_FALSE(visible(-9.0, 1.9));
  EXPECT_TRUE(visible(-9.0, 2.1));
  EXPECT_TRUE(visible(2.5, 2.6));
  EXPECT_TRUE(visible(3.9, 5.0));
  EXPECT_FALSE(visible(4.1, 8.9));
  EXPECT_TRUE(visible(4.1, 9.1));
  EXPECT_TRUE(visible(0.0, 15.0));
  EXPECT_FALSE(visible(11.1, 99.0));
  EXPECT_FALSE(visible(5.0, 3.0)) << "a brick without scalars";
  opacities[0] = 1.0f;
  visibility.Build(opacities.data(), 16, 2, [](float opacity) { return opacity > 0.0f; });
  EXPECT_TRUE(visible(-9.0, -8.0)) << "beyond its ends a table holds its last entries";
}

TEST(EmptySpace, OccupancyCountsTheBricksThatABoxTouches)
{
  std::mt19937 random(3);
  const std::array<int, 3> count{5, 4, 3};
  std::vector<unsigned char> visible(60);
  for (unsigned char& brick : visible)
  {
    brick = random() % 6 == 0 ? 1 : 0;
  }
  vtkTextureSliceOccupancy occupancy;
  occupancy.Build(count, {0.2, 0.25, 0.4}, visible); // the last along z is half as high
  std::uniform_real_distribution<double> place(-0.2, 1.2);
  std::array<int, 3> found{};
  for (int trial = 0; trial < 2000; ++trial)
  {
    Vector low{place(random), place(random), place(random)};
    Vector high{place(random), place(random), place(random)};
    int touched = 0;
    int touchedVisible = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      high[axis] = low[axis] + 0.5 * std::abs(high[axis] - low[axis]);
    }
    for (int brick = 0; brick < 60; ++brick)
    {
      const std::array<double, 3> begin{brick % 5 * 0.2, brick / 5 % 4 * 0.25, brick / 20 * 0.4};
      const std::array<double, 3> edge{0.2, 0.25, brick / 20 == 2 ? 0.2 : 0.4};
      bool touches = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        touches = touches && low[axis] <= begin[axis] + edge[axis] && high[axis] >= begin[axis];
      }
      touched += touches ? 1 : 0;
      touchedVisible += touches ? visible[std::size_t(brick)] : 0;
    }
    const Share expected = touchedVisible == 0         ? Share::Nothing
                           : touchedVisible == touched ? Share::Everything
                                                       : Share::Something;
    EXPECT_EQ(occupancy.Find(low, high), expected) << "trial " << trial;
    ++found[std::size_t(expected)];
  }
  EXPECT_AT_LEAST(*std::min_element(found.begin(), found.end()), 20, "boxes of the rarest answer")
    << "each answer must be asked for";
}

namespace
{

bool Contains(const Polygon& polygon, double x, double y)
{
  int left = 0;
  int right = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& a = polygon[i];
    const Vector& b = polygon[(i + 1) % polygon.size()];
    const double side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
    left += side > 0.0 ? 1 : 0;
    right += side < 0.0 ? 1 : 0;
  }
  return left == 0 || right == 0;
}

} // namespace

TEST(EmptySpace, TilesEndBehindDenseSlicesThatCoverThem)
{
  // Everything is visible, the lower x half dense; three dense slices make a pixel opaque.
  vtkTextureSliceOccupancy everything;
  vtkTextureSliceOccupancy dense;
  dense.Build({2, 1, 1}, {0.5, 1.0, 1.0}, {1, 0});
  vtkTextureSliceOnScreen slice;
  slice.Outline = {{0.0, 0.0, 0.0}, {250.0, 0.0, 0.0}, {250.0, 128.0, 0.0}, {0.0, 128.0, 0.0}};
  slice.Right = {1.0 / 256, 0.0, 0.0};
  slice.Up = {0.0, 1.0 / 128, 0.0};
  vtkTextureSliceTiles tiles(everything, {0, 0, 256, 128}, {&dense, 3});
  for (int layer = 0; layer < 6; ++layer)
  {
    slice.Origin = {0.0, 0.0, 0.1 * layer};
    const std::vector<Polygon>& parts = tiles.Cover(slice);
    const auto covers = [&](double x, double y)
    {
      return std::any_of(
        parts.begin(), parts.end(), [&](const Polygon& part) { return Contains(part, x, y); });
    };
    EXPECT_EQ(covers(20.5, 60.5), layer < 3) << "slice " << layer;
    EXPECT_EQ(covers(100.5, 100.5), layer < 3) << "slice " << layer;
    EXPECT_TRUE(covers(140.5, 60.5)) << "slice " << layer;
    EXPECT_TRUE(covers(249.5, 127.5)) << "slice " << layer;
  }
}

TEST(EmptySpace, DenseSlicesHideWhatIsBehindTheirOutline)
{
  // All of a block is dense, and three slices make a pixel opaque; it leans upwards, so that each
  // slice shows a little more at its upper edge.
  const vtkTextureSliceOccupancy everything;
  vtkTextureSliceTiles tiles(everything, {0, 0, 256, 192}, {&everything, 3});
  std::vector<int> layers(256 * 192, 0);
  for (int number = 0; number < 24; ++number)
  {
    const double up = 5.31 * number;
    vtkTextureSliceOnScreen slice;
    slice.Outline = {{-9.1, up - 20.0, 0.0}, {230.4, up - 9.0, 0.0}, {240.7, up + 60.37, 0.0},
      {10.3, up + 43.0, 0.0}};
    slice.Right = {1.0 / 256, 0.0, 0.0};
    slice.Up = {0.0, 1.0 / 192, 0.0};
    slice.Origin = {0.0, 0.0, number / 24.0};
    const std::vector<Polygon>& parts = tiles.Cover(slice);
    for (std::size_t pixel = 0; pixel < layers.size(); ++pixel)
    {
      const double x = static_cast<double>(pixel % 256) + 0.5;
      const double y = static_cast<double>(pixel / 256) + 0.5;
      const auto covered = std::count_if(
        parts.begin(), parts.end(), [&](const Polygon& part) { return Contains(part, x, y); });
      const bool inOutline = Contains(slice.Outline, x, y);
      ASSERT_LE(covered, inOutline ? 1 : 0) << "slice " << number << ", pixel " << x << ", " << y;
      ASSERT_TRUE(covered == 1 || !inOutline || layers[pixel] >= 3)
        << "slice " << number << ", pixel " << x << ", " << y;
      layers[pixel] += int(covered);
    }
  }
  const auto drawn = std::accumulate(layers.begin(), layers.end(), 0);
  const auto visible = std::count_if(layers.begin(), layers.end(), [](int n) { return n > 0; });
  // Three slices each, one more along outlines and in tiles at corners.
  EXPECT_AT_MOST(
    static_cast<double>(drawn) / static_cast<double>(visible), 5.0, "slices drawn a visible pixel");
}

TEST(EmptySpace, TilesCoverEachVisiblePixelOnce)
{
  // A slice askew through a volume of which one brick in eight is visible, partly outside of the
  // viewport.
  std::mt19937 random(11);
  const std::array<int, 3> count{16, 16, 8};
  const std::array<double, 3> edge{1.0 / 16, 1.0 / 16, 1.0 / 8};
  std::vector<unsigned char> visible(16 * 16 * 8);
  for (unsigned char& brick : visible)
  {
    brick = random() % 8 == 0 ? 1 : 0;
  }
  vtkTextureSliceOccupancy occupancy;
  occupancy.Build(count, edge, visible);

  vtkTextureSliceOnScreen slice;
  slice.Outline = {{40.3, -30.0, 0.0}, {520.2, 60.7, 0.0}, {400.5, 330.1, 0.0}, {90.9, 250.6, 0.0}};
  slice.Origin = {-0.05, 0.02, 0.9};
  slice.Right = {0.0019, 0.0004, -0.0006};
  slice.Up = {-0.0003, 0.0026, -0.0014};
  const std::array<int, 2> viewport{480, 320};
  vtkTextureSliceTiles tiles(occupancy, {0, 0, viewport[0], viewport[1]});
  const std::vector<Polygon>& parts = tiles.Cover(slice);

  int drawn = 0;
  int needed = 0;
  int inside = 0;
  for (int j = 0; j < viewport[1]; ++j)
  {
    for (int i = 0; i < viewport[0]; ++i)
    {
      const double x = i + 0.5;
      const double y = j + 0.5;
      const auto covered = std::count_if(
        parts.begin(), parts.end(), [&](const Polygon& part) { return Contains(part, x, y); });
      ASSERT_LE(covered, 1) << "pixel " << i << ", " << j;
      std::array<int, 3> brick;
      bool inBox = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double place = slice.Origin[axis] + x * slice.Right[axis] + y * slice.Up[axis];
        inBox = inBox && place >= 0.0 && place < 1.0;
        brick[axis] = int(place / edge[axis]);
      }
      const bool inOutline = Contains(slice.Outline, x, y);
      const bool need =
        inBox && inOutline && visible[std::size_t((brick[2] * 16 + brick[1]) * 16 + brick[0])] != 0;
      ASSERT_TRUE(covered == 1 || !need) << "pixel " << i << ", " << j;
      ASSERT_TRUE(covered == 0 || inOutline) << "pixel " << i << ", " << j;
      drawn += int(covered);
      needed += need ? 1 : 0;
      inside += inOutline ? 1 : 0;
    }
  }
  EXPECT_AT_LEAST(needed, 5'000, "tiles needed");
  EXPECT_AT_MOST(static_cast<double>(drawn) / static_cast<double>(inside), 0.28,
    "pixels drawn, part of those inside");
}

// A plane through the middle of the box, and a brick far behind or before it: what counts is
// whether the rays' segments reach it.
TEST(EmptySpace, SegmentsReachBricksBesideTheSlice)
{
  vtkTextureSliceOccupancy occupancy;
  occupancy.Build({1, 1, 4}, {1.0, 1.0, 0.25}, {1, 0, 0, 0});
  vtkTextureSliceOnScreen slice;
  slice.Outline = {{0, 0, 0}, {100, 0, 0}, {100, 100, 0}, {0, 100, 0}};
  slice.Origin = {0.1, 0.1, 0.5};
  slice.Right = {0.005, 0.0, 0.0};
  slice.Up = {0.0, 0.005, 0.0};
  const vtkTextureSlicePixels picture{0, 0, 100, 100};
  const auto find = [&] { return vtkTextureSliceTiles::FindVisible(occupancy, slice, picture); };
  EXPECT_EQ(find(), Share::Nothing);
  slice.Segments.Reach = {0.5, 0.5};
  slice.Segments.Step = {0.0, 0.0, 0.6};
  EXPECT_EQ(find(), Share::Something);
  slice.Segments.Step = {0.0, 0.0, -0.6}; // it is before the slice then
  EXPECT_EQ(find(), Share::Something);
  slice.Segments.Step = {0.0, 0.0, 0.4};
  EXPECT_EQ(find(), Share::Nothing);
  // The first segment of a ray reaches to the face of the part.
  slice.Segments.Part[4] = 0.2;
  EXPECT_EQ(find(), Share::Something);
  // Rays that diverge from a point in the middle of the far face.
  slice.Segments.Part[4] = 0.0;
  slice.Segments.Growth = 1.2;
  slice.Segments.Step = {-0.6, -0.6, -1.2};
  EXPECT_EQ(find(), Share::Something);
  slice.Segments.Growth = 0.4;
  slice.Segments.Step = {-0.2, -0.2, -0.4};
  EXPECT_EQ(find(), Share::Nothing);
}
