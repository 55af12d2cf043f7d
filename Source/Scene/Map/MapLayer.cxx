// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapLayer.h"

#include "Scene/Map/GroundPicture.h"
#include "Scene/Map/MapData.h"
#include "Scene/Map/PlacedMap.h"
#include "Scene/Shapes/Shapes.h"

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <algorithm>

namespace nexrad::scene
{
namespace
{

// Pixels, indexed by MapLineKind.
constexpr std::array<double, 3> lineWidths = {1.3, 1.3, 1.0};

std::vector<ScenePoint> Raised(const GroundLine& line, double height)
{
  std::vector<ScenePoint> points;
  for (const auto& [x, y] : line)
  {
    points.push_back({x, y, height});
  }
  return points;
}

// Adds the parts of a line that lie over the domain.
void AddClipped(LineBuilder& builder, const GroundLine& line,
  const std::array<double, 4>& rectangle, double height)
{
  for (const GroundLine& part : ClipLine(line, rectangle))
  {
    builder.Add(Raised(part, height));
  }
}

void AddMapLines(SceneLayer& layer, const SceneFrame& frame, const Theme& theme)
{
  const auto placed = PlaceMapLines(frame);
  for (std::size_t kind = 0; kind < placed.size(); ++kind)
  {
    const auto ofLines = static_cast<MapLineKind>(kind);
    if (ofLines == MapLineKind::County && !ShowsCounties(frame))
    {
      continue;
    }
    LineBuilder builder;
    for (const GroundLine& line : placed[kind])
    {
      builder.Add(Raised(line, HeightOf(frame, LevelOf(ofLines))));
    }
    layer.props.push_back(builder.MakeActor(ColourOf(ofLines, theme), lineWidths[kind]));
  }
}

void AddSite(SceneLayer& layer, const SceneFrame& frame, const std::string& name,
  const std::array<double, 2>& place, int textSize, const Theme& theme)
{
  const double radius = std::max(2.0, 0.19 * textSize); // pixels
  const ScenePoint point = {place[0], place[1], HeightOf(frame, GroundLevel::Markers)};
  layer.props.push_back(MakeMarker(point, radius, theme.marker, theme.rim));
  layer.labels.push_back({name, point, {textSize, theme.marker, theme.rim},
    {LabelSide::Right, LabelSide::AboveRight, LabelSide::BelowRight, LabelSide::Left,
      LabelSide::AboveLeft, LabelSide::BelowLeft, LabelSide::Above, LabelSide::Below},
    radius + 0.35 * textSize});
}

void AddSites(SceneLayer& layer, const SceneFrame& frame, const MapContents& contents, int textSize,
  const Theme& theme)
{
  LineBuilder rings;
  const auto box = Rectangle(frame);
  for (const PlacedSite& site : PlaceSites(frame, contents.sites))
  {
    for (const GroundLine& ring : PlaceRings(site.place, contents.ringSpacing))
    {
      AddClipped(rings, ring, box, HeightOf(frame, GroundLevel::Rings));
    }
    if (site.within)
    {
      AddSite(layer, frame, site.name, site.place, textSize, theme);
      layer.labels.back().spread = site.spread;
    }
  }
  layer.props.push_back(rings.MakeActor(theme.ring, 1.0));
}

// The labels of those places that lie in the domain, at most so many, each as `like`.
void AddPlaces(SceneLayer& layer, const SceneFrame& frame, const std::vector<MapName>& places,
  std::size_t most, const Label& like)
{
  const std::size_t before = layer.labels.size();
  for (const MapName& name : places)
  {
    const auto place = frame.Place(name.longitude, name.latitude);
    if (IsWithin(place, Rectangle(frame)) && layer.labels.size() < before + most)
    {
      layer.labels.push_back(like);
      layer.labels.back().text = name.name;
      layer.labels.back().point = {place[0], place[1], HeightOf(frame, GroundLevel::Markers)};
    }
  }
}

// Names of states where they are asked for, and the largest towns of the domain; the layout of the
// labels leaves out those for which a picture has no room.
void AddNames(
  SceneLayer& layer, const SceneFrame& frame, bool states, int textSize, const Theme& theme)
{
  constexpr std::size_t mostTowns = 60; // that are tried
  Label label;
  label.style = {std::max(9, textSize * 5 / 6), theme.placeName, theme.rim};
  label.optional = true;
  if (states)
  {
    label.sides = {LabelSide::Centre, LabelSide::Above, LabelSide::Below};
    AddPlaces(layer, frame, EmbeddedMapNames(), EmbeddedMapNames().size(), label);
  }
  label.sides = {LabelSide::Right, LabelSide::Left, LabelSide::Above, LabelSide::Below};
  label.dot = std::max(1.5, 0.1 * textSize); // pixels
  label.gap = label.dot + 0.2 * textSize;
  label.room = 7.0 * textSize;
  AddPlaces(layer, frame, EmbeddedTowns(), mostTowns, label);
}

} // namespace

double HeightOf(const SceneFrame& frame, GroundLevel level)
{
  const auto& framed = frame.Framed();
  return framed[4] + 8e-4 * static_cast<int>(level) * (framed[1] - framed[0]);
}

GroundLevel LevelOf(MapLineKind kind)
{
  constexpr std::array<GroundLevel, 3> levels = {
    GroundLevel::Countries, GroundLevel::States, GroundLevel::Counties};
  return levels[static_cast<std::size_t>(kind)];
}

const Colour& ColourOf(MapLineKind kind, const Theme& theme)
{
  const std::array<const Colour*, 3> colours = {&theme.country, &theme.state, &theme.county};
  return *colours[static_cast<std::size_t>(kind)];
}

vtkSmartPointer<vtkActor> MakeGroundActor(const SceneFrame& frame, const Theme& theme)
{
  const auto& box = frame.Bounds();
  const double height = HeightOf(frame, GroundLevel::Ground);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(box[0], box[2], height);
  plane->SetPoint1(box[1], box[2], height);
  plane->SetPoint2(box[0], box[3], height);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  vtkNew<vtkTexture> texture;
  texture->SetInputData(MakeGroundPicture(frame, theme));
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->EdgeClampOn();
  actor->SetTexture(texture);
  return actor;
}

SceneLayer MakeMapLayer(
  const SceneFrame& frame, const MapContents& contents, int textSize, const Theme& theme)
{
  SceneLayer layer;
  layer.props.push_back(MakeGroundActor(frame, theme));
  if (frame.HasMap())
  {
    AddMapLines(layer, frame, theme);
    AddSites(layer, frame, contents, textSize, theme);
    AddNames(layer, frame, contents.names, textSize, theme);
  }
  return layer;
}

} // namespace nexrad::scene
