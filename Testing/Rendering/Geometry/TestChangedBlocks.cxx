// SPDX-License-Identifier: BSD-3-Clause
// The boxes in which two volumes differ, against a look at every texel.
#include "vtkTextureSliceTexels.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>
#include <random>
#include <vector>

namespace
{

using Box = vtkTextureSliceBlocks::Box;

constexpr std::array<int, 3> Size{37, 18, 21};
constexpr vtkIdType Texels = vtkIdType(37) * 18 * 21;

/// Random scalars in two components; every one can be told from its neighbours.
class Volume
{
public:
  explicit Volume(int scalarType)
    : Scalars(vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(scalarType)))
  {
    this->Scalars->SetNumberOfComponents(2);
    this->Scalars->SetNumberOfTuples(Texels);
    this->Ghosts->SetNumberOfTuples(Texels);
    this->Ghosts->FillValue(0);
    std::minstd_rand random(7);
    for (vtkIdType i = 0; i < Texels; ++i)
    {
      this->Scalars->SetComponent(i, 0, random() % 100);
      this->Scalars->SetComponent(i, 1, random() % 100);
    }
  }

  vtkTextureSliceBlocks MakeBlocks()
  {
    vtkTextureSliceBlocks blocks;
    blocks.Build({this->Scalars, Size, false, this->Ghosts});
    return blocks;
  }

  vtkSmartPointer<vtkDataArray> Scalars;
  vtkNew<vtkUnsignedCharArray> Ghosts;
};

/// How often each texel is in a box.
std::vector<int> CountBoxes(const std::vector<Box>& boxes)
{
  std::vector<int> counts(Texels, 0);
  for (const Box& box : boxes)
  {
    for (int z = box.Begin[2]; z < box.End[2]; ++z)
    {
      for (int y = box.Begin[1]; y < box.End[1]; ++y)
      {
        for (int x = box.Begin[0]; x < box.End[0]; ++x)
        {
          ++counts.at(static_cast<std::size_t>((z * Size[1] + y) * Size[0] + x));
        }
      }
    }
  }
  return counts;
}

/// The block that a texel is in.
std::array<int, 3> BlockOf(vtkIdType id)
{
  const int edge = vtkTextureSliceBlocks::Edge;
  const int place = static_cast<int>(id);
  return {
    place % Size[0] / edge, place / Size[0] % Size[1] / edge, place / (Size[0] * Size[1]) / edge};
}

/// Each texel of a block with a change is in one box, every other one in none.
void ExpectBoxesOf(const std::vector<vtkIdType>& changes, const std::vector<Box>& boxes)
{
  const std::vector<int> counts = CountBoxes(boxes);
  for (vtkIdType id = 0; id < Texels; ++id)
  {
    const bool changed = std::any_of(changes.begin(), changes.end(),
      [id](vtkIdType change) { return BlockOf(change) == BlockOf(id); });
    ASSERT_EQ(counts[static_cast<std::size_t>(id)], changed ? 1 : 0) << "texel " << id;
  }
}

} // namespace

TEST(ChangedBlocks, WithoutAnotherVolumeAllTexels)
{
  const std::vector<int> counts = CountBoxes(Volume(VTK_FLOAT).MakeBlocks().FindChanges(nullptr));
  EXPECT_EQ(std::count(counts.begin(), counts.end(), 1), Texels);
}

TEST(ChangedBlocks, TheSameVolumeNone)
{
  const vtkTextureSliceBlocks blocks = Volume(VTK_SHORT).MakeBlocks();
  EXPECT_TRUE(Volume(VTK_SHORT).MakeBlocks().FindChanges(&blocks).empty());
}

TEST(ChangedBlocks, OneScalarAnywhere)
{
  for (const int type : {VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE})
  {
    Volume volume(type);
    const vtkTextureSliceBlocks before = volume.MakeBlocks();
    for (vtkIdType id = 0; id < Texels; id += 997)
    {
      const int component = static_cast<int>(id % 2);
      const double scalar = volume.Scalars->GetComponent(id, component);
      volume.Scalars->SetComponent(id, component, scalar + 1.0);
      ExpectBoxesOf({id}, volume.MakeBlocks().FindChanges(&before));
      volume.Scalars->SetComponent(id, component, scalar);
    }
  }
}

TEST(ChangedBlocks, ManyScalars)
{
  Volume volume(VTK_FLOAT);
  const vtkTextureSliceBlocks before = volume.MakeBlocks();
  std::minstd_rand random(3);
  std::vector<vtkIdType> changes;
  for (int i = 0; i < 20; ++i)
  {
    changes.push_back(static_cast<vtkIdType>(random()) % Texels);
    volume.Scalars->SetComponent(changes.back(), 1, -5.0);
    ExpectBoxesOf(changes, volume.MakeBlocks().FindChanges(&before));
  }
}

TEST(ChangedBlocks, TwoTexelsThatChangePlaces)
{
  // The same values in a block in another order are another block.
  Volume volume(VTK_UNSIGNED_CHAR);
  volume.Scalars->SetComponent(0, 0, 1.0);
  volume.Scalars->SetComponent(3, 0, 2.0);
  const vtkTextureSliceBlocks before = volume.MakeBlocks();
  volume.Scalars->SetComponent(0, 0, 2.0);
  volume.Scalars->SetComponent(3, 0, 1.0);
  ExpectBoxesOf({0}, volume.MakeBlocks().FindChanges(&before));
}

TEST(ChangedBlocks, EveryFlagCounts)
{
  Volume volume(VTK_FLOAT);
  const vtkTextureSliceBlocks before = volume.MakeBlocks();
  volume.Ghosts->SetValue(5000, 2);
  volume.Ghosts->SetValue(100, 1);
  ExpectBoxesOf({100, 5000}, volume.MakeBlocks().FindChanges(&before));
}
