// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/MapFiles.h"

#include "Drawing/GeoTiff.h"
#include "Drawing/VolumeOutputs.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Plan/PlanLayer.h"
#include "Scene/Plan/PlanView.h"
#include "Scene/VolumeAppearance.h"
#include "nexrad/Model/Moment.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradThreads.h"
#include "vtkNexradTransferFunction.h"

#include <vtkImageData.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

namespace nexrad::scene
{
namespace
{

// What the values of a map are, and their unit.
std::pair<std::string, std::string> TermsOf(
  const PlanOptions& plan, const PlanView& view, MomentName moment)
{
  std::ostringstream threshold;
  threshold << plan.threshold << " dBZ";
  if (plan.level == PlanLevel::EchoTop)
  {
    return {"Echo top above mean sea level, " + threshold.str(), "m"};
  }
  if (plan.level == PlanLevel::LiquidDensity)
  {
    return {"VIL density: vertically integrated liquid through the height of the echo top, " +
              threshold.str(),
      "g/m^3"};
  }
  if (plan.level == PlanLevel::Liquid)
  {
    return {"Vertically integrated liquid", "kg/m^2"};
  }
  const std::string array = plan.array.empty() ? ToString(moment) : plan.array;
  const bool ofMoment = array == ToString(moment);
  const std::string title = ofMoment ? TitleOf(moment) : array;
  const std::string unit = ofMoment                                     ? UnitOf(moment)
                           : array == AncillaryArrayName(moment, "age") ? "s"
                                                                        : "";
  return {title + ". " + view.where, unit};
}

// The colours of a picture of the map. What has no value is transparent, but for range folding.
std::vector<std::array<unsigned char, 4>> ColoursOf(
  const PlanView& view, const ColourScale& scale, const Theme& theme)
{
  std::vector<std::array<unsigned char, 4>> colours(view.values.size());
  for (std::size_t i = 0; i < colours.size(); ++i)
  {
    std::optional<Colour> colour;
    if (view.states[i] == VoxelState::Echo)
    {
      colour = ColourAt(scale, static_cast<double>(view.values[i]));
    }
    else if (view.states[i] == VoxelState::RangeFolded)
    {
      colour = scale.rangeFolded.value_or(theme.rangeFolded);
    }
    if (colour)
    {
      std::transform(colour->begin(), colour->end(), colours[i].begin(),
        [](double part) { return static_cast<unsigned char>(std::lround(255.0 * part)); });
      colours[i][3] = 255;
    }
  }
  return colours;
}

GeoMap MapOf(vtkImageData* volume, const SceneOptions& options)
{
  const PlanOptions& plan = options.plan.value();
  const PlanSource source = SourceOf(volume);
  PlanView view = MakePlanView(source, plan, vtkNexradRangeLoop());
  const VolumeInformation information = ReadVolumeInformation(volume);
  GeoMap map;
  map.grid = vtkNexradImageToGrid(volume);
  std::tie(map.title, map.unit) = TermsOf(plan, view, source.voxels.moment);
  map.time = information.time.value_or(Time());
  map.synthetic = information.synthetic;
  const std::string array = ToString(source.voxels.moment);
  const ColourScale moment = ScaleOf(array, MakeTransferFunction(options, array));
  map.colours =
    ColoursOf(view, ScaleFor(view, plan, information.sites, moment), ThemeOf(options.theme));
  map.values = std::move(view.values);
  map.states = std::move(view.states);
  return map;
}

} // namespace

RenderReport WriteMaps(const RenderRequest& request)
{
  const auto write = [&request](const std::filesystem::path& path, vtkImageData* volume)
  { WriteGeoTiff(path, MapOf(volume, request.scene)); };
  return WriteEachVolume(request, write);
}

} // namespace nexrad::scene
