// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceEmptySpace.h"

#include "vtkSMPTools.h"
#include "vtkTextureSliceBrickTests.h"
#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceRequest.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTable2D.h"
#include "vtkTextureSliceTexture.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <array>

namespace
{

/// For each brick along an axis, the regions (one bit each) between the
/// cropping planes that it touches, whatever the other axes.
std::vector<unsigned int> FindRegions(
  const vtkTextureSliceFrame& frame, const vtkTextureSliceBricks& bricks, std::size_t axis)
{
  constexpr std::array<std::array<unsigned int, 3>, 3> parts{
    {{0x1249249, 0x2492492, 0x4924924}, {0x1C0E07, 0xE07038, 0x70381C0},
      {0x1FF, 0x3FE00, 0x7FC0000}}}; // of 27 bits, those of the lower, middle and upper part
  const double scale = static_cast<double>(frame.GetTextureScale()[axis]);
  const double bias = static_cast<double>(frame.GetTextureBias()[axis]);
  const double low = static_cast<double>(frame.GetCropLow()[axis]);
  const double high = static_cast<double>(frame.GetCropHigh()[axis]);
  constexpr double margin = 1e-5; // what a sample's position may err by
  std::vector<unsigned int> regions;
  for (int brick = 0; brick < bricks.GetCount()[axis]; ++brick)
  {
    const double begin = brick * bricks.GetEdge()[axis] * scale + bias - margin;
    const double end = (brick + 1) * bricks.GetEdge()[axis] * scale + bias + margin;
    regions.push_back((begin < low ? parts[axis][0] : 0U) |
                      (end >= low && begin <= high ? parts[axis][1] : 0U) |
                      (end > high ? parts[axis][2] : 0U));
  }
  return regions;
}

} // namespace

vtkTextureSliceEmptySpace::Key vtkTextureSliceEmptySpace::MakeKey(const Source& source)
{
  return {source.Texture->GetBricks().GetBuildTime(), source.Table->GetFillTime(),
    source.LabelTable->GetFillTime(), source.Table2D->GetFillTime(), source.Request->AverageRange,
    source.Request->GetIsoValues(), source.Request->GetFeatures().GetDefines(),
    source.Frame->NeedsCropTest(), source.Frame->GetCropLow(), source.Frame->GetCropHigh(),
    source.CropFlags};
}

void vtkTextureSliceEmptySpace::Update(const Source& source)
{
  Key key = MakeKey(source);
  if (key == this->Last)
  {
    return;
  }
  this->Last = std::move(key);
  const std::vector<unsigned char> before = this->Visible;
  this->FindVisible(source);
  if (source.Frame->NeedsCropTest())
  {
    this->HideCropped(source);
  }
  const vtkTextureSliceBricks& bricks = source.Texture->GetBricks();
  if (this->Visible == before && bricks.GetEdge() == this->Edge)
  {
    return; // another colour, or another opacity of what is visible
  }
  this->Edge = bricks.GetEdge();
  this->Distances.Build(bricks.GetCount(), this->Edge, this->Visible);
  this->Seen = this->Distances.FindSeen();
}

void vtkTextureSliceEmptySpace::FindVisible(const Source& source)
{
  const std::vector<vtkTextureSliceBricks::Range>& ranges = source.Texture->GetBricks().GetRanges();
  const std::size_t components = source.Texture->GetComponents().size();
  this->Visible.resize(ranges.size() / components);
  const auto tests = vtkTextureSliceBrickTests::Make(source);
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Visible.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto brick = static_cast<std::size_t>(begin); brick < static_cast<std::size_t>(end);
           ++brick)
      {
        const auto* const own = ranges.data() + brick * components;
        // Bricks without echoes have the ranges of those before them.
        if (static_cast<vtkIdType>(brick) > begin &&
            std::equal(own, own + components, own - components))
        {
          this->Visible[brick] = this->Visible[brick - 1];
          continue;
        }
        const bool visible = std::any_of(tests.begin(), tests.end(),
          [own](const vtkTextureSliceBrickTests::Test& test) { return test(own); });
        this->Visible[brick] = visible ? 1 : 0;
      }
    });
}

void vtkTextureSliceEmptySpace::HideCropped(const Source& source)
{
  const vtkTextureSliceBricks& bricks = source.Texture->GetBricks();
  const auto alongX = FindRegions(*source.Frame, bricks, 0);
  const auto alongY = FindRegions(*source.Frame, bricks, 1);
  const auto alongZ = FindRegions(*source.Frame, bricks, 2);
  auto visible = this->Visible.begin();
  for (const unsigned int z : alongZ)
  {
    for (const unsigned int y : alongY)
    {
      for (const unsigned int x : alongX)
      {
        const bool kept = (x & y & z & static_cast<unsigned int>(source.CropFlags)) != 0;
        *visible = kept ? *visible : 0;
        ++visible;
      }
    }
  }
}
