// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceEmptySpace.h"

#include "vtkSMPTools.h"
#include "vtkTextureSliceUniforms.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace
{

using Range = vtkTextureSliceBricks::Range;
using Source = vtkTextureSliceUniforms;

/// Whether a brick counts, by the ranges of its scalars, one for each component.
using Test = std::function<bool(const Range* ranges)>;

constexpr double Unbounded = std::numeric_limits<double>::infinity();

/// What the graphics hardware may err by in a scalar.
double FindScalarError(const vtkTextureSliceComponent& component)
{
  return 1e-5 * (component.Range[1] - component.Range[0]);
}

/// How far from its scalars a sample looks at the table, of the width of the functions' domain.
double FindMargin(const Source& source, const vtkTextureSliceFeatures& features)
{
  if (features.Table2D)
  {
    // Its entries lie in the middle of equal parts of the domain.
    return 0.5 / static_cast<double>(std::max(2, source.Table2D.GetWidth()) - 1);
  }
  if (!features.Slabs)
  {
    return 0.0;
  }
  const std::size_t width = features.Labels > 0
                              ? std::min(source.Table.GetWidth(), source.LabelTable.GetWidth())
                              : source.Table.GetWidth();
  return 1.0 / static_cast<double>(vtkTextureSliceIntegralTable::ChooseWidth(width) - 1);
}

/// The opacities of one component of a brick are above 0 somewhere.
Test MakeOpacityTest(const Source& source, const vtkTextureSliceFeatures& features, std::size_t row)
{
  const auto& components = source.Texture.GetComponents();
  // Dependent components take their opacity from the last one.
  const std::size_t component = features.Functions > 1 ? row : components.size() - 1;
  std::vector<const vtkTextureSliceVisibility*> visibilities{
    features.Table2D ? &source.Table2D.GetVisibility(row) : &source.Table.GetVisibility(row)};
  for (std::size_t label = 0; label < static_cast<std::size_t>(features.Labels); ++label)
  {
    visibilities.push_back(&source.LabelTable.GetVisibility(label));
  }
  const auto [least, most] = components[component].Range;
  // A brick of which all scalars are invisible may still hide a lesser extreme that is visible; it
  // is without effect only if everything below (or above) its scalars is invisible too.
  const double below =
    features.BlendMode == vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND ? Unbounded : 0.0;
  const double above =
    features.BlendMode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND ? Unbounded : 0.0;
  return [=, begin = least, margin = FindMargin(source, features),
           scale = least < most ? 1.0 / (most - least) : 1.0](const Range* ranges)
  {
    const Range& range = ranges[component];
    const double low = (range.Low - below - begin) * scale - margin;
    const double high = (range.High + above - begin) * scale + margin;
    return range.Low <= range.High && std::any_of(visibilities.begin(), visibilities.end(),
                                        [&](const vtkTextureSliceVisibility* visibility)
                                        { return visibility->IsVisible(low, high); });
  };
}

/// The brick has samples that an average counts.
Test MakeAverageTest(const Source& source, const vtkTextureSliceFeatures& features)
{
  // Of several components with functions of their own, an average counts all samples.
  const double error =
    features.Functions > 1 ? Unbounded : FindScalarError(source.Texture.GetComponents().front());
  const auto [low, high] = source.Request.AverageRange;
  return [least = low - error, most = high + error](const Range* ranges)
  { return ranges->Low <= ranges->High && ranges->High >= least && ranges->Low <= most; };
}

/// A surface passes through the brick.
Test MakeSurfaceTest(const Source& source)
{
  const std::size_t component = source.Texture.GetComponents().size() - 1;
  const double error = FindScalarError(source.Texture.GetComponents()[component]);
  return [component, error, values = source.Request.GetIsoValues()](const Range* ranges)
  {
    const Range& range = ranges[component];
    const auto next = std::lower_bound(values.begin(), values.end(), range.Low - error);
    return range.Low <= range.High && next != values.end() && *next <= range.High + error;
  };
}

/// A brick counts if one of these is true.
std::vector<Test> MakeTests(const Source& source)
{
  const vtkTextureSliceFeatures features = source.Request.GetFeatures();
  if (features.BlendMode == vtkVolumeMapper::AVERAGE_INTENSITY_BLEND)
  {
    return {MakeAverageTest(source, features)};
  }
  if (features.BlendMode == vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    return {MakeSurfaceTest(source)};
  }
  std::vector<Test> tests;
  for (std::size_t row = 0; row < static_cast<std::size_t>(features.Functions); ++row)
  {
    tests.push_back(MakeOpacityTest(source, features, row));
  }
  return tests;
}

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
  return {source.Texture.GetBricks().GetBuildTime(), source.Table.GetFillTime(),
    source.LabelTable.GetFillTime(), source.Table2D.GetFillTime(), source.Request.AverageRange,
    source.Request.GetIsoValues(), source.Request.GetFeatures().GetDefines(),
    source.Frame.NeedsCropTest(), source.Frame.GetCropLow(), source.Frame.GetCropHigh(),
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
  if (source.Frame.NeedsCropTest())
  {
    this->HideCropped(source);
  }
  const vtkTextureSliceBricks& bricks = source.Texture.GetBricks();
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
  const std::vector<vtkTextureSliceBricks::Range>& ranges = source.Texture.GetBricks().GetRanges();
  const std::size_t components = source.Texture.GetComponents().size();
  this->Visible.resize(ranges.size() / components);
  const auto tests = MakeTests(source);
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
        const bool visible =
          std::any_of(tests.begin(), tests.end(), [own](const Test& test) { return test(own); });
        this->Visible[brick] = visible ? 1 : 0;
      }
    });
}

void vtkTextureSliceEmptySpace::HideCropped(const Source& source)
{
  const vtkTextureSliceBricks& bricks = source.Texture.GetBricks();
  const auto alongX = FindRegions(source.Frame, bricks, 0);
  const auto alongY = FindRegions(source.Frame, bricks, 1);
  const auto alongZ = FindRegions(source.Frame, bricks, 2);
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
