// SPDX-License-Identifier: BSD-3-Clause
#include "Gltf/GroundMeshes.h"

#include "Gltf/MeshBuilder.h"
#include "Scene/Map/MapLayer.h"
#include "Scene/Map/PlacedMap.h"
#include "Scene/Shapes/Theme.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTriangleFilter.h>
#include <vtkVectorText.h>

#include <array>
#include <string>

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
  MeshBuilder ground("ground", GlbShape::Triangles, theme.ground);
  const std::uint32_t first = ground.Add({west, south, height});
  ground.Add({east, south, height});
  ground.Add({east, north, height});
  ground.Add({west, north, height});
  ground.AddTriangle(first, first + 1, first + 2);
  ground.AddTriangle(first, first + 2, first + 3);
  return ground.Take();
}

void AddMapLines(const SceneFrame& frame, const Theme& theme, Meshes& meshes)
{
  constexpr std::array<const char*, 3> names = {
    "coasts and borders of countries", "borders of states and provinces", "borders of counties"};
  const auto placed = PlaceMapLines(frame);
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    const auto kind = static_cast<MapLineKind>(i);
    MeshBuilder lines(names[i], GlbShape::Lines, ColourOf(kind, theme));
    for (const GroundLine& line : placed[i])
    {
      lines.AddLine(line, HeightOf(frame, LevelOf(kind)));
    }
    meshes.push_back(lines.Take());
  }
}

GlbMesh MakeSectionLine(const SceneFrame& frame, const SectionLine& line, const Theme& theme)
{
  MeshBuilder section("line of the section", GlbShape::Lines, theme.marker);
  section.AddLine({frame.FromVolume(line.from), frame.FromVolume(line.to)},
    HeightOf(frame, GroundLevel::Section));
  return section.Take();
}

// A pyramid that stands on its tip.
GlbMesh MakeRadar(const SceneFrame& frame, const PlacedSite& site, const Theme& theme)
{
  const auto [x, y] = site.place;
  const double size = 0.004 * WidthOf(frame);
  const double bottom = HeightOf(frame, GroundLevel::Markers);
  const double top = bottom + 2.0 * size;
  MeshBuilder radar("radar " + site.name, GlbShape::Triangles, theme.marker);
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
  radar.SetExtras({{"latitude", latitude}, {"longitude", longitude}});
  return radar.Take();
}

void AddRadars(const SceneFrame& frame, const std::vector<std::string>& sites, double ringSpacing,
  const Theme& theme, Meshes& meshes)
{
  MeshBuilder rings("rings of range", GlbShape::Lines, theme.ring);
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
  meshes.push_back(rings.Take());
}

// A line of text south of the domain, counted from its edge.
GlbMesh MakeCaption(
  const SceneFrame& frame, const std::string& text, int line, const Colour& colour)
{
  constexpr double lineHeight = 1.6; // of a letter
  const double size = 0.02 * WidthOf(frame);
  const auto& bounds = frame.Bounds();
  MeshBuilder caption(text, GlbShape::Triangles, colour);
  caption.Add(MakeGroundText(text, {bounds[0], bounds[2] - lineHeight * size * line},
    HeightOf(frame, GroundLevel::Ground), size));
  return caption.Take();
}

} // namespace

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

} // namespace nexrad::scene
