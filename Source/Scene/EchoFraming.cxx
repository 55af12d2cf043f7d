// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/EchoFraming.h"

#include "Filters/Series/VolumeSeries.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/PlacedMap.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/System/Error.h"
#include "vtkNexradTransferFunction.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace nexrad::scene
{
namespace
{

using Box = std::array<double, 6>; // in scene units, heights not stretched

// The preset alone, or that of the moment where it draws surfaces.
vtkSmartPointer<vtkNexradTransferFunction> PresetOf(
  const SceneOptions& options, const std::string& array)
{
  SceneOptions preset;
  preset.preset = options.preset;
  auto function = MakeTransferFunction(preset, array);
  return function->GetNumberOfIsoValues() > 0 ? MakeTransferFunction(SceneOptions(), array)
                                              : function;
}

// Whether the frame or the opacities go by the echo.
bool NeedsEcho(const SceneOptions& options)
{
  return !options.plan && (options.framing == FrameChoice::Echo || !options.opacityDistance);
}

void AddMargin(Box& box)
{
  constexpr double part = 0.04;
  const double margin = part * std::max(box[1] - box[0], box[3] - box[2]);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    box[2 * axis] -= margin;
    box[2 * axis + 1] += margin;
  }
}

// A single shower is seen with some ground about it.
void WidenTo(double least, Box& box)
{
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    const double missing = std::max(least - (box[2 * axis + 1] - box[2 * axis]), 0.0);
    box[2 * axis] -= 0.5 * missing;
    box[2 * axis + 1] += 0.5 * missing;
  }
}

// Takes in the radars that make the box little larger.
void AddRadars(const SceneFrame& frame, const std::vector<std::string>& sites, Box& box)
{
  constexpr double most = 1.3; // times the area
  const auto area = [](const Box& of) { return (of[1] - of[0]) * (of[3] - of[2]); };
  for (const PlacedSite& site : PlaceSites(frame, sites))
  {
    const auto [x, y] = site.place;
    const Box larger = {std::min(box[0], x), std::max(box[1], x), std::min(box[2], y),
      std::max(box[3], y), box[4], box[5]};
    box = site.within && area(larger) <= most * area(box) ? larger : box;
  }
}

// The box that the camera looks at.
Box Around(const EchoExtent& echo, const SceneFrame& frame, const std::vector<std::string>& sites)
{
  constexpr double leastWidth = 40.0; // km
  constexpr double leastHeight = 4.0;
  constexpr double aboveEcho = 0.5;
  const auto lower = frame.ToScene({echo.box[0], echo.box[2], echo.box[4]});
  const auto upper = frame.ToScene({echo.box[1], echo.box[3], echo.box[5]});
  const double bottom = frame.Bounds()[4];
  Box box = {lower[0], upper[0], lower[1], upper[1], bottom,
    std::max(std::ceil(upper[2] + aboveEcho), bottom + leastHeight)};
  WidenTo(leastWidth, box);
  AddRadars(frame, sites, box);
  AddMargin(box);
  return box;
}

} // namespace

std::optional<EchoExtent> MeasureEcho(vtkImageData* volume, const SceneOptions& options)
{
  return NeedsEcho(options) ? FindExtent(volume, PresetOf(options, ArrayOf(volume))) : std::nullopt;
}

std::optional<EchoExtent> MeasureSeries(
  VolumeSeries& series, const std::vector<std::size_t>& steps, const SceneOptions& options)
{
  constexpr std::size_t most = 8;
  const std::size_t count = std::min(most, NeedsEcho(options) ? steps.size() : 0);
  std::optional<EchoExtent> all;
  for (std::size_t i = 0; count > 1 && i < count; ++i)
  {
    try
    {
      const auto volume = series.LoadCoarse(steps[i * (steps.size() - 1) / (count - 1)]);
      const auto echo = volume ? MeasureEcho(volume, options) : std::nullopt;
      all = all && echo ? Join(*all, *echo) : (echo ? echo : all);
    }
    catch (const Error&)
    {
      continue;
    }
  }
  return all;
}

SceneFrame FrameVolume(vtkImageData* volume, const VolumeInformation& information,
  const std::optional<EchoExtent>& echo, const SceneOptions& options)
{
  const SceneFrame toScale(volume, information, 1.0);
  const bool aboutEcho = echo && options.framing == FrameChoice::Echo && !options.plan;
  const Box box = aboutEcho ? Around(*echo, toScale, information.sites) : toScale.Bounds();
  SceneFrame framed = toScale;
  const auto lower = toScale.ToVolume({box[0], box[2], box[4]});
  const auto upper = toScale.ToVolume({box[1], box[3], box[5]});
  const Box inVolume = {lower[0], upper[0], lower[1], upper[1], lower[2], upper[2]};
  framed.SetFramed(inVolume);
  const auto& [west, east, south, north, bottom, top] = framed.Framed();
  SceneFrame frame(volume, information,
    options.exaggeration.value_or(
      DefaultExaggeration(std::sqrt((east - west) * (north - south)), top - bottom)));
  frame.SetFramed(inVolume);
  frame.SetOpacityDistance(options.opacityDistance.value_or(
    echo && !options.plan ? OpacityDistanceOf(*echo, frame.Exaggeration()) : OpacityUnitDistance));
  return frame;
}

} // namespace nexrad::scene
