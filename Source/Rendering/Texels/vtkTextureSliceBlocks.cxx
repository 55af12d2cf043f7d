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

/// Takes bytes into a sum, the last word filled with zeros.
std::uint64_t MixBytes(std::uint64_t sum, const unsigned char* bytes, std::size_t count)
{
  constexpr std::size_t size = sizeof(std::uint64_t);
  for (std::size_t i = 0; i < count; i += size)
  {
    std::uint64_t word = 0;
    i + size <= count ? std::memcpy(&word, bytes + i, size)
                      : std::memcpy(&word, bytes + i, count - i);
    const std::uint64_t product = (sum ^ word) * Factor;
    sum = product ^ (product >> 32);
  }
  return sum;
}

/// Takes a row of texels into the sums of the blocks along it.
void MixRow(
  const unsigned char* row, std::size_t length, std::size_t bytesOfTexel, std::uint64_t* sums)
{
  constexpr auto edge = static_cast<std::size_t>(Edge);
  for (std::size_t begin = 0; begin < length; begin += edge, ++sums)
  {
    const std::size_t texels = std::min(edge, length - begin);
    *sums = MixBytes(*sums, row + begin * bytesOfTexel, texels * bytesOfTexel);
  }
}

/// Sums up one row of blocks.
template <typename Scalar>
void SumRowOfBlocks(const vtkTextureSlice::Rows<Scalar>& rows, const Box& box, std::uint64_t* sums)
{
  for (int z = box.Begin[2]; z < box.End[2]; ++z)
  {
    for (int y = box.Begin[1]; y < box.End[1]; ++y)
    {
      MixRow(reinterpret_cast<const unsigned char*>(rows.GetScalars(y, z)), rows.Length,
        rows.Components * sizeof(Scalar), sums);
      if (const unsigned char* ghosts = rows.GetGhosts(y, z))
      {
        MixRow(ghosts, rows.Length, 1, sums);
      }
    }
  }
}

/// Adds a box, or extends one with the same texels along x that ends where it begins along y.
void Add(const Box& box, std::vector<Box>& boxes)
{
  const auto before = std::find_if(boxes.begin(), boxes.end(),
    [&box](const Box& other)
    {
      return other.Begin[0] == box.Begin[0] && other.End[0] == box.End[0] &&
             other.End[1] == box.Begin[1];
    });
  before != boxes.end() ? static_cast<void>(before->End[1] = box.End[1]) : boxes.push_back(box);
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
        for (auto row = static_cast<int>(begin); row < static_cast<int>(end); ++row)
        {
          SumRowOfBlocks(rows,
            this->GetBox(0, this->Count[0] - 1, row % this->Count[1], row / this->Count[1]),
            this->Checksums.data() + std::ptrdiff_t{row} * this->Count[0]);
        }
      });
  };
  switch (source.Scalars->GetDataType())
  {
    vtkTemplateMacro(sumUp(vtkTextureSlice::Rows<VTK_TT>(source)));
  }
}

std::vector<Box> vtkTextureSliceBlocks::FindChanges(const vtkTextureSliceBlocks* other) const
{
  std::vector<Box> boxes;
  std::size_t row = 0; // the first block of a row of blocks
  for (int z = 0; z < this->Count[2]; ++z)
  {
    std::vector<Box> ofLayer;
    for (int y = 0; y < this->Count[1]; ++y, row += static_cast<std::size_t>(this->Count[0]))
    {
      int unchanged = -1; // the last block that is as in the other volume
      for (int x = 0; x <= this->Count[0]; ++x)
      {
        const std::size_t block = row + static_cast<std::size_t>(x);
        if (x < this->Count[0] &&
            (other == nullptr || this->Checksums[block] != other->Checksums[block]))
        {
          continue;
        }
        if (unchanged + 1 < x)
        {
          Add(this->GetBox(unchanged + 1, x - 1, y, z), ofLayer);
        }
        unchanged = x;
      }
    }
    boxes.insert(boxes.end(), ofLayer.begin(), ofLayer.end());
  }
  return boxes;
}

Box vtkTextureSliceBlocks::GetBox(int first, int last, int y, int z) const
{
  const auto end = [this](int block, std::size_t axis)
  { return std::min((block + 1) * Edge, this->Size[axis]); };
  return {{first * Edge, y * Edge, z * Edge}, {end(last, 0), end(y, 1), end(z, 2)}};
}
