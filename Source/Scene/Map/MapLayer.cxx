// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapLayer.h"

#include "Scene/Elements/LineBuilder.h"
#include "Scene/Elements/SceneText.h"
#include "Scene/Map/MapLines.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/SiteTable.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>

#include <algorithm>
#include <cmath>

namespace nexrad::scene
{
namespace
{

struct LineStyle
{
  Colour colour;
  double width; // pixels
};
// Indexed by MapLineKind.
constexpr std::array<LineStyle, 3> lineStyles = {
  LineStyle{{0.62, 0.68, 0.74}, 2.0}, {{0.50, 0.55, 0.60}, 1.6}, {{0.235, 0.27, 0.305}, 1.0}};
constexpr Colour ringColour = {0.30, 0.42, 0.50};
constexpr Colour markerColour = {1.0, 1.0, 1.0};
constexpr double ringRange = 230'000.0; // m, of the WSR-88D's quantitative reflectivity
constexpr double degrees = 180.0 / 3.14159265358979323846;

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
  Markers = 4
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

// Adds the parts of a polyline that lie over the domain.
void AddClipped(LineBuilder& builder, const std::vector<std::array<double, 2>>& line,
  const std::array<double, 4>& rectangle, double height)
{
  std::vector<ScenePoint> part;
  const auto flush = [&]
  {
    if (part.size() > 1)
    {
      builder.Add(part);
    }
    part.clear();
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const auto at = [&](double s) -> ScenePoint
    {
      return {line[i][0] + s * (line[i + 1][0] - line[i][0]),
        line[i][1] + s * (line[i + 1][1] - line[i][1]), height};
    };
    double enters = 0.0;
    double leaves = 1.0;
    if (!ClipToRectangle(line[i], line[i + 1], rectangle, enters, leaves))
    {
      flush();
      continue;
    }
    if (part.empty() || enters > 0.0)
    {
      flush();
      part.push_back(at(enters));
    }
    part.push_back(at(leaves));
    if (leaves < 1.0)
    {
      flush();
    }
  }
  flush();
}

// Longitudes and latitudes that the domain can touch, so that the lines of the rest of the world
// need not be projected. A quarter of the box is added for the curvature of its edges.
GeographicBounds ReachOf(const SceneFrame& frame)
{
  const auto box = Rectangle(frame);
  GeographicBounds reach{1e9, 1e9, -1e9, -1e9};
  constexpr int steps = 8;
  for (int i = 0; i <= steps; ++i)
  {
    for (int j = 0; j <= steps; ++j)
    {
      const auto [longitude, latitude] = frame.Geographic(
        box[0] + (box[1] - box[0]) * i / steps, box[2] + (box[3] - box[2]) * j / steps);
      reach = {std::min(reach.west, longitude), std::min(reach.south, latitude),
        std::max(reach.east, longitude), std::max(reach.north, latitude)};
    }
  }
  const double width = (reach.east - reach.west) / 4.0;
  const double height = (reach.north - reach.south) / 4.0;
  return {reach.west - width, reach.south - height, reach.east + width, reach.north + height};
}

bool Touches(const MapLine& line, const GeographicBounds& reach)
{
  return std::any_of(line.points.begin(), line.points.end(),
    [&](const auto& point)
    {
      return point[0] >= reach.west && point[0] <= reach.east && point[1] >= reach.south &&
             point[1] <= reach.north;
    });
}

void AddMapLines(std::vector<vtkSmartPointer<vtkProp>>& props, const SceneFrame& frame)
{
  constexpr std::array<Level, 3> levels = {Level::Countries, Level::States, Level::Counties};
  std::array<LineBuilder, 3> builders;
  const GeographicBounds reach = ReachOf(frame);
  for (const MapLine& line : EmbeddedMapLines())
  {
    if (!Touches(line, reach))
    {
      continue;
    }
    std::vector<std::array<double, 2>> placed;
    for (const auto& [longitude, latitude] : line.points)
    {
      placed.push_back(frame.Place(longitude, latitude));
    }
    const auto kind = static_cast<std::size_t>(line.kind);
    AddClipped(builders[kind], placed, Rectangle(frame), HeightOf(frame, levels[kind]));
  }
  for (std::size_t kind = 0; kind < builders.size(); ++kind)
  {
    props.push_back(builders[kind].MakeActor(lineStyles[kind].colour, lineStyles[kind].width));
  }
}

vtkSmartPointer<vtkProp> MakeGround(const SceneFrame& frame)
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
  actor->GetProperty()->SetColor(groundColour[0], groundColour[1], groundColour[2]);
  actor->GetProperty()->LightingOff();
  return actor;
}

// A circle of a radius in m about a radar, as points of the map. Small enough for the flat
// approximation: the azimuthal projection bends it by far less than a pixel.
std::vector<std::array<double, 2>> Circle(const std::array<double, 2>& centre, double radius)
{
  constexpr int corners = 180;
  std::vector<std::array<double, 2>> points;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = 2.0 * i / corners * 180.0 / degrees;
    points.push_back({centre[0] + radius / 1000.0 * std::sin(angle),
      centre[1] + radius / 1000.0 * std::cos(angle)});
  }
  return points;
}

void AddSites(std::vector<vtkSmartPointer<vtkProp>>& props, const SceneFrame& frame,
  const std::vector<std::string>& sites, double ringSpacing, int textSize)
{
  LineBuilder markers;
  LineBuilder rings;
  const auto box = Rectangle(frame);
  const double markerSize = 6e-3 * (box[1] - box[0]);
  for (const std::string& name : sites)
  {
    const KnownSite* site = FindSite(name);
    if (site == nullptr)
    {
      continue;
    }
    const auto place = frame.Place(site->position.longitude, site->position.latitude);
    for (int ring = 1; ringSpacing > 0.0 && ring * ringSpacing <= ringRange; ++ring)
    {
      AddClipped(rings, Circle(place, ring * ringSpacing), box, HeightOf(frame, Level::Rings));
    }
    if (place[0] < box[0] || place[0] > box[1] || place[1] < box[2] || place[1] > box[3])
    {
      continue;
    }
    const double height = HeightOf(frame, Level::Markers);
    markers.Add(
      {{place[0] - markerSize, place[1], height}, {place[0] + markerSize, place[1], height}});
    markers.Add(
      {{place[0], place[1] - markerSize, height}, {place[0], place[1] + markerSize, height}});
    props.push_back(MakeLabel(
      " " + name, {place[0], place[1], height}, textSize, markerColour, LabelSide::Right));
  }
  props.push_back(rings.MakeActor(ringColour, 1.0));
  props.push_back(markers.MakeActor(markerColour, 2.0));
}

} // namespace

double PictureHeight(const SceneFrame& frame)
{
  return HeightOf(frame, Level::Picture);
}

std::vector<vtkSmartPointer<vtkProp>> MakeMapLayer(
  const SceneFrame& frame, const std::vector<std::string>& sites, double ringSpacing, int textSize)
{
  std::vector<vtkSmartPointer<vtkProp>> props = {MakeGround(frame)};
  if (frame.HasMap())
  {
    AddMapLines(props, frame);
    AddSites(props, frame, sites, ringSpacing, textSize);
  }
  return props;
}

} // namespace nexrad::scene
