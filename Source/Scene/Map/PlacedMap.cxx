// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/PlacedMap.h"

#include "Scene/Shapes/Shapes.h"
#include "nexrad/Model/SiteTable.h"

#include <algorithm>
#include <cmath>

namespace nexrad::scene
{
namespace
{

constexpr double ringRange = 230'000.0; // m, of the WSR-88D's quantitative reflectivity
constexpr double fullCircle = 2.0 * 3.14159265358979323846;

// A circle of a radius in m about a radar, as points of the map. Small enough for the flat
// approximation: the azimuthal projection bends it by far less than a pixel.
GroundLine Circle(const std::array<double, 2>& centre, double radius)
{
  constexpr int corners = 180;
  GroundLine points;
  for (int i = 0; i <= corners; ++i)
  {
    const double angle = fullCircle * i / corners;
    points.push_back({centre[0] + radius / 1000.0 * std::sin(angle),
      centre[1] + radius / 1000.0 * std::cos(angle)});
  }
  return points;
}

bool HasPointIn(const GeographicBounds& reach, const MapPolyline& line)
{
  return std::any_of(line.points.begin(), line.points.end(),
    [&](const auto& point)
    {
      return point[0] >= reach.west && point[0] <= reach.east && point[1] >= reach.south &&
             point[1] <= reach.north;
    });
}

} // namespace

std::array<double, 4> Rectangle(const SceneFrame& frame)
{
  const auto& bounds = frame.Bounds();
  return {bounds[0], bounds[1], bounds[2], bounds[3]};
}

bool IsWithin(const std::array<double, 2>& place, const std::array<double, 4>& rectangle)
{
  return place[0] >= rectangle[0] && place[0] <= rectangle[1] && place[1] >= rectangle[2] &&
         place[1] <= rectangle[3];
}

// Lines of the rest of the world need not be projected. A quarter of the box is added for the
// curvature of its edges.
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

std::vector<GroundLine> ClipLine(const GroundLine& line, const std::array<double, 4>& rectangle)
{
  std::vector<GroundLine> parts;
  GroundLine part;
  const auto flush = [&]
  {
    if (part.size() > 1)
    {
      parts.push_back(part);
    }
    part.clear();
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const auto at = [&](double s) -> std::array<double, 2>
    {
      return {line[i][0] + s * (line[i + 1][0] - line[i][0]),
        line[i][1] + s * (line[i + 1][1] - line[i][1])};
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
  return parts;
}

std::array<std::vector<GroundLine>, 3> PlaceMapLines(const SceneFrame& frame)
{
  std::array<std::vector<GroundLine>, 3> placed;
  if (!frame.HasMap())
  {
    return placed;
  }
  const GeographicBounds reach = ReachOf(frame);
  for (const MapPolyline& line : EmbeddedMapLines())
  {
    if (!HasPointIn(reach, line))
    {
      continue;
    }
    GroundLine points;
    for (const auto& [longitude, latitude] : line.points)
    {
      points.push_back(frame.Place(longitude, latitude));
    }
    auto& parts = placed[line.kind];
    for (GroundLine& part : ClipLine(points, Rectangle(frame)))
    {
      parts.push_back(std::move(part));
    }
  }
  return placed;
}

bool ShowsCounties(const SceneFrame& frame)
{
  constexpr double widest = 300.0; // km
  const auto& box = frame.Bounds();
  return std::max(box[1] - box[0], box[3] - box[2]) <= widest;
}

namespace
{

// How far each radar is from those before it. Of few radars 0: all are named.
void FindSpreads(const std::array<double, 2>& centre, std::vector<PlacedSite>& sites)
{
  constexpr std::size_t few = 16;
  constexpr double most = 1e9; // always named
  std::vector<double> distances(sites.size(), most);
  const auto far = [&](std::size_t i, const std::array<double, 2>& place)
  { return std::hypot(sites[i].place[0] - place[0], sites[i].place[1] - place[1]); };
  for (std::size_t count = 0; sites.size() > few && count < sites.size(); ++count)
  {
    std::size_t next = 0;
    for (std::size_t i = 1; i < sites.size(); ++i)
    {
      const bool farther =
        count == 0 ? far(i, centre) < far(next, centre) : distances[i] > distances[next];
      next = farther ? i : next;
    }
    sites[next].spread = distances[next];
    for (std::size_t i = 0; i < sites.size(); ++i)
    {
      distances[i] = std::min(distances[i], far(i, sites[next].place));
    }
    distances[next] = -1.0;
  }
}

} // namespace

std::vector<PlacedSite> PlaceSites(const SceneFrame& frame, const std::vector<std::string>& sites)
{
  std::vector<PlacedSite> placed;
  for (const std::string& name : sites)
  {
    const KnownSite* site = frame.HasMap() ? FindSite(name) : nullptr;
    if (site != nullptr)
    {
      const auto place = frame.Place(site->position.longitude, site->position.latitude);
      placed.push_back({name, place, IsWithin(place, Rectangle(frame))});
    }
  }
  const auto box = Rectangle(frame);
  FindSpreads({0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3])}, placed);
  return placed;
}

std::vector<GroundLine> PlaceRings(const std::array<double, 2>& place, double spacing)
{
  std::vector<GroundLine> rings;
  for (int ring = 1; spacing > 0.0 && ring * spacing <= ringRange; ++ring)
  {
    rings.push_back(Circle(place, ring * spacing));
  }
  return rings;
}

} // namespace nexrad::scene
