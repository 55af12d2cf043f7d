// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceEmptySpace.h"

#include "vtkTextureSliceFrame.h"
#include "vtkTextureSliceRequest.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTexture.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <array>

namespace
{

using Range = vtkTextureSliceBricks::Range;

/// Whether samples that the functions make invisible can be left out.
bool CanSkip(const vtkTextureSliceFeatures& features)
{
  switch (features.BlendMode)
  {
  case vtkVolumeMapper::COMPOSITE_BLEND:
    // A two-dimensional function's table is not kept by scalars alone.
    return !features.Table2D;
  case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
  case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
    return true;
  default:
    // Averages and sums count samples of any opacity; a surface lies between two samples, which may
    // be in two bricks.
    return false;
  }
}

/// Whether the table alone decides on a sample's opacity.
bool IsTableAlone(const vtkTextureSliceEmptySpace::Source& source)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
  return features.BlendMode == vtkVolumeMapper::COMPOSITE_BLEND && features.Functions == 1 &&
         !features.Table2D && !features.GradientOpacity && !features.HasMask() &&
         !source.Texture->IsMasked() && !source.Frame->NeedsCropTest();
}

/// How far from its scalars a slab looks at the table, of the width of the functions' domain: half
/// an entry, so that its window is at least one entry wide.
double GetMargin(const vtkTextureSliceEmptySpace::Source& source)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
  if (features.Slabs == 0)
  {
    return 0.0;
  }
  const std::size_t width = features.Labels > 0
                              ? std::min(source.Table->GetWidth(), source.LabelTable->GetWidth())
                              : source.Table->GetWidth();
  return 0.5 / static_cast<double>(width - 1);
}

/// Tells whether one component of a brick can be seen.
struct ComponentTest
{
  std::size_t Component;
  double Low;    ///< where the functions' domain begins
  double Scale;  ///< one over its width
  double Margin; ///< scalars beyond a brick's range that count as well, of that width
  std::vector<const vtkTextureSliceVisibility*> Visibilities;
  int BlendMode;

  bool IsVisible(const Range* ranges) const
  {
    Range range = ranges[this->Component];
    if (range.Low > range.High)
    {
      return false;
    }
    const double unbounded = std::numeric_limits<double>::infinity();
    // A brick of which all scalars are invisible may still hide a lesser extreme that is visible;
    // it is without effect only if everything below (or above) its scalars is invisible too.
    range.Low =
      this->BlendMode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ? -unbounded : range.Low;
    range.High =
      this->BlendMode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND ? unbounded : range.High;
    return std::any_of(this->Visibilities.begin(), this->Visibilities.end(),
      [&](const vtkTextureSliceVisibility* visibility)
      {
        return visibility->IsVisible((range.Low - this->Low) * this->Scale - this->Margin,
          (range.High - this->Low) * this->Scale + this->Margin);
      });
  }
};

std::vector<ComponentTest> MakeTests(
  const vtkTextureSliceEmptySpace::Source& source, const vtkTextureSliceFeatures& features)
{
  const auto& components = source.Texture->GetComponents();
  std::vector<ComponentTest> tests;
  for (std::size_t i = 0; i < static_cast<std::size_t>(features.Functions); ++i)
  {
    // Dependent components take their opacity from the last one.
    const std::size_t component = features.Functions > 1 ? i : components.size() - 1;
    const auto [low, high] = components[component].Range;
    ComponentTest test{component, low, low < high ? 1.0 / (high - low) : 1.0, GetMargin(source),
      {&source.Table->GetVisibility(i)}, features.BlendMode};
    for (std::size_t label = 0; label < static_cast<std::size_t>(features.Labels); ++label)
    {
      test.Visibilities.push_back(&source.LabelTable->GetVisibility(label));
    }
    tests.push_back(std::move(test));
  }
  return tests;
}

/// For each brick along an axis, one bit for each of the three parts between the cropping planes
/// that it touches.
std::vector<unsigned int> FindParts(
  const vtkTextureSliceFrame& frame, const vtkTextureSliceBricks& bricks, std::size_t axis)
{
  const double scale = static_cast<double>(frame.GetTextureScale()[axis]);
  const double bias = static_cast<double>(frame.GetTextureBias()[axis]);
  const double low = static_cast<double>(frame.GetCropLow()[axis]);
  const double high = static_cast<double>(frame.GetCropHigh()[axis]);
  constexpr double margin = 1e-5; // what a sample's position may err by
  std::vector<unsigned int> parts;
  for (int brick = 0; brick < bricks.GetCount()[axis]; ++brick)
  {
    const double begin = brick * bricks.GetEdge()[axis] * scale + bias - margin;
    const double end = (brick + 1) * bricks.GetEdge()[axis] * scale + bias + margin;
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
    source.LabelTable->GetFillTime(), source.Request->GetFeatures().GetDefines(),
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
  this->Skips = CanSkip(source.Request->GetFeatures());
  const bool crops = source.Frame->NeedsCropTest();
  this->FindDense(source);
  if (!this->Skips && !crops)
  {
    return;
  }
  const vtkTextureSliceBricks& bricks = source.Texture->GetBricks();
  this->FindVisible(source);
  if (crops)
  {
    this->HideCropped(source);
  }
  this->Occupancy.Build(bricks.GetCount(), bricks.GetEdge(), this->Visible);
  this->Skips = true;
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
  const double margin = GetMargin(source);
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
    this->Dense.Build(bricks.GetCount(), bricks.GetEdge(), this->Visible);
  }
}

void vtkTextureSliceEmptySpace::FindVisible(const Source& source)
{
  const std::vector<Range>& ranges = source.Texture->GetBricks().GetRanges();
  const std::size_t components = source.Texture->GetComponents().size();
  this->Visible.assign(ranges.size() / components, 1);
  if (!this->Skips)
  {
    return;
  }
  const std::vector<ComponentTest> tests = MakeTests(source, source.Request->GetFeatures());
  for (std::size_t brick = 0; brick < this->Visible.size(); ++brick)
  {
    const auto visible = [&](const ComponentTest& test)
    { return test.IsVisible(ranges.data() + brick * components); };
    this->Visible[brick] = std::any_of(tests.begin(), tests.end(), visible) ? 1 : 0;
  }
}

void vtkTextureSliceEmptySpace::HideCropped(const Source& source)
{
  const vtkTextureSliceBricks& bricks = source.Texture->GetBricks();
  const auto alongX = FindParts(*source.Frame, bricks, 0);
  const auto alongY = FindParts(*source.Frame, bricks, 1);
  const auto alongZ = FindParts(*source.Frame, bricks, 2);
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
