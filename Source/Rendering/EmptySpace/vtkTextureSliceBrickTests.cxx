// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTextureSliceBrickTests.h"

#include "vtkTextureSliceIntegralTable.h"
#include "vtkTextureSliceRequest.h"
#include "vtkTextureSliceTable.h"
#include "vtkTextureSliceTable2D.h"
#include "vtkTextureSliceTexture.h"
#include "vtkVolumeMapper.h"

#include <algorithm>
#include <limits>

namespace
{

using Range = vtkTextureSliceBricks::Range;
using Source = vtkTextureSliceEmptySpace::Source;
using vtkTextureSliceBrickTests::Test;

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
    return 0.5 / static_cast<double>(std::max(2, source.Table2D->GetWidth()) - 1);
  }
  if (!features.Slabs)
  {
    return 0.0;
  }
  const std::size_t width = features.Labels > 0
                              ? std::min(source.Table->GetWidth(), source.LabelTable->GetWidth())
                              : source.Table->GetWidth();
  return 1.0 / static_cast<double>(vtkTextureSliceIntegralTable::ChooseWidth(width) - 1);
}

/// The opacities of one component of a brick are above 0 somewhere.
Test MakeOpacityTest(const Source& source, const vtkTextureSliceFeatures& features, std::size_t row)
{
  const auto& components = source.Texture->GetComponents();
  // Dependent components take their opacity from the last one.
  const std::size_t component = features.Functions > 1 ? row : components.size() - 1;
  std::vector<const vtkTextureSliceVisibility*> visibilities{
    features.Table2D ? &source.Table2D->GetVisibility(row) : &source.Table->GetVisibility(row)};
  for (std::size_t label = 0; label < static_cast<std::size_t>(features.Labels); ++label)
  {
    visibilities.push_back(&source.LabelTable->GetVisibility(label));
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
    features.Functions > 1 ? Unbounded : FindScalarError(source.Texture->GetComponents().front());
  const auto [low, high] = source.Request->AverageRange;
  return [least = low - error, most = high + error](const Range* ranges)
  { return ranges->Low <= ranges->High && ranges->High >= least && ranges->Low <= most; };
}

/// A surface passes through the brick.
Test MakeSurfaceTest(const Source& source)
{
  const std::size_t component = source.Texture->GetComponents().size() - 1;
  const double error = FindScalarError(source.Texture->GetComponents()[component]);
  return [component, error, values = source.Request->GetIsoValues()](const Range* ranges)
  {
    const Range& range = ranges[component];
    const auto next = std::lower_bound(values.begin(), values.end(), range.Low - error);
    return range.Low <= range.High && next != values.end() && *next <= range.High + error;
  };
}

} // namespace

std::vector<Test> vtkTextureSliceBrickTests::Make(const Source& source)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
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
