// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceDistanceMap.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkSMPTools.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceOpenGL.h"

#include <algorithm>

namespace
{

constexpr unsigned char Most = vtkTextureSliceDistanceMap::MostDistance;

/// One row of bricks.
struct Row
{
  const unsigned char* Visible;
  unsigned char* Distances;
  int Length;
  int ToNext; ///< 1 or -1: where rays go
};

/// Distances of a row, from its far end back: one more than the least of the seven bricks ahead.
/// @param beside distances of the three rows ahead.
/// @param nearest, limits room for Length + 2 and for Length numbers.
void FillRow(const Row& row, const std::array<const unsigned char*, 3>& beside,
  unsigned char* nearest, unsigned char* limits)
{
  const auto [besideY, besideZ, besideBoth] = beside;
  nearest[0] = nearest[row.Length + 1] = Most;
  for (int x = 0; x < row.Length; ++x)
  {
    nearest[x + 1] = std::min(std::min(besideY[x], besideZ[x]), besideBoth[x]);
  }
  for (int x = 0; x < row.Length; ++x)
  {
    const unsigned char clear = std::min(nearest[x + 1], nearest[x + 1 + row.ToNext]);
    const auto further = static_cast<unsigned char>(clear + (clear < Most ? 1 : 0));
    limits[x] = row.Visible[x] != 0 ? static_cast<unsigned char>(0) : further;
  }
  int distance = Most;
  int x = row.ToNext > 0 ? row.Length - 1 : 0;
  for (int i = 0; i < row.Length; ++i, x -= row.ToNext)
  {
    distance = std::min(distance + 1, static_cast<int>(limits[x]));
    row.Distances[x] = static_cast<unsigned char>(distance);
  }
}

} // namespace

void vtkTextureSliceDistanceMap::Build(const std::array<int, 3>& count,
  const std::array<double, 3>& edge, const std::vector<unsigned char>& visible)
{
  this->Count = count;
  this->Edge = edge;
  this->Distances.resize(Octants * visible.size());
  vtkSMPTools::For(0, Octants,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType octant = begin; octant < end; ++octant)
      {
        this->Fill(static_cast<unsigned int>(octant), visible);
      }
    });
  const auto seen =
    visible.size() - static_cast<std::size_t>(std::count(visible.begin(), visible.end(), 0));
  this->VisibleShare =
    static_cast<double>(seen) / static_cast<double>(std::max<std::size_t>(1, visible.size()));
  this->Uploaded = false;
}

void vtkTextureSliceDistanceMap::Fill(
  unsigned int octant, const std::vector<unsigned char>& visible)
{
  const auto [length, height, layers] = this->Count;
  unsigned char* const map = this->Distances.data() + octant * visible.size();
  const auto along = [octant](unsigned int axis) { return (octant >> axis & 1) != 0 ? -1 : 1; };
  const auto begin = [this](int y, int z)
  { return static_cast<std::size_t>(z * this->Count[1] + y) * this->Count[0]; };
  const std::vector<unsigned char> outside(static_cast<std::size_t>(length), Most);
  const auto rowAt = [&](int y, int z)
  {
    const bool inside = y >= 0 && y < this->Count[1] && z >= 0 && z < this->Count[2];
    return inside ? map + begin(y, z) : outside.data();
  };
  std::vector<unsigned char> nearest(static_cast<std::size_t>(length) + 2);
  std::vector<unsigned char> limits(static_cast<std::size_t>(length));
  for (int iz = 0; iz < layers; ++iz)
  {
    const int z = along(2) > 0 ? layers - 1 - iz : iz;
    for (int iy = 0; iy < height; ++iy)
    {
      const int y = along(1) > 0 ? height - 1 - iy : iy;
      FillRow({visible.data() + begin(y, z), map + begin(y, z), length, along(0)},
        {rowAt(y + along(1), z), rowAt(y, z + along(2)), rowAt(y + along(1), z + along(2))},
        nearest.data(), limits.data());
    }
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
  vtkTextureSliceSetSampling(this->Texture, true);
  this->Texture->Create3DFromRaw(static_cast<unsigned int>(this->Count[0]),
    static_cast<unsigned int>(this->Count[1]), static_cast<unsigned int>(Octants * this->Count[2]),
    1, VTK_UNSIGNED_CHAR, this->Distances.data());
  this->Uploaded = true;
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
