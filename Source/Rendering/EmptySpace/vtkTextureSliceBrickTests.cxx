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
#include <utility>

namespace
{

using Range = vtkTextureSliceBricks::Range;
using Source = vtkTextureSliceEmptySpace::Source;
using Test = vtkTextureSliceBrickTests::Test;

/// What the graphics hardware may err by in a scalar, of the width of the scalars' range.
constexpr double ScalarError = 1e-5;

bool HasSamples(const Range& range)
{
  return range.Low <= range.High;
}

/// Tells whether the opacities of one component of a brick are above 0 somewhere.
struct OpacityTest
{
  std::size_t Component;
  double Low;    ///< where the functions' domain begins
  double Scale;  ///< one over its width
  double Margin; ///< scalars beyond a brick's range that count as well, of that width
  std::vector<const vtkTextureSliceVisibility*> Visibilities;
  int BlendMode;

  bool operator()(const Range* ranges) const
  {
    Range range = ranges[this->Component];
    if (!HasSamples(range))
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

std::vector<Test> MakeOpacityTests(const Source& source, const vtkTextureSliceFeatures& features)
{
  const auto& components = source.Texture->GetComponents();
  std::vector<Test> tests;
  for (std::size_t i = 0; i < static_cast<std::size_t>(features.Functions); ++i)
  {
    // Dependent components take their opacity from the last one.
    const std::size_t component = features.Functions > 1 ? i : components.size() - 1;
    const auto [low, high] = components[component].Range;
    OpacityTest test{component, low, low < high ? 1.0 / (high - low) : 1.0,
      vtkTextureSliceBrickTests::GetMargin(source),
      {features.Table2D ? &source.Table2D->GetVisibility(i) : &source.Table->GetVisibility(i)},
      features.BlendMode};
    for (std::size_t label = 0; label < static_cast<std::size_t>(features.Labels); ++label)
    {
      test.Visibilities.push_back(&source.LabelTable->GetVisibility(label));
    }
    tests.emplace_back(std::move(test));
  }
  return tests;
}

/// The brick has samples that an average counts.
Test MakeAverageTest(const Source& source, const vtkTextureSliceFeatures& features)
{
  const auto [low, high] = source.Texture->GetComponents().front().Range;
  const double error = ScalarError * (high - low);
  // Of several components with functions of their own, an average counts all samples.
  const double unbounded = std::numeric_limits<double>::infinity();
  const bool all = features.Functions > 1;
  const double least = all ? -unbounded : source.Request->AverageRange[0] - error;
  const double most = all ? unbounded : source.Request->AverageRange[1] + error;
  return [least, most](const Range* ranges)
  { return HasSamples(*ranges) && ranges->High >= least && ranges->Low <= most; };
}

/// A surface passes through the brick.
Test MakeSurfaceTest(const Source& source)
{
  const std::size_t component = source.Texture->GetComponents().size() - 1;
  const auto [low, high] = source.Texture->GetComponents()[component].Range;
  return [component, error = ScalarError * (high - low), values = source.Request->GetIsoValues()](
           const Range* ranges)
  {
    const Range& range = ranges[component];
    const auto next = std::lower_bound(values.begin(), values.end(), range.Low - error);
    return HasSamples(range) && next != values.end() && *next <= range.High + error;
  };
}

} // namespace

double vtkTextureSliceBrickTests::GetMargin(const Source& source)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
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

std::vector<Test> vtkTextureSliceBrickTests::Make(const Source& source)
{
  const vtkTextureSliceFeatures features = source.Request->GetFeatures();
  switch (features.BlendMode)
  {
  case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
    return {MakeAverageTest(source, features)};
  case vtkVolumeMapper::ISOSURFACE_BLEND:
    return {MakeSurfaceTest(source)};
  default:
    return MakeOpacityTests(source, features);
  }
}
