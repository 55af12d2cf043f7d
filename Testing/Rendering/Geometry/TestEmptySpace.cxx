// SPDX-License-Identifier: BSD-3-Clause
// What is left out of a volume, against a look at every voxel and every brick.
#include "vtkTextureSliceEmptySpace.h"
#include "vtkTextureSliceTables.h"
#include "vtkTextureSliceTexels.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <vector>

namespace
{

using Vector = std::array<double, 3>;

constexpr std::array<int, 3> VolumeSize{22, 14, 19};

vtkIdType Id(int x, int y, int z)
{
  return (vtkIdType{z} * VolumeSize[1] + y) * VolumeSize[0] + x;
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
    this->Scalars->SetNumberOfTuples(Id(0, 0, VolumeSize[2]));
    this->Ghosts->SetNumberOfTuples(this->Scalars->GetNumberOfTuples());
    for (vtkIdType id = 0; id < this->Scalars->GetNumberOfTuples(); ++id)
    {
      this->Ghosts->SetValue(id, random() % 4 == 0 ? 2 : 0);
      this->Scalars->SetTuple2(
        id, random() % 5 == 0 ? std::nan("") : scalar(random), scalar(random));
    }
    this->Source = {this->Scalars, VolumeSize, cellData, this->Ghosts};
  }

  bool Counts(vtkIdType id)
  {
    return this->Ghosts->GetValue(id) != 2 && std::isfinite(this->Scalars->GetComponent(id, 0));
  }

  vtkNew<vtkFloatArray> Scalars;
  vtkNew<vtkUnsignedCharArray> Ghosts;
  vtkTextureSliceScalars Source;
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
    const double scale = cells ? VolumeSize[axis] : VolumeSize[axis] - 1;
    const double shift = cells ? 0.5 : 0.0;
    begin[axis] = std::max(0, int(std::floor(low[axis] * scale - shift + 1e-9)));
    end[axis] = std::min(VolumeSize[axis] - 1, int(std::ceil(high[axis] * scale - shift - 1e-9)));
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
  const auto [nx, ny, nz] = bricks.Count;
  ASSERT_GT(nx * ny * nz, 20);
  auto range = bricks.Ranges.begin();
  for (int brick = 0; brick < nx * ny * nz; ++brick)
  {
    Vector low;
    Vector high;
    const std::array<int, 3> index{brick % nx, brick / nx % ny, brick / (nx * ny)};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = index[axis] * bricks.Edge[axis];
      high[axis] = std::min(1.0, (index[axis] + 1) * bricks.Edge[axis]);
    }
    for (int component = 0; component < 2; ++component, ++range)
    {
      const auto expected = FindRange(volume, component, low, high);
      EXPECT_EQ(range->Low, expected.Low) << "brick " << brick;
      EXPECT_EQ(range->High, expected.High) << "brick " << brick;
    }
  }
  EXPECT_EQ(range, bricks.Ranges.end());
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
  std::vector<float> opacities(16, 0.0f);
  opacities[3] = 0.5f;
  opacities[10] = 1.0f;
  vtkTextureSliceVisibility visibility(opacities);
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
  visibility = vtkTextureSliceVisibility(opacities);
  EXPECT_TRUE(visible(-9.0, -8.0)) << "beyond its ends a table holds its last entries";
}

namespace
{

constexpr std::array<int, 3> Bricks{19, 11, 70};

/// So many random bricks are visible.
std::vector<unsigned char> MakeVisible(int number, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<unsigned char> visible(19 * 11 * 70, 0);
  for (int i = 0; i < number; ++i)
  {
    visible[random() % visible.size()] = 1;
  }
  return visible;
}

std::array<int, 3> IndexOf(std::size_t brick)
{
  const int id = static_cast<int>(brick);
  return {id % Bricks[0], id / Bricks[0] % Bricks[1], id / (Bricks[0] * Bricks[1])};
}

/// The chessboard distance to the nearest visible brick that a ray of the octant can reach.
int FindNearestAhead(const std::array<int, 3>& here, std::size_t octant,
  const std::vector<std::array<int, 3>>& visible)
{
  int nearest = vtkTextureSliceDistanceMap::MostDistance;
  for (const std::array<int, 3>& there : visible)
  {
    int distance = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int ahead =
        (octant >> axis & 1) != 0 ? here[axis] - there[axis] : there[axis] - here[axis];
      distance = ahead < 0 ? nearest : std::max(distance, ahead);
    }
    nearest = std::min(nearest, distance);
  }
  return nearest;
}

} // namespace

TEST(EmptySpace, NoCubeAheadOfARayHasAVisibleBrick)
{
  for (const int number : {1, 2, 9, 400})
  {
    const std::vector<unsigned char> visible =
      MakeVisible(number, static_cast<unsigned int>(number));
    vtkTextureSliceDistanceMap map;
    map.Build(Bricks, {1.0 / 19, 1.0 / 11, 1.0 / 70}, visible);
    std::vector<std::array<int, 3>> seen;
    for (std::size_t brick = 0; brick < visible.size(); ++brick)
    {
      if (visible[brick] != 0)
      {
        seen.push_back(IndexOf(brick));
      }
    }
    for (std::size_t i = 0; i < map.Distances.size(); ++i)
    {
      const std::size_t octant = i / visible.size();
      const std::array<int, 3> here = IndexOf(i % visible.size());
      ASSERT_EQ(map.Distances[i], FindNearestAhead(here, octant, seen))
        << number << " visible, octant " << octant << ", brick " << i % visible.size();
    }
    EXPECT_EQ(
      map.VisibleShare, static_cast<double>(seen.size()) / static_cast<double>(visible.size()));
  }
}

TEST(EmptySpace, TheSeenPartIsThatAboutAllVisibleBricks)
{
  std::vector<unsigned char> visible(19 * 11 * 70, 0);
  const auto show = [&visible](int x, int y, int z)
  { visible[static_cast<std::size_t>((z * Bricks[1] + y) * Bricks[0] + x)] = 1; };
  vtkTextureSliceDistanceMap map;
  const auto find = [&]
  {
    map.Build(Bricks, {1.0 / 19, 1.0 / 11, 1.0 / 69.5}, visible); // the last along z is cut
    return map.Seen;
  };
  show(3, 10, 5);
  show(7, 2, 6);
  const std::array<double, 6> inside{3 / 19.0, 8 / 19.0, 2 / 11.0, 1.0, 5 / 69.5, 7 / 69.5};
  std::array<double, 6> seen = find();
  for (std::size_t side = 0; side < 6; ++side)
  {
    EXPECT_NEAR(seen[side], inside[side], 1e-12) << "side " << side;
  }
  show(0, 0, 69);
  seen = find();
  EXPECT_EQ(seen[5], 1.0);
  EXPECT_EQ(seen[0], 0.0);
}

TEST(EmptySpace, WithoutVisibleBricksNothingIsSeen)
{
  vtkTextureSliceDistanceMap map;
  map.Build(Bricks, {1.0 / 19, 1.0 / 11, 1.0 / 70}, std::vector<unsigned char>(19 * 11 * 70, 0));
  EXPECT_EQ(map.VisibleShare, 0.0);
  EXPECT_EQ(*std::min_element(map.Distances.begin(), map.Distances.end()),
    vtkTextureSliceDistanceMap::MostDistance);
}
