// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceOpaqueCells.h"

namespace
{

int CountSquares(int pixels, int size)
{
  return (pixels + size - 1) / size;
}

} // namespace

vtkTextureSliceOpaqueCells::vtkTextureSliceOpaqueCells(
  const vtkTextureSlicePixels& part, int needed)
  : Part(part)
  , Needed(needed)
{
  constexpr int largest = CellSize << (Levels - 1);
  const int columns = CountSquares(part.Right - part.Left, largest);
  const int rows = CountSquares(part.Top - part.Bottom, largest);
  for (std::size_t level = 0; level < Levels; ++level)
  {
    const auto finer = static_cast<int>(Levels - 1 - level);
    this->OpaqueIn[level].assign(static_cast<std::size_t>((columns << finer) * (rows << finer)), 0);
  }
  this->Layers.assign(this->OpaqueIn[0].size(), 0);
}

std::size_t vtkTextureSliceOpaqueCells::GetLevel(const vtkTextureSlicePixels& square)
{
  std::size_t level = 0;
  while (CellSize << level < square.Right - square.Left)
  {
    ++level;
  }
  return level;
}

std::size_t vtkTextureSliceOpaqueCells::GetIndex(std::size_t level, int x, int y) const
{
  constexpr int largest = CellSize << (Levels - 1);
  const auto shift = static_cast<int>(level);
  const int columns = CountSquares(this->Part.Right - this->Part.Left, largest)
                      << (Levels - 1 - level);
  return static_cast<std::size_t>(((y - this->Part.Bottom) / CellSize >> shift) * columns +
                                  ((x - this->Part.Left) / CellSize >> shift));
}

void vtkTextureSliceOpaqueCells::AddLayer(const vtkTextureSlicePixels& square)
{
  for (int y = square.Bottom; y < square.Top; y += CellSize)
  {
    for (int x = square.Left; x < square.Right; x += CellSize)
    {
      if (++this->Layers[this->GetIndex(0, x, y)] != this->Needed)
      {
        continue;
      }
      for (std::size_t level = 0; level < Levels; ++level)
      {
        ++this->OpaqueIn[level][this->GetIndex(level, x, y)];
      }
    }
  }
}

bool vtkTextureSliceOpaqueCells::AreAllOpaque(const vtkTextureSlicePixels& square) const
{
  const std::size_t level = GetLevel(square);
  const int cells = 1 << (2 * level);
  return this->OpaqueIn[level][this->GetIndex(level, square.Left, square.Bottom)] == cells;
}

bool vtkTextureSliceOpaqueCells::IsAnyOpaque(const vtkTextureSlicePixels& square) const
{
  const std::size_t level = GetLevel(square);
  return this->OpaqueIn[level][this->GetIndex(level, square.Left, square.Bottom)] > 0;
}
