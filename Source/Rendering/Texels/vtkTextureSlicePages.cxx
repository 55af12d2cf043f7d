// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSlicePages.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureSliceOpenGL.h"

#include <algorithm>
#include <map>

namespace
{

/// Between the texels of a page: smaller ones follow the data closely, but share more texels.
constexpr int IntervalsOfPage = 16;
/// What a byte of the table can count.
constexpr int MostSlots = 256;

std::array<float, 3> ToFloats(const std::array<int, 3>& numbers)
{
  return {
    static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])};
}

} // namespace

void vtkTextureSlicePages::Divide(const std::array<int, 3>& size, int intervalsOfBrick)
{
  this->Size = size;
  this->BricksOfPage = std::max(1, IntervalsOfPage / intervalsOfBrick);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int intervals = std::max(1, size[axis] - 1);
    this->Intervals[axis] = std::min(this->BricksOfPage * intervalsOfBrick, intervals);
    this->Texels[axis] = std::min(this->Intervals[axis] + 1, size[axis]);
    this->Count[axis] = (intervals + this->Intervals[axis] - 1) / this->Intervals[axis];
  }
  this->Boxes.clear();
  this->Places.clear();
  this->Entries.clear();
}

bool vtkTextureSlicePages::Build(
  const std::array<int, 3>& size, const vtkTextureSliceBricks& bricks, int most)
{
  this->Divide(size, bricks.Intervals);
  std::map<std::vector<double>, int> uniform;
  std::vector<int> numbers; // of each page of the volume, which place of the atlas it has
  const int pages = this->Count[0] * this->Count[1] * this->Count[2];
  for (int number = 0; number < pages; ++number)
  {
    const std::array<int, 3> page{number % this->Count[0], number / this->Count[0] % this->Count[1],
      number / (this->Count[0] * this->Count[1])};
    const auto scalars = this->FindScalars(page, bricks);
    const auto next = static_cast<int>(this->Boxes.size());
    const int place = scalars ? uniform.emplace(*scalars, next).first->second : next;
    if (place == next)
    {
      this->Boxes.push_back(this->BoxOf(page));
    }
    numbers.push_back(place);
  }
  return this->Place(numbers, most);
}

bool vtkTextureSlicePages::Place(const std::vector<int>& numbers, int most)
{
  std::array<int, 3> slots{}; // of the atlas along each axis: as few as they can be, z first
  auto left = static_cast<int>(this->Boxes.size());
  for (const std::size_t axis : {2, 1, 0})
  {
    int others = 1; // that the axes may have which are not chosen yet
    for (std::size_t other = 0; other < axis; ++other)
    {
      others *= std::min(MostSlots, most / this->Texels[other]);
    }
    slots[axis] = others > 0 ? (left + others - 1) / others : MostSlots + 1;
    left = (left + slots[axis] - 1) / slots[axis];
    if (slots[axis] > std::min(MostSlots, most / this->Texels[axis]))
    {
      return false;
    }
    this->AtlasSize[axis] = slots[axis] * this->Texels[axis];
  }
  const auto slotOf = [&slots](int number)
  {
    return std::array<int, 3>{
      number % slots[0], number / slots[0] % slots[1], number / (slots[0] * slots[1])};
  };
  for (std::size_t number = 0; number < this->Boxes.size(); ++number)
  {
    const std::array<int, 3> slot = slotOf(static_cast<int>(number));
    this->Places.push_back(
      {slot[0] * this->Texels[0], slot[1] * this->Texels[1], slot[2] * this->Texels[2]});
  }
  for (const int number : numbers)
  {
    const std::array<int, 3> slot = slotOf(number);
    this->Entries.push_back({static_cast<unsigned char>(slot[0]),
      static_cast<unsigned char>(slot[1]), static_cast<unsigned char>(slot[2]), 0});
  }
  return true;
}

std::optional<std::vector<double>> vtkTextureSlicePages::FindScalars(
  const std::array<int, 3>& page, const vtkTextureSliceBricks& bricks) const
{
  std::array<int, 3> first{};
  std::array<int, 3> end{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    first[axis] = page[axis] * this->BricksOfPage;
    end[axis] =
      page[axis] + 1 < this->Count[axis] ? first[axis] + this->BricksOfPage : bricks.Count[axis];
  }
  std::optional<std::vector<double>> scalars;
  for (int z = first[2]; z < end[2]; ++z)
  {
    for (int y = first[1]; y < end[1]; ++y)
    {
      for (int x = first[0]; x < end[0]; ++x)
      {
        const auto own = bricks.FindScalars({x, y, z});
        if (!own || (scalars && *scalars != *own))
        {
          return std::nullopt;
        }
        scalars = own;
      }
    }
  }
  return scalars;
}

vtkTextureSliceBlocks::Box vtkTextureSlicePages::BoxOf(const std::array<int, 3>& page) const
{
  Box box{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    // The last page along an axis has all its texels too: it shares more of them.
    box.Begin[axis] =
      std::min(page[axis] * this->Intervals[axis], this->Size[axis] - this->Texels[axis]);
    box.End[axis] = box.Begin[axis] + this->Texels[axis];
  }
  return box;
}

void vtkTextureSlicePages::Upload(vtkOpenGLRenderWindow* window)
{
  this->Table->SetContext(window);
  vtkTextureSliceSetSampling(this->Table, true);
  this->Table->Create3DFromRaw(static_cast<unsigned int>(this->Count[0]),
    static_cast<unsigned int>(this->Count[1]), static_cast<unsigned int>(this->Count[2]), 4,
    VTK_UNSIGNED_CHAR, this->Entries.data());
}

void vtkTextureSlicePages::SetUniforms(vtkShaderProgram* program) const
{
  const std::array<int, 3> last{this->Count[0] - 1, this->Count[1] - 1, this->Count[2] - 1};
  program->SetUniform3f("volumeTexels", ToFloats(this->Size).data());
  program->SetUniform3f("pageIntervals", ToFloats(this->Intervals).data());
  program->SetUniform3f("pageTexels", ToFloats(this->Texels).data());
  program->SetUniform3f("lastPage", ToFloats(last).data());
  program->SetUniform3f("atlasTexels", ToFloats(this->AtlasSize).data());
}
