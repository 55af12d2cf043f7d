// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceDistanceMap.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"

#include <algorithm>

namespace
{

/// Along a line of bricks whose distances hold across it: those that hold along it as well.
void SpreadLine(const std::vector<unsigned char>& before, std::vector<unsigned char>& after)
{
  const int length = static_cast<int>(before.size());
  for (int i = 0; i < length; ++i)
  {
    int best = before[static_cast<std::size_t>(i)];
    for (int way = 1; way < best; ++way)
    {
      const int low = i >= way ? before[static_cast<std::size_t>(i - way)] : best;
      const int high = i + way < length ? before[static_cast<std::size_t>(i + way)] : best;
      best = std::min(best, std::max(way, std::min(low, high)));
    }
    after[static_cast<std::size_t>(i)] = static_cast<unsigned char>(best);
  }
}

} // namespace

void vtkTextureSliceDistanceMap::Build(const std::array<int, 3>& count,
  const std::array<double, 3>& edge, const std::vector<unsigned char>& visible)
{
  this->Count = count;
  this->Edge = edge;
  this->Distances.resize(visible.size());
  std::transform(visible.begin(), visible.end(), this->Distances.begin(),
    [](unsigned char brick) { return brick != 0 ? 0 : MostDistance; });
  const auto seen = std::count(this->Distances.begin(), this->Distances.end(), 0);
  this->VisibleShare =
    static_cast<double>(seen) / static_cast<double>(std::max<std::size_t>(1, visible.size()));
  if (seen > 0)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Spread(axis);
    }
  }
  this->Uploaded = false;
}

void vtkTextureSliceDistanceMap::Spread(std::size_t axis)
{
  const std::array<std::size_t, 3> strides{1, static_cast<std::size_t>(this->Count[0]),
    static_cast<std::size_t>(this->Count[0]) * static_cast<std::size_t>(this->Count[1])};
  const std::size_t other = axis == 0 ? 1 : 0;
  const std::size_t last = axis == 2 ? 1 : 2;
  const auto length = static_cast<std::size_t>(this->Count[axis]);
  vtkSMPTools::For(0, this->Count[last],
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<unsigned char> before(length);
      std::vector<unsigned char> after(length);
      for (vtkIdType line = begin * this->Count[other]; line < end * this->Count[other]; ++line)
      {
        unsigned char* const first =
          this->Distances.data() +
          static_cast<std::size_t>(line % this->Count[other]) * strides[other] +
          static_cast<std::size_t>(line / this->Count[other]) * strides[last];
        for (std::size_t i = 0; i < length; ++i)
        {
          before[i] = first[i * strides[axis]];
        }
        SpreadLine(before, after);
        for (std::size_t i = 0; i < length; ++i)
        {
          first[i * strides[axis]] = after[i];
        }
      }
    });
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
  program->SetUniformi("distanceMap", this->Texture->GetTextureUnit());
  program->SetUniform3f("brickScale", scale.data());
  program->SetUniform3f("brickBias", bias.data());
  program->SetUniform3f("lastBrick", last.data());
}
