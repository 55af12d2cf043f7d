// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapLines.h"

#include "Scene/Map/MapBytes.h"

#include <utility>

namespace nexrad::embedded
{
extern const unsigned char mapLines[];
extern const std::size_t mapLinesSize;
} // namespace nexrad::embedded

namespace nexrad::scene
{

std::vector<MapLine> ParseMapLines(const unsigned char* bytes, std::size_t size)
{
  constexpr std::uint8_t kinds = 3;
  std::vector<MapLine> lines;
  for (MapPolyline& line : ReadMapPolylines(MapBytes(bytes, size, "map lines"), "NXMAP1\n", kinds))
  {
    lines.push_back({static_cast<MapLineKind>(line.kind), std::move(line.points)});
  }
  return lines;
}

const std::vector<MapLine>& EmbeddedMapLines()
{
  static const std::vector<MapLine> lines =
    ParseMapLines(embedded::mapLines, embedded::mapLinesSize);
  return lines;
}

} // namespace nexrad::scene
