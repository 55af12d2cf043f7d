// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceDistanceMap.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"

#include <algorithm>
#include <cstddef>

namespace
{

/// Bricks that are one further than the nearest of four rows of bricks, or than the brick before
/// them in the row.
void Spread(unsigned char* row, std::ptrdiff_t length, const std::array<std::ptrdiff_t, 4>& rows,
  std::ptrdiff_t step, std::vector<unsigned char>& nearest)
{
  const auto one = [](unsigned char distance) { return static_cast<unsigned char>(distance + 1); };
  for (std::ptrdiff_t i = -1; i <= length; ++i)
  {
    const unsigned char* near = row + i;
    nearest[static_cast<std::size_t>(i + 1)] =
      std::min(std::min(near[rows[0]], near[rows[1]]), std::min(near[rows[2]], near[rows[3]]));
  }
  const unsigned char* around = nearest.data() + 1;
  for (std::ptrdiff_t i = 0; i < length; ++i)
  {
    row[i] = std::min(row[i], one(std::min(around[i], std::min(around[i - 1], around[i + 1]))));
  }
  unsigned char* brick = step > 0 ? row : row + length - 1;
  unsigned char before = brick[-step];
  for (std::ptrdiff_t i = 0; i < length; ++i, brick += step)
  {
    before = *brick = std::min(*brick, one(before));
  }
}

/// Distances of bricks, with a frame one brick wide about them (Rosenfeld and Pfaltz 1968): from
/// the bricks before each one, then from those after it.
void Spread(const std::array<int, 3>& count, unsigned char* framed)
{
  const std::ptrdiff_t row = count[0] + 2;
  const std::ptrdiff_t layer = row * (count[1] + 2);
  const int rows = count[1] * count[2];
  std::vector<unsigned char> nearest(static_cast<std::size_t>(row));
  for (const int step : {1, -1})
  {
    for (int i = 0; i < rows; ++i)
    {
      const int place = step > 0 ? i : rows - 1 - i;
      unsigned char* const first =
        framed + (place / count[1] + 1) * layer + (place % count[1] + 1) * row + 1;
      Spread(first, count[0],
        {-step * (layer + row), -step * layer, -step * (layer - row), -step * row}, step, nearest);
    }
  }
}

} // namespace

void vtkTextureSliceDistanceMap::Build(const std::array<int, 3>& count,
  const std::array<double, 3>& edge, const std::vector<unsigned char>& visible)
{
  this->Count = count;
  this->Edge = edge;
  this->Uploaded = false;
  const auto seen =
    visible.size() - static_cast<std::size_t>(std::count(visible.begin(), visible.end(), 0));
  this->VisibleShare =
    static_cast<double>(seen) / static_cast<double>(std::max<std::size_t>(1, visible.size()));
  const auto length = static_cast<std::size_t>(count[0]);
  const auto height = static_cast<std::size_t>(count[1]);
  const std::size_t row = length + 2;
  std::vector<unsigned char> framed(
    row * (height + 2) * static_cast<std::size_t>(count[2] + 2), MostDistance);
  const auto framedRow = [&](std::size_t at)
  { return framed.data() + ((at / height + 1) * (height + 2) + at % height + 1) * row + 1; };
  this->Distances.resize(visible.size());
  for (std::size_t i = 0; i * length < visible.size(); ++i)
  {
    std::transform(visible.data() + i * length, visible.data() + (i + 1) * length, framedRow(i),
      [](unsigned char brick) { return brick != 0 ? 0 : MostDistance; });
  }
  Spread(count, framed.data());
  for (std::size_t i = 0; i * length < visible.size(); ++i)
  {
    std::copy_n(framedRow(i), length, this->Distances.data() + i * length);
  }
}

std::array<double, 6> vtkTextureSliceDistanceMap::FindSeen() const
{
  std::array<int, 6> bricks{this->Count[0], -1, this->Count[1], -1, this->Count[2], -1};
  const unsigned char* distance = this->Distances.data();
  for (int z = 0; z < this->Count[2]; ++z)
  {
    for (int y = 0; y < this->Count[1]; ++y)
    {
      for (int x = 0; x < this->Count[0]; ++x, ++distance)
      {
        const std::array<int, 3> brick{x, y, z};
        for (std::size_t axis = 0; axis < 3 && *distance == 0; ++axis)
        {
          bricks[2 * axis] = std::min(bricks[2 * axis], brick[axis]);
          bricks[2 * axis + 1] = std::max(bricks[2 * axis + 1], brick[axis]);
        }
      }
    }
  }
  std::array<double, 6> seen{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    seen[2 * axis] = bricks[2 * axis] * this->Edge[axis];
    seen[2 * axis + 1] = std::min(1.0, (bricks[2 * axis + 1] + 1) * this->Edge[axis]);
  }
  return seen;
}

void vtkTextureSliceDistanceMap::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->Uploaded && this->Texture->GetContext() == window && this->Texture->GetHandle() != 0)
  {
    return;
  }
  this->Texture->SetContext(window);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->Create3DFromRaw(static_cast<unsigned int>(this->Count[0]),
    static_cast<unsigned int>(this->Count[1]), static_cast<unsigned int>(this->Count[2]), 1,
    VTK_UNSIGNED_CHAR, this->Distances.data());
  this->Uploaded = true;
}

void vtkTextureSliceDistanceMap::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->Uploaded = false;
}

void vtkTextureSliceDistanceMap::SetUniforms(
  vtkShaderProgram* program, const vtkTextureSliceFrame& frame) const
{
  std::array<float, 3> scale{};
  std::array<float, 3> bias{};
  std::array<float, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    scale[axis] = 1.0f / (static_cast<float>(this->Edge[axis]) * frame.GetTextureScale()[axis]);
    bias[axis] = -frame.GetTextureBias()[axis] * scale[axis];
    last[axis] = static_cast<float>(this->Count[axis] - 1);
  }
  program->SetUniform3f("brickScale", scale.data());
  program->SetUniform3f("brickBias", bias.data());
  program->SetUniform3f("lastBrick", last.data());
}
