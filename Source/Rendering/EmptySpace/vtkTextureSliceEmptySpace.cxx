// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceEmptySpace.h"

#include "vtkTextureSliceBrickTests.h"
#include "vtkTextureSliceCoordinates.h"
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

using Range = vtkTextureSliceBricks::Range;

/// Whether the table alone decides on a sample's opacity.
bool IsTableAlone(const vtkTextureSliceEmptySpace::Source& source)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
  return features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && features.Functions == 1 &&
         !features.Table2D && !features.GradientOpacity && !features.HasMask() &&
         !source.Texture->IsMasked() && !source.Frame->NeedsCropTest();
}

/// For each brick between two borders along an axis, one bit for each of the three parts between
/// the cropping planes that it touches.
std::vector<unsigned int> FindParts(
  const vtkTextureSliceFrame& frame, const std::vector<double>& borders, std::size_t axis)
{
  const double scale = static_cast<double>(frame.GetTextureScale()[axis]);
  const double bias = static_cast<double>(frame.GetTextureBias()[axis]);
  const double low = static_cast<double>(frame.GetCropLow()[axis]);
  const double high = static_cast<double>(frame.GetCropHigh()[axis]);
  constexpr double margin = 1e-5; // what a sample's position may err by
  std::vector<unsigned int> parts;
  for (std::size_t brick = 0; brick + 1 < borders.size(); ++brick)
  {
    const double begin = borders[brick] * scale + bias - margin;
    const double end = borders[brick + 1] * scale + bias + margin;
    parts.push_back(
      (begin < low ? 1U : 0U) | (end >= low && begin <= high ? 2U : 0U) | (end > high ? 4U : 0U));
  }
  return parts;
}

/// Whether some region that a brick touches is drawn.
bool IsKept(const std::array<unsigned int, 3>& parts, int cropFlags)
{
  for (unsigned int region = 0; region < 27; ++region)
  {
    const bool touched = (parts[0] >> region % 3 & 1U) != 0 &&
                         (parts[1] >> region / 3 % 3 & 1U) != 0 &&
                         (parts[2] >> region / 9 & 1U) != 0;
    if (touched && (static_cast<unsigned int>(cropFlags) >> region & 1U) != 0)
    {
      return true;
    }
  }
  return false;
}

} // namespace

vtkTextureSliceEmptySpace::Key vtkTextureSliceEmptySpace::MakeKey(const Source& source)
{
  return {source.Texture->GetBricks().GetBuildTime(), source.Table->GetFillTime(),
    source.LabelTable->GetFillTime(), source.Table2D->GetFillTime(), source.Request->AverageRange,
    source.Request->GetIsoValues(), source.Request->GetFeatures().GetDefines(),
    source.Frame->NeedsCropTest(), source.Frame->GetCropLow(), source.Frame->GetCropHigh(),
    source.CropFlags, source.Coordinates->GetBuildTime()};
}

void vtkTextureSliceEmptySpace::Update(const Source& source)
{
  Key key = MakeKey(source);
  if (key == this->Last)
  {
    return;
  }
  this->Last = std::move(key);
  this->FindDense(source);
  this->FindVisible(source);
  if (source.Frame->NeedsCropTest())
  {
    this->HideCropped(source);
  }
  this->Build(source, this->Occupancy);
}

std::array<std::vector<double>, 3> vtkTextureSliceEmptySpace::FindBorders(const Source& source)
{
  const vtkTextureSliceBricks& bricks = source.Texture->GetBricks();
  std::array<std::vector<double>, 3> borders;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    for (int brick = 0; brick <= bricks.GetCount()[axis]; ++brick)
    {
      const double part = brick * bricks.GetEdge()[axis];
      borders[axis].push_back(
        source.Coordinates->IsUsed() ? source.Coordinates->ToBox(axis, part) : part);
    }
  }
  return borders;
}

void vtkTextureSliceEmptySpace::Build(const Source& source, vtkTextureSliceOccupancy& occupancy)
{
  const vtkTextureSliceBricks& bricks = source.Texture->GetBricks();
  occupancy.Build(bricks.GetCount(), bricks.GetEdge(), this->Visible);
  if (source.Coordinates->IsUsed())
  {
    occupancy.SetBorders(FindBorders(source), source.Coordinates->GetMargin());
  }
}

void vtkTextureSliceEmptySpace::FindDense(const Source& source)
{
  this->HasDense = false;
  if (!IsTableAlone(source))
  {
    return;
  }
  const vtkTextureSliceBricks& bricks = source.Texture->GetBricks();
  const std::size_t components = source.Texture->GetComponents().size();
  const auto [low, high] = source.Texture->GetComponents().back().Range;
  const double scale = low < high ? 1.0 / (high - low) : 1.0;
  const double margin = vtkTextureSliceBrickTests::GetMargin(source);
  this->Visible.clear();
  for (std::size_t i = components - 1; i < bricks.GetRanges().size(); i += components)
  {
    const Range& range = bricks.GetRanges()[i];
    const bool dense = !source.Table->GetThin(0).IsVisible(
      (range.Low - low) * scale - margin, (range.High - low) * scale + margin);
    this->Visible.push_back(dense ? 1 : 0);
    this->HasDense = this->HasDense || dense;
  }
  if (this->HasDense)
  {
    this->Build(source, this->Dense);
  }
}

void vtkTextureSliceEmptySpace::FindVisible(const Source& source)
{
  const std::vector<Range>& ranges = source.Texture->GetBricks().GetRanges();
  const std::size_t components = source.Texture->GetComponents().size();
  this->Visible.resize(ranges.size() / components);
  this->LeavesOut = false;
  const std::vector<vtkTextureSliceBrickTests::Test> tests =
    vtkTextureSliceBrickTests::Make(source);
  for (std::size_t brick = 0; brick < this->Visible.size(); ++brick)
  {
    const Range* const own = ranges.data() + brick * components;
    const bool visible = std::any_of(tests.begin(), tests.end(),
      [own](const vtkTextureSliceBrickTests::Test& test) { return test(own); });
    this->Visible[brick] = visible ? 1 : 0;
    this->LeavesOut = this->LeavesOut || (!visible && own->Low <= own->High);
  }
}

void vtkTextureSliceEmptySpace::HideCropped(const Source& source)
{
  const std::array<std::vector<double>, 3> borders = FindBorders(source);
  const auto alongX = FindParts(*source.Frame, borders[0], 0);
  const auto alongY = FindParts(*source.Frame, borders[1], 1);
  const auto alongZ = FindParts(*source.Frame, borders[2], 2);
  auto visible = this->Visible.begin();
  for (const unsigned int z : alongZ)
  {
    for (const unsigned int y : alongY)
    {
      for (const unsigned int x : alongX)
      {
        *visible = *visible != 0 && IsKept({x, y, z}, source.CropFlags) ? 1 : 0;
        ++visible;
      }
    }
  }
}
