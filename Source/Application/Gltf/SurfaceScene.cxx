// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/SurfaceScene.h"

#include "Gltf/GroundMeshes.h"
#include "Gltf/IsoSurface.h"
#include "Gltf/MeshBuilder.h"
#include "Scene/EchoFraming.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/RadarScene.h"
#include "Scene/VolumeAppearance.h"
#include "Scene/VolumeCut.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/System/Error.h"
#include "vtkNexradTransferFunction.h"

#include <vtkImageData.h>
#include <vtkPlaneCollection.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace nexrad::scene
{
namespace
{

// The preset "iso-values" of reflectivity where the options name nothing.
SceneOptions WithSurfaces(SceneOptions options, MomentName moment)
{
  const bool nothing = options.isoValues.empty() && options.preset.empty() &&
                       options.colours.empty() && options.opacities.empty();
  if (nothing && moment == MomentName::REF)
  {
    options.preset = "iso-values";
  }
  return options;
}

// The values whose surfaces are wanted, each with its opacity, the most opaque first: a program
// that draws meshes in their order draws the outer surfaces over the inner ones.
std::vector<IsoValue> WantedValues(
  const SceneOptions& options, vtkNexradTransferFunction* transferFunction)
{
  std::vector<IsoValue> values = WithOpacities(options.isoValues);
  if (values.empty())
  {
    for (int i = 0; i < transferFunction->GetNumberOfIsoValues(); ++i)
    {
      const double value = transferFunction->GetIsoValue(i);
      values.push_back(
        {value, transferFunction->Evaluate(vtkNexradTransferFunction::OPACITY, value)});
    }
  }
  if (values.empty())
  {
    throw Error("no surfaces are named; write their values with --iso-values, as in 20:0.3,40");
  }
  std::stable_sort(values.begin(), values.end(),
    [](const IsoValue& a, const IsoValue& b) { return *a.opacity > *b.opacity; });
  return values;
}

// "REF 20 dBZ".
std::string NameOf(MomentName moment, double value)
{
  const std::string unit = UnitOf(moment);
  std::ostringstream name;
  name << ToString(moment) << ' ' << value << (unit.empty() ? "" : " ") << unit;
  return name.str();
}

Colour ColourAt(vtkNexradTransferFunction* transferFunction, double value)
{
  Colour colour{};
  transferFunction->GetSurfaceColor(value, colour.data());
  return colour;
}

// The surfaces, also those without a triangle.
std::vector<GlbMesh> MakeSurfaces(
  vtkImageData* volume, MomentName moment, const SceneOptions& options, const SceneFrame& frame)
{
  const SceneOptions shown = WithSurfaces(options, moment);
  const auto transferFunction = MakeTransferFunction(shown, ToString(moment));
  const std::vector<IsoValue> wanted = WantedValues(shown, transferFunction);
  const SurfaceMaker maker(volume, frame);
  const auto planes = CutPlanesOf(options.cut, frame);
  std::vector<GlbMesh> surfaces;
  for (const auto& [value, opacity] : wanted)
  {
    MeshBuilder surface(
      NameOf(moment, value), GlbShape::Triangles, ColourAt(transferFunction, value), *opacity);
    surface.Add(maker.Make(value, planes));
    surface.SetExtras({{"moment", ToString(moment)}, {"value", value}, {"unit", UnitOf(moment)},
      {"opacity", *opacity}, {"triangles", surface.Triangles()}});
    surfaces.push_back(surface.Take());
  }
  return surfaces;
}

// "Reflectivity, 2006-03-12 18:05:00 UTC".
std::string CaptionOf(MomentName moment, const std::optional<Time>& time)
{
  constexpr std::size_t ofDay = 10;
  constexpr std::size_t ofTime = 8;
  const std::string iso = time ? FormatIso8601(*time) : "";
  return TitleOf(moment) +
         (time ? ", " + iso.substr(0, ofDay) + " " + iso.substr(ofDay + 1, ofTime) + " UTC" : "");
}

nlohmann::json ExtrasOf(const VolumeInformation& information, MomentName moment,
  const SceneFrame& frame, const std::vector<GlbMesh>& surfaces)
{
  nlohmann::json extras = {{"moment", ToString(moment)}, {"radars", information.sites},
    {"method", information.method}, {"projection", information.projection},
    {"synthetic", information.synthetic}, {"vertical_exaggeration", frame.Exaggeration()},
    {"axes", "m: x to the east, y up from mean sea level, z to the south"}};
  if (information.time)
  {
    extras["time_utc"] = FormatIso8601(*information.time);
  }
  if (frame.HasMap())
  {
    const auto [longitude, latitude] = frame.Geographic(0.0, 0.0);
    extras["origin"] = {{"latitude", latitude}, {"longitude", longitude}};
  }
  for (const GlbMesh& surface : surfaces)
  {
    extras["surfaces"].push_back(surface.extras);
  }
  return extras;
}

} // namespace

GlbScene MakeSurfaceScene(vtkImageData* volume, const SceneOptions& options)
{
  RadarScene::Check(options, volume);
  const std::string array = ArrayOf(volume);
  const auto moment = ParseMomentName(array);
  if (!moment)
  {
    throw Error("the volume's active scalars are no radar moment: '" + array + "'");
  }
  const VolumeInformation information = ReadVolumeInformation(volume);
  const SceneFrame frame = FrameVolume(volume, information, MeasureEcho(volume, options), options);
  const std::string caption = CaptionOf(*moment, information.time);
  std::vector<GlbMesh> surfaces = MakeSurfaces(volume, *moment, options, frame);
  GlbScene scene;
  scene.name = (information.synthetic ? "SYNTHETIC: " : "") + caption;
  scene.extras = ExtrasOf(information, *moment, frame, surfaces);
  scene.meshes = MakeGroundMeshes(frame, information, options, caption);
  std::move(surfaces.begin(), surfaces.end(), std::back_inserter(scene.meshes));
  return scene;
}

} // namespace nexrad::scene
