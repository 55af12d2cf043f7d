// SPDX-License-Identifier: BSD-3-Clause
#include "Drawing/MapFiles.h"

#include "Drawing/GeoTiff.h"
#include "Drawing/VolumeOutputs.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Plan/PlanView.h"
#include "nexrad/Model/Moment.h"
#include "vtkNexradImageConversion.h"
#include "vtkNexradThreads.h"

#include <vtkImageData.h>

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

GeoMap MapOf(vtkImageData* volume, const PlanOptions& plan)
{
  const PlanSource source = SourceOf(volume);
  PlanView view = MakePlanView(source, plan, vtkNexradRangeLoop());
  const VolumeInformation information = ReadVolumeInformation(volume);
  GeoMap map;
  map.grid = vtkNexradImageToGrid(volume);
  std::tie(map.title, map.unit) = TermsOf(plan, view, source.voxels.moment);
  map.time = information.time.value_or(Time());
  map.synthetic = information.synthetic;
  map.values = std::move(view.values);
  map.states = std::move(view.states);
  return map;
}

} // namespace

RenderReport WriteMaps(const RenderRequest& request)
{
  const auto write = [&request](const std::filesystem::path& path, vtkImageData* volume)
  { WriteGeoTiff(path, MapOf(volume, request.scene.plan.value())); };
  return WriteEachVolume(request, write);
}

} // namespace nexrad::scene
