// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceOpaqueCells.h"

namespace
{

constexpr int Multiple = 64;

std::size_t CountCells(int pixels)
{
  return static_cast<std::size_t>(
    (pixels + Multiple - 1) / Multiple * (Multiple / vtkTextureSliceOpaqueCells::CellSize));
}

} // namespace

vtkTextureSliceOpaqueCells::vtkTextureSliceOpaqueCells(const std::array<int, 2>& size, int needed)
  : Needed(needed)
  , Columns(CountCells(size[0]))
  , Layers(CountCells(size[0]) * CountCells(size[1]), 0)
{
}

/// Calls visit(cell) until it returns false.
template <typename Visit>
void vtkTextureSliceOpaqueCells::ForEach(const vtkTextureSlicePixels& pixels, Visit visit) const
{
  for (int y = pixels.Bottom / CellSize; y < pixels.Top / CellSize; ++y)
  {
    for (int x = pixels.Left / CellSize; x < pixels.Right / CellSize; ++x)
    {
      if (!visit(static_cast<std::size_t>(y) * this->Columns + static_cast<std::size_t>(x)))
      {
        return;
      }
    }
  }
}

void vtkTextureSliceOpaqueCells::AddLayer(const vtkTextureSlicePixels& pixels)
{
  this->ForEach(pixels,
    [this](std::size_t cell)
    {
      this->Any = ++this->Layers[cell] >= this->Needed || this->Any;
      return true;
    });
}

bool vtkTextureSliceOpaqueCells::AreAllOpaque(const vtkTextureSlicePixels& pixels) const
{
  bool all = this->Any;
  if (all)
  {
    this->ForEach(
      pixels, [&](std::size_t cell) { return all = this->Layers[cell] >= this->Needed; });
  }
  return all;
}

bool vtkTextureSliceOpaqueCells::IsAnyOpaque(const vtkTextureSlicePixels& pixels) const
{
  bool none = true;
  if (this->Any)
  {
    this->ForEach(
      pixels, [&](std::size_t cell) { return none = this->Layers[cell] < this->Needed; });
  }
  return !none;
}
