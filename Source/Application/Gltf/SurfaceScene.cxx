// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/SurfaceScene.h"

#include "Gltf/Glb.h"
#include "Gltf/IsoSurface.h"
#include "Output/OutputFile.h"
#include "Scene/Captions/Captions.h"
#include "Scene/EchoFraming.h"
#include "Scene/Frame/SceneFrame.h"
#include "Scene/Frame/VolumeInformation.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/Map/PlacedMap.h"
#include "Scene/RadarScene.h"
#include "Scene/SceneOptions.h"
#include "Scene/Shapes/Theme.h"
#include "Scene/VolumeAppearance.h"
#include "Scene/VolumeCut.h"
#include "nexrad/Model/Moment.h"
#include "nexrad/System/Error.h"
#include "vtkNexradTransferFunction.h"
#include "vtkNexradVoxels.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneCollection.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkVectorText.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace nexrad::scene
{
namespace
{

/// A line of text that lies flat, in letters that an eye above it reads with north up: triangles in
/// the plane of that height. `corner`: lower left corner of the text, x and y; `size`: height of a
/// capital letter. All in the unit of the scene. ASCII alone.
vtkSmartPointer<vtkPolyData> MakeGroundText(
  const std::string& text, const std::array<double, 2>& corner, double height, double size)
{
  vtkNew<vtkVectorText> letters; // whose capitals are 1 high
  letters->SetText(text.c_str());
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(letters->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> flat = triangles->GetOutput();
  vtkNew<vtkPoints> placed;
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    const double* letter = flat->GetPoint(i);
    placed->InsertNextPoint(corner[0] + size * letter[0], corner[1] + size * letter[1], height);
  }
  flat->SetPoints(placed);
  return flat;
}

using Meshes = std::vector<GlbMesh>;

double WidthOf(const SceneFrame& frame)
{
  return frame.Bounds()[1] - frame.Bounds()[0];
}

GlbMesh MakeGround(const SceneFrame& frame, const Theme& theme)
{
  const auto [west, east, south, north] = Rectangle(frame);
  const double height = HeightOf(frame, GroundLevel::Ground);
  GlbMesh ground{"ground", GlbShape::Triangles, {theme.ground}};
  const std::uint32_t first = ground.Add({west, south, height});
  ground.Add({east, south, height});
  ground.Add({east, north, height});
  ground.Add({west, north, height});
  ground.AddTriangle(first, first + 1, first + 2);
  ground.AddTriangle(first, first + 2, first + 3);
  return ground;
}

void AddMapLines(const SceneFrame& frame, const Theme& theme, Meshes& meshes)
{
  constexpr std::array<const char*, 3> names = {
    "coasts and borders of countries", "borders of states and provinces", "borders of counties"};
  const auto placed = PlaceMapLines(frame);
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    const auto kind = static_cast<MapLineKind>(i);
    GlbMesh lines{names[i], GlbShape::Lines, {ColourOf(kind, theme)}};
    for (const GroundLine& line : placed[i])
    {
      lines.AddLine(line, HeightOf(frame, LevelOf(kind)));
    }
    meshes.push_back(std::move(lines));
  }
}

GlbMesh MakeSectionLine(const SceneFrame& frame, const SectionLine& line, const Theme& theme)
{
  GlbMesh section{"line of the section", GlbShape::Lines, {theme.marker}};
  section.AddLine({frame.FromVolume(line.from), frame.FromVolume(line.to)},
    HeightOf(frame, GroundLevel::Section));
  return section;
}

// A pyramid that stands on its tip.
GlbMesh MakeRadar(const SceneFrame& frame, const PlacedSite& site, const Theme& theme)
{
  const auto [x, y] = site.place;
  const double size = 0.004 * WidthOf(frame);
  const double bottom = HeightOf(frame, GroundLevel::Markers);
  const double top = bottom + 2.0 * size;
  GlbMesh radar{"radar " + site.name, GlbShape::Triangles, {theme.marker}};
  const std::uint32_t tip = radar.Add({x, y, bottom});
  const std::array<std::uint32_t, 4> corners = {radar.Add({x - size, y - size, top}),
    radar.Add({x + size, y - size, top}), radar.Add({x + size, y + size, top}),
    radar.Add({x - size, y + size, top})};
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    radar.AddTriangle(tip, corners[(i + 1) % corners.size()], corners[i]);
  }
  radar.AddTriangle(corners[0], corners[1], corners[2]);
  radar.AddTriangle(corners[0], corners[2], corners[3]);
  const auto [longitude, latitude] = frame.Geographic(x, y);
  radar.extras = {{"latitude", latitude}, {"longitude", longitude}};
  return radar;
}

void AddRadars(const SceneFrame& frame, const std::vector<std::string>& sites, double ringSpacing,
  const Theme& theme, Meshes& meshes)
{
  GlbMesh rings{"rings of range", GlbShape::Lines, {theme.ring}};
  for (const PlacedSite& site : PlaceSites(frame, sites))
  {
    for (const GroundLine& ring : PlaceRings(site.place, ringSpacing))
    {
      for (const GroundLine& part : ClipLine(ring, Rectangle(frame)))
      {
        rings.AddLine(part, HeightOf(frame, GroundLevel::Rings));
      }
    }
    if (site.within)
    {
      meshes.push_back(MakeRadar(frame, site, theme));
    }
  }
  meshes.push_back(std::move(rings));
}

// A line of text south of the domain, counted from its edge.
GlbMesh MakeCaption(
  const SceneFrame& frame, const std::string& text, int line, const Colour& colour)
{
  constexpr double lineHeight = 1.6; // of a letter
  const double size = 0.02 * WidthOf(frame);
  const auto& bounds = frame.Bounds();
  GlbMesh caption{text, GlbShape::Triangles, {colour}};
  caption.Add(MakeGroundText(text, {bounds[0], bounds[2] - lineHeight * size * line},
    HeightOf(frame, GroundLevel::Ground), size));
  return caption;
}

// What lies on the ground under the surfaces of a volume: a plane, the lines of the map, the line
// of a section, rings of range, a marker for each radar that the site table knows, and south of the
// domain the caption and, of simulated data, the word SYNTHETIC. In the colours of the theme; none
// of it is lit.
std::vector<GlbMesh> MakeGroundMeshes(const SceneFrame& frame, const VolumeInformation& information,
  const SceneOptions& options, const std::string& caption)
{
  const Theme& theme = ThemeOf(options.theme);
  Meshes meshes = {MakeGround(frame, theme)};
  AddMapLines(frame, theme, meshes);
  if (options.cut.section)
  {
    meshes.push_back(MakeSectionLine(frame, *options.cut.section, theme));
  }
  AddRadars(frame, information.sites, options.ringSpacing, theme, meshes);
  meshes.push_back(MakeCaption(frame, caption, 1, theme.note));
  if (information.synthetic)
  {
    meshes.push_back(MakeCaption(frame, "SYNTHETIC", 2, theme.warning));
  }
  return meshes;
}

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
    values = IsoValuesOf(transferFunction);
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
  const vtkSmartPointer<vtkImageData> counting = MakeCounting(volume, frame);
  const auto planes = CutPlanesOf(options.cut, frame);
  std::vector<GlbMesh> surfaces;
  for (const auto& [value, opacity] : wanted)
  {
    GlbMesh surface{
      NameOf(moment, value), GlbShape::Triangles, {ColourAt(transferFunction, value), *opacity}};
    surface.Add(MakeSurface(counting, value, planes));
    surface.extras = {{"moment", ToString(moment)}, {"value", value}, {"unit", UnitOf(moment)},
      {"opacity", *opacity}, {"triangles", surface.indices.size() / 3}};
    surfaces.push_back(std::move(surface));
  }
  return surfaces;
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

GlbScene MakeSurfaceScene(vtkImageData* volume, const SceneOptions& options)
{
  RadarScene::Check(options, volume);
  const MomentName moment = vtkNexradScalarsMoment(volume);
  const VolumeInformation information = ReadVolumeInformation(volume);
  const SceneFrame frame = FrameVolume(volume, information, MeasureEcho(volume, options), options);
  const std::string caption =
    TitleOf(moment) + (information.time ? ", " + TimeText(information) : "");
  std::vector<GlbMesh> surfaces = MakeSurfaces(volume, moment, options, frame);
  GlbScene scene;
  scene.name = (information.synthetic ? "SYNTHETIC: " : "") + caption;
  scene.extras = ExtrasOf(information, moment, frame, surfaces);
  scene.meshes = MakeGroundMeshes(frame, information, options, caption);
  std::move(surfaces.begin(), surfaces.end(), std::back_inserter(scene.meshes));
  return scene;
}

} // namespace

void WriteSurfaces(
  const std::filesystem::path& path, vtkImageData* volume, const SceneOptions& options)
{
  const std::vector<unsigned char> bytes = MakeGlb(MakeSurfaceScene(volume, options));
  application::WriteFile(path, bytes.data(), bytes.size());
}

} // namespace nexrad::scene
