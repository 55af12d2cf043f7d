// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Plan/PlanLayer.h"

#include <vtkImageActor.h>
#include <vtkImageData.h>
#include <vtkImageSliceMapper.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace nexrad::scene
{
namespace
{

// From dark violet over green to yellow: brightness grows evenly, also for eyes that do not tell
// red from green. The corners of a path through colour space, chosen by eye.
constexpr Colour sequence[] = {{0.27, 0.05, 0.36}, {0.26, 0.22, 0.50}, {0.20, 0.39, 0.55},
  {0.13, 0.55, 0.55}, {0.23, 0.70, 0.44}, {0.55, 0.82, 0.30}, {0.98, 0.90, 0.15}};

// Unlike each other and of like weight; after the last they begin again.
constexpr Colour categories[] = {{0.36, 0.60, 0.84}, {0.93, 0.58, 0.22}, {0.42, 0.70, 0.35},
  {0.84, 0.35, 0.38}, {0.62, 0.50, 0.80}, {0.66, 0.50, 0.42}, {0.88, 0.56, 0.78},
  {0.60, 0.60, 0.60}, {0.78, 0.76, 0.30}, {0.30, 0.74, 0.80}};

// The colour at a share of the way, 0…1.
Colour Along(double share)
{
  constexpr std::size_t last = std::size(sequence) - 1;
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(last);
  const std::size_t below = std::min(static_cast<std::size_t>(place), last - 1);
  const double part = place - static_cast<double>(below);
  Colour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
  {
    colour[i] = sequence[below][i] + part * (sequence[below + 1][i] - sequence[below][i]);
  }
  return colour;
}

double LargestOf(const PlanView& view)
{
  float largest = 0.0F;
  for (std::size_t i = 0; i < view.values.size(); ++i)
  {
    largest = view.states[i] == VoxelState::Echo ? std::max(largest, view.values[i]) : largest;
  }
  return static_cast<double>(largest);
}

// Bins of a round width from 0 up to the largest value, fifteen at most. Their colours go from one
// share of the way along the sequence to another.
ColourTable EvenBins(double largest, double atFirst, double atLast)
{
  double width = std::pow(10.0, std::floor(std::log10(std::max(largest, 1e-3) / 15.0)));
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
  {
    if (largest < 15.0 * factor * width)
    {
      width *= factor;
      break;
    }
  }
  const int count = std::max(2, static_cast<int>(std::floor(largest / width)) + 1);
  ColourTable bins;
  for (int i = 0; i < count; ++i)
  {
    const double share = static_cast<double>(i) / (count - 1);
    bins.push_back({width * i, Along(atFirst + share * (atLast - atFirst))});
  }
  return bins;
}

ColourScale RadarNumberScale(double largest)
{
  ColourScale scale;
  const int count = std::max(2, static_cast<int>(largest));
  for (int i = 1; i <= count; ++i)
  {
    scale.bins.push_back({static_cast<double>(i), Along(static_cast<double>(i - 1) / (count - 1))});
    scale.labels.push_back(std::to_string(i));
  }
  scale.unit = "radars";
  scale.title = "Number of radars that scanned";
  return scale;
}

ColourScale SiteScale(const std::vector<std::string>& sites)
{
  ColourScale scale;
  for (std::size_t i = 0; i < sites.size(); ++i)
  {
    scale.bins.push_back({static_cast<double>(i), categories[i % std::size(categories)]});
    scale.labels.push_back(sites[i]);
  }
  scale.unit = "radar";
  scale.title = "Nearest radar that scanned";
  return scale;
}

// Bins of given values, their colours along the sequence.
ColourTable BinsFrom(const std::vector<double>& values)
{
  ColourTable bins;
  for (const double value : values)
  {
    const double share = static_cast<double>(bins.size()) / static_cast<double>(values.size() - 1);
    bins.push_back({value, Along(share)});
  }
  return bins;
}

// One colour a kilometre, up to the tops of the highest storms.
ColourScale EchoTopScale(double threshold)
{
  ColourScale scale;
  scale.factor = 0.001;
  scale.bins = BinsFrom({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18});
  scale.unit = "km";
  scale.title = "Echo top at " + NumberWord(threshold) + " dBZ";
  return scale;
}

// Less than the first value is drizzle and clear air; from 25 to 30 kg/m² on, hail is looked for.
ColourScale LiquidScale()
{
  ColourScale scale;
  scale.bins = BinsFrom({0.5, 1, 2.5, 5, 10, 15, 20, 25, 30, 35, 40, 45, 50, 55, 60, 65, 70});
  scale.unit = "kg/m²";
  scale.title = "Vertically integrated liquid";
  return scale;
}

// Storms with large hail are sought from 3.5 g/m³ on (Amburn and Wolf 1997).
ColourScale LiquidDensityScale(double threshold)
{
  ColourScale scale;
  scale.bins = BinsFrom({0.25, 0.5, 0.75, 1, 1.25, 1.5, 1.75, 2, 2.5, 3, 3.5, 4, 4.5, 5, 6});
  scale.unit = "g/m³";
  scale.title = "VIL density, echo top at " + NumberWord(threshold) + " dBZ";
  return scale;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

} // namespace

ColourScale ScaleFor(const PlanView& view, const PlanOptions& plan,
  const std::vector<std::string>& sites, const ColourScale& moment)
{
  switch (plan.level)
  {
  case PlanLevel::EchoTop:
    return EchoTopScale(plan.threshold);
  case PlanLevel::Liquid:
    return LiquidScale();
  case PlanLevel::LiquidDensity:
    return LiquidDensityScale(plan.threshold);
  default:
    return ScaleFor(LargestOf(view), plan.array, sites, moment);
  }
}

ColourScale ScaleFor(double largest, const std::string& array,
  const std::vector<std::string>& sites, const ColourScale& moment)
{
  if (EndsWith(array, "_radars"))
  {
    return RadarNumberScale(largest);
  }
  if (EndsWith(array, "_site"))
  {
    return SiteScale(sites);
  }
  ColourScale scale;
  if (EndsWith(array, "_age"))
  {
    scale.factor = 1.0 / 60.0;
    scale.bins = EvenBins(largest * scale.factor, 1.0, 0.0);
    scale.unit = "min";
    scale.title = "Age of the nearest ray";
  }
  else if (EndsWith(array, "_weight"))
  {
    scale.bins = EvenBins(largest, 0.0, 1.0);
    scale.unit = "weight";
    scale.title = "Sum of the radars' weights";
  }
  else
  {
    return moment;
  }
  return scale;
}

namespace
{

// None where the ground is seen.
std::optional<Colour> ColourOf(
  const PlanView& view, const ColourScale& scale, std::size_t column, const Theme& theme)
{
  switch (view.states[column])
  {
  case VoxelState::NotScanned:
    return theme.notScanned;
  case VoxelState::RangeFolded:
    return scale.rangeFolded.value_or(theme.rangeFolded);
  case VoxelState::Filtered:
    return theme.filtered;
  case VoxelState::NoEcho:
    return std::nullopt;
  default:
    return ColourAt(scale, static_cast<double>(view.values[column]));
  }
}

bool Holds(const PlanView& view, VoxelState state)
{
  return std::find(view.states.begin(), view.states.end(), state) != view.states.end();
}

} // namespace

vtkSmartPointer<vtkProp> MakePlanLayer(const PlanView& view, const ColourScale& scale,
  vtkImageData* placed, double height, const Theme& theme)
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(view.width, view.height, 1);
  picture->SetOrigin(placed->GetOrigin()[0], placed->GetOrigin()[1], height);
  picture->SetSpacing(placed->GetSpacing()[0], placed->GetSpacing()[1], 1.0);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (std::size_t column = 0; column < view.values.size(); ++column)
  {
    const std::optional<Colour> colour = ColourOf(view, scale, column, theme);
    for (const double component : colour.value_or(Colour()))
    {
      *pixel++ = ToByte(component);
    }
    *pixel++ = colour ? 255 : 0;
  }
  auto actor = vtkSmartPointer<vtkImageActor>::New();
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(picture);
  mapper->BorderOn(); // whole voxels at the edges as well
  actor->SetMapper(mapper);
  actor->InterpolateOff();
  return actor;
}

std::string PlanKey(const PlanView& view, const ColourScale& scale)
{
  std::string key;
  for (const auto& [state, text] : StateTexts)
  {
    const bool ofTable = state == VoxelState::RangeFolded && scale.rangeFolded;
    const std::string words = ofTable ? "RF of the colour table: range folded" : text;
    key += Holds(view, state) ? (key.empty() ? "" : ", ") + words : "";
  }
  return key;
}

} // namespace nexrad::scene
