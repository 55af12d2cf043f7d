// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapAreas.h"

#include "Scene/Frame/SceneFrame.h"
#include "Scene/Map/MapBytes.h"
#include "Scene/Map/PlacedMap.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nexrad::embedded
{
extern const unsigned char mapAreas[];
extern const std::size_t mapAreasSize;
} // namespace nexrad::embedded

namespace nexrad::scene
{
namespace
{

// The cells of a picture whose middles lie in a ring.
class RingPainter
{
public:
  RingPainter(std::vector<std::uint8_t>& theCells, int theColumns, int theRows)
    : cells(theCells)
    , columns(theColumns)
    , rows(theRows)
    , crossings(static_cast<std::size_t>(theRows))
  {
  }

  // The ring's points are in cells from the corner of the picture.
  void Paint(const GroundLine& ring, std::uint8_t value)
  {
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      this->Cross(ring[i], ring[(i + 1) % ring.size()]);
    }
    for (int row = 0; row < rows; ++row)
    {
      this->Fill(row, value);
    }
  }

private:
  int FirstMiddle(double place, int count) const
  {
    return static_cast<int>(std::ceil(std::clamp(place - 0.5, 0.0, static_cast<double>(count))));
  }

  void Cross(const std::array<double, 2>& from, const std::array<double, 2>& to)
  {
    const auto [low, high] = std::minmax(from[1], to[1]);
    for (int row = this->FirstMiddle(low, rows); row < this->FirstMiddle(high, rows); ++row)
    {
      const double share = (row + 0.5 - from[1]) / (to[1] - from[1]);
      crossings[static_cast<std::size_t>(row)].push_back(from[0] + share * (to[0] - from[0]));
    }
  }

  void Fill(int row, std::uint8_t value)
  {
    auto& places = crossings[static_cast<std::size_t>(row)];
    std::sort(places.begin(), places.end());
    const auto first = cells.begin() + static_cast<std::ptrdiff_t>(row) * columns;
    for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    {
      std::fill(first + this->FirstMiddle(places[i], columns),
        first + this->FirstMiddle(places[i + 1], columns), value);
    }
    places.clear();
  }

  std::vector<std::uint8_t>& cells;
  int columns;
  int rows;
  std::vector<std::vector<double>> crossings; ///< of each row
};

bool Touches(const MapArea& area, const GeographicBounds& reach)
{
  GeographicBounds box{1e9, 1e9, -1e9, -1e9};
  for (const auto& [longitude, latitude] : area.ring)
  {
    box = {std::min(box.west, longitude), std::min(box.south, latitude),
      std::max(box.east, longitude), std::max(box.north, latitude)};
  }
  return box.west <= reach.east && box.east >= reach.west && box.south <= reach.north &&
         box.north >= reach.south;
}

} // namespace

std::vector<MapArea> ParseMapAreas(const unsigned char* bytes, std::size_t size)
{
  constexpr std::uint8_t kinds = 2;
  std::vector<MapArea> areas;
  for (MapPolyline& line : ReadMapPolylines(MapBytes(bytes, size, "map areas"), "NXAREA1\n", kinds))
  {
    areas.push_back({line.kind == 1, std::move(line.points)});
  }
  return areas;
}

const std::vector<MapArea>& EmbeddedMapAreas()
{
  static const std::vector<MapArea> areas =
    ParseMapAreas(embedded::mapAreas, embedded::mapAreasSize);
  return areas;
}

std::vector<std::uint8_t> PaintLand(
  const SceneFrame& frame, const std::vector<MapArea>& areas, int columns, int rows)
{
  std::vector<std::uint8_t> land(static_cast<std::size_t>(columns) * rows, 0);
  RingPainter painter(land, columns, rows);
  const auto& box = frame.Bounds();
  const GeographicBounds reach = ReachOf(frame);
  for (const MapArea& area : areas)
  {
    if (!Touches(area, reach))
    {
      continue;
    }
    GroundLine ring;
    for (const auto& [longitude, latitude] : area.ring)
    {
      const auto place = frame.Place(longitude, latitude);
      ring.push_back({columns * (place[0] - box[0]) / (box[1] - box[0]),
        rows * (place[1] - box[2]) / (box[3] - box[2])});
    }
    painter.Paint(ring, area.land ? 1 : 0);
  }
  return land;
}

} // namespace nexrad::scene
