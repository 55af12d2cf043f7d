// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBlocks.h"

#include "vtkSMPTools.h"
#include "vtkTextureSliceRows.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace
{

using Box = vtkTextureSliceBlocks::Box;
constexpr int Edge = vtkTextureSliceBlocks::Edge;

constexpr std::uint64_t Seed = 0x9E3779B97F4A7C15;
constexpr std::uint64_t Factor = 0xD6E8FEB86659FD93; // odd, so that no two words give the same

std::uint64_t Mix(std::uint64_t sum, std::uint64_t word)
{
  const std::uint64_t product = (sum ^ word) * Factor;
  return product ^ (product >> 32);
}

/// Takes bytes into a sum, the last word filled with zeros. Only the bits of `mask` count.
std::uint64_t MixBytes(
  std::uint64_t sum, const unsigned char* bytes, std::size_t count, std::uint64_t mask)
{
  std::uint64_t word = 0;
  for (; count >= sizeof(word); count -= sizeof(word), bytes += sizeof(word))
  {
    std::memcpy(&word, bytes, sizeof(word));
    sum = Mix(sum, word & mask);
  }
  if (count > 0)
  {
    word = 0;
    std::memcpy(&word, bytes, count);
    sum = Mix(sum, word & mask);
  }
  return sum;
}

/// Takes a row of texels into the sums of the blocks along it.
void MixRow(const unsigned char* row, std::size_t length, std::size_t bytesOfTexel,
  std::uint64_t mask, std::uint64_t* sums)
{
  constexpr auto edge = static_cast<std::size_t>(Edge);
  if (bytesOfTexel == 1)
  {
    // A row of a block is one word: no loop within it.
    for (; length >= edge; length -= edge, row += edge, ++sums)
    {
      *sums = MixBytes(*sums, row, edge, mask);
    }
  }
  for (std::size_t begin = 0; begin < length; begin += edge, ++sums)
  {
    const std::size_t texels = std::min(edge, length - begin);
    *sums = MixBytes(*sums, row + begin * bytesOfTexel, texels * bytesOfTexel, mask);
  }
}

/// Sums up one row of blocks.
template <typename Scalar>
void SumRowOfBlocks(const vtkTextureSlice::Rows<Scalar>& rows, const Box& box, std::uint64_t* sums)
{
  constexpr std::uint64_t all = ~std::uint64_t(0);
  for (int z = box.Begin[2]; z < box.End[2]; ++z)
  {
    for (int y = box.Begin[1]; y < box.End[1]; ++y)
    {
      MixRow(reinterpret_cast<const unsigned char*>(rows.GetScalars(y, z)), rows.Length,
        rows.Components * sizeof(Scalar), all, sums);
      if (const unsigned char* ghosts = rows.GetGhosts(y, z))
      {
        MixRow(ghosts, rows.Length, 1, all, sums);
      }
    }
  }
}

/// Joins a box to one of the boxes if together they are a box along that axis.
bool Join(std::vector<Box>& boxes, const Box& box, std::size_t axis)
{
  const auto continues = [&](const Box& other)
  {
    bool same = other.End[axis] == box.Begin[axis];
    for (std::size_t i = 0; i < 3; ++i)
    {
      same = same && (i == axis || (other.Begin[i] == box.Begin[i] && other.End[i] == box.End[i]));
    }
    return same;
  };
  const auto found = std::find_if(boxes.begin(), boxes.end(), continues);
  if (found == boxes.end())
  {
    return false;
  }
  found->End[axis] = box.End[axis];
  return true;
}

} // namespace

void vtkTextureSliceBlocks::Build(const vtkTextureSliceScalars& source)
{
  this->Size = source.Size;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    this->Count[axis] = (this->Size[axis] + Edge - 1) / Edge;
  }
  const vtkIdType rowsOfBlocks = static_cast<vtkIdType>(this->Count[1]) * this->Count[2];
  this->Checksums.assign(static_cast<std::size_t>(rowsOfBlocks * this->Count[0]), Seed);
  const auto sumUp = [&](const auto& rows)
  {
    vtkSMPTools::For(0, rowsOfBlocks,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType row = begin; row < end; ++row)
        {
          const int y = static_cast<int>(row % this->Count[1]) * Edge;
          const int z = static_cast<int>(row / this->Count[1]) * Edge;
          SumRowOfBlocks(rows,
            {{0, y, z}, {this->Size[0], std::min(y + Edge, this->Size[1]),
                          std::min(z + Edge, this->Size[2])}},
            this->Checksums.data() + row * this->Count[0]);
        }
      });
  };
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(sumUp(vtkTextureSlice::Rows<VTK_TT>(source)));
  }
}

void vtkTextureSliceBlocks::AddChangesOfLayer(
  const vtkTextureSliceBlocks& other, int layer, std::vector<Box>& boxes) const
{
  std::vector<Box> ofLayer;
  for (int y = 0; y < this->Count[1]; ++y)
  {
    std::vector<Box> ofRow;
    for (int x = 0; x < this->Count[0]; ++x)
    {
      if (this->DiffersAt(other, {x, y, layer}))
      {
        const Box box = this->GetBox({x, y, layer});
        if (!Join(ofRow, box, 0))
        {
          ofRow.push_back(box);
        }
      }
    }
    for (const Box& box : ofRow)
    {
      if (!Join(ofLayer, box, 1))
      {
        ofLayer.push_back(box);
      }
    }
  }
  boxes.insert(boxes.end(), ofLayer.begin(), ofLayer.end());
}

std::vector<Box> vtkTextureSliceBlocks::FindChanges(const vtkTextureSliceBlocks* other) const
{
  std::vector<Box> boxes;
  for (int layer = 0; layer < this->Count[2]; ++layer)
  {
    if (other != nullptr)
    {
      this->AddChangesOfLayer(*other, layer, boxes);
    }
    else
    {
      Box box = this->GetBox({this->Count[0] - 1, this->Count[1] - 1, layer});
      box.Begin[0] = box.Begin[1] = 0;
      boxes.push_back(box);
    }
  }
  return boxes;
}

bool vtkTextureSliceBlocks::DiffersAt(
  const vtkTextureSliceBlocks& other, const std::array<int, 3>& block) const
{
  const auto id = static_cast<std::size_t>(block[0]) +
                  static_cast<std::size_t>(this->Count[0]) *
                    (static_cast<std::size_t>(block[1]) + static_cast<std::size_t>(this->Count[1]) *
                                                            static_cast<std::size_t>(block[2]));
  return this->Checksums[id] != other.Checksums[id];
}

Box vtkTextureSliceBlocks::GetBox(const std::array<int, 3>& block) const
{
  Box box;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    box.Begin[axis] = block[axis] * Edge;
    box.End[axis] = std::min(box.Begin[axis] + Edge, this->Size[axis]);
  }
  return box;
}
