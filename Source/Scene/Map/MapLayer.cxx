// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapLayer.h"

#include "Scene/Elements/LineBuilder.h"
#include "Scene/Elements/Marker.h"
#include "Scene/Map/MapLines.h"
#include "Scene/Map/MapNames.h"
#include "Scene/Map/PlacedMap.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>

namespace nexrad::scene
{
namespace
{

// Pixels, indexed by MapLineKind.
constexpr std::array<double, 3> lineWidths = {2.0, 1.6, 1.0};

// Things on the ground are stacked a little above each other, in parts of the domain's width, so
// that they do not fight for the same depth.
enum class Level
{
  Ground = -2, // well below the lines: its depth varies within a pixel
  Picture = -1,
  Counties = 0,
  States = 1,
  Countries = 2,
  Rings = 3,
  Markers = 4,
  Section = 5
};

double HeightOf(const SceneFrame& frame, Level level)
{
  const auto& bounds = frame.Bounds();
  return bounds[4] + 8e-4 * static_cast<int>(level) * (bounds[1] - bounds[0]);
}

std::array<double, 4> Rectangle(const SceneFrame& frame)
{
  const auto& bounds = frame.Bounds();
  return {bounds[0], bounds[1], bounds[2], bounds[3]};
}

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
  const std::array<Colour, 3> colours = {theme.country, theme.state, theme.county};
  constexpr std::array<Level, 3> levels = {Level::Countries, Level::States, Level::Counties};
  const auto placed = PlaceMapLines(frame);
  for (std::size_t kind = 0; kind < placed.size(); ++kind)
  {
    LineBuilder builder;
    for (const GroundLine& line : placed[kind])
    {
      builder.Add(Raised(line, HeightOf(frame, levels[kind])));
    }
    layer.props.push_back(builder.MakeActor(colours[kind], lineWidths[kind]));
  }
}

vtkSmartPointer<vtkProp> MakeGround(const SceneFrame& frame, const Colour& colour)
{
  const auto& box = frame.Bounds();
  const double height = HeightOf(frame, Level::Ground);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(box[0], box[2], height);
  plane->SetPoint1(box[1], box[2], height);
  plane->SetPoint2(box[0], box[3], height);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  actor->GetProperty()->LightingOff();
  return actor;
}

bool IsWithin(const std::array<double, 2>& place, const std::array<double, 4>& box)
{
  return place[0] >= box[0] && place[0] <= box[1] && place[1] >= box[2] && place[1] <= box[3];
}

void AddSite(SceneLayer& layer, const SceneFrame& frame, const std::string& name,
  const std::array<double, 2>& place, int textSize, const Theme& theme)
{
  const double radius = std::max(2.0, 0.19 * textSize); // pixels
  const ScenePoint point = {place[0], place[1], HeightOf(frame, Level::Markers)};
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
      AddClipped(rings, ring, box, HeightOf(frame, Level::Rings));
    }
    if (site.within)
    {
      AddSite(layer, frame, site.name, site.place, textSize, theme);
    }
  }
  layer.props.push_back(rings.MakeActor(theme.ring, 1.0));
}

void AddNames(SceneLayer& layer, const SceneFrame& frame, int textSize, const Theme& theme)
{
  const int letters = std::max(9, textSize * 5 / 6);
  for (const MapName& name : EmbeddedMapNames())
  {
    const auto place = frame.Place(name.longitude, name.latitude);
    if (IsWithin(place, Rectangle(frame)))
    {
      Label label;
      label.text = name.name;
      label.point = {place[0], place[1], HeightOf(frame, Level::Markers)};
      label.style = {letters, theme.placeName, theme.rim};
      label.sides = {LabelSide::Centre, LabelSide::Above, LabelSide::Below};
      label.optional = true;
      layer.labels.push_back(label);
    }
  }
}

} // namespace

double PictureHeight(const SceneFrame& frame)
{
  return HeightOf(frame, Level::Picture);
}

double SectionHeight(const SceneFrame& frame)
{
  return HeightOf(frame, Level::Section);
}

SceneLayer MakeMapLayer(
  const SceneFrame& frame, const MapContents& contents, int textSize, const Theme& theme)
{
  SceneLayer layer;
  layer.props.push_back(MakeGround(frame, theme.ground));
  if (frame.HasMap())
  {
    AddMapLines(layer, frame, theme);
    AddSites(layer, frame, contents, textSize, theme);
    if (contents.names)
    {
      AddNames(layer, frame, textSize, theme);
    }
  }
  return layer;
}

} // namespace nexrad::scene
