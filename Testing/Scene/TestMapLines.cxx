// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/Map/MapData.h"
#include "Tolerance.h"

#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace nexrad;
using namespace nexrad::scene;

namespace
{

std::vector<MapPolyline> ParseLines(const std::string& bytes)
{
  return ParseMapLines(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
}

// Worked out by hand: 100 units a degree, one state line (1) of two points. -90.25° is -9025 units,
// stored as 18049 = 0x4681: bytes 0x81 0x8d 0x01; 38.5° is 3850, stored as 7700: 0x94 0x3c. The
// step is +1 (stored 2) and -1 (stored 1).
const std::string oneLine =
  std::string("NXMAP1\n") + "\x64" + "\x01" + "\x01\x02" + "\x81\x8d\x01\x94\x3c" + "\x02\x01";

double DistanceDegrees(const std::array<double, 2>& a, double longitude, double latitude)
{
  return std::hypot(a[0] - longitude, a[1] - latitude);
}

// True when some line of the kind passes that near.
bool Passes(MapLineKind kind, double longitude, double latitude, double within)
{
  const auto& lines = EmbeddedMapLines();
  return std::any_of(lines.begin(), lines.end(),
    [&](const MapPolyline& line)
    {
      return line.kind == static_cast<std::uint8_t>(kind) &&
             std::any_of(line.points.begin(), line.points.end(),
               [&](const auto& point)
               { return DistanceDegrees(point, longitude, latitude) < within; });
    });
}

} // namespace

TEST(MapLines, ReadsALineWorkedOutByHand)
{
  const auto lines = ParseLines(oneLine);
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0].kind, static_cast<std::uint8_t>(MapLineKind::State));
  ASSERT_EQ(lines[0].points.size(), 2U);
  EXPECT_NEAR(lines[0].points[0][0], -90.25, 1e-12);
  EXPECT_NEAR(lines[0].points[0][1], 38.50, 1e-12);
  EXPECT_NEAR(lines[0].points[1][0], -90.24, 1e-12);
  EXPECT_NEAR(lines[0].points[1][1], 38.49, 1e-12);
}

TEST(MapLines, EveryCutIsAnError)
{
  for (std::size_t length = 0; length < oneLine.size(); ++length)
  {
    EXPECT_THROW(ParseLines(oneLine.substr(0, length)), Error) << length;
  }
  EXPECT_THROW(ParseLines(oneLine + '\0'), Error);
}

TEST(MapLines, WrongBytesAreErrors)
{
  std::string bytes = oneLine;
  bytes[0] = 'n';
  EXPECT_THROW(ParseLines(bytes), Error) << "magic";
  bytes = oneLine;
  bytes[9] = 3;
  EXPECT_THROW(ParseLines(bytes), Error) << "kind";
  bytes = oneLine;
  bytes[10] = 1;
  EXPECT_THROW(ParseLines(bytes), Error) << "a line of one point";
  bytes = oneLine;
  bytes[7] = 0;
  EXPECT_THROW(ParseLines(bytes), Error) << "units";
  EXPECT_THROW(ParseLines(std::string("NXMAP1\n") + "\x64" + "\xff\xff\xff\xff\x0f"), Error)
    << "a count above 28 bits";
}

TEST(MapLines, TheEmbeddedMapHasKnownPlaces)
{
  EXPECT_AT_LEAST(EmbeddedMapLines().size(), 9000U, "lines of the embedded map");
  // Where Missouri, Kansas, Nebraska and Iowa come near to each other, and the corner of four
  // states.
  EXPECT_TRUE(Passes(MapLineKind::State, -95.31, 40.00, 0.03));
  EXPECT_TRUE(Passes(MapLineKind::State, -109.045, 36.999, 0.01));
  // Cape Cod's tip and the border of Vermont with Quebec.
  EXPECT_TRUE(Passes(MapLineKind::Country, -70.22, 42.07, 0.05));
  EXPECT_TRUE(Passes(MapLineKind::Country, -71.50, 45.01, 0.05));
  // The coast of Nova Scotia near Yarmouth.
  EXPECT_TRUE(Passes(MapLineKind::Country, -66.1, 43.8, 0.25));
  EXPECT_FALSE(Passes(MapLineKind::Country, -92.0, 38.5, 1.0)) << "inland Missouri";
}

// Shores in Canada at Toronto, on Georgian Bay at Parry Sound, of Lake Erie at Port Stanley and of
// Lake Superior at Marathon; the border of Ontario with Quebec at Lake Timiskaming; and, in the
// United States, the Great Salt Lake's western shore.
TEST(MapLines, LakesHaveShoresOnBothSides)
{
  EXPECT_TRUE(Passes(MapLineKind::Country, -79.38, 43.63, 0.08));
  EXPECT_TRUE(Passes(MapLineKind::Country, -80.10, 45.33, 0.12));
  EXPECT_TRUE(Passes(MapLineKind::Country, -81.21, 42.66, 0.10));
  EXPECT_TRUE(Passes(MapLineKind::Country, -86.38, 48.72, 0.15));
  EXPECT_TRUE(Passes(MapLineKind::State, -79.52, 47.40, 0.15));
  EXPECT_TRUE(Passes(MapLineKind::Country, -112.9, 41.2, 0.25));
  EXPECT_FALSE(Passes(MapLineKind::Country, -78.0, 43.63, 0.08)) << "open water of Lake Ontario";
}

TEST(MapNames, ReadsRowsAndRefusesOthers)
{
  const auto names = ParseMapNames("name,longitude_deg,latitude_deg\nNew York,-74.89,43.05\n");
  ASSERT_EQ(names.size(), 1U);
  EXPECT_EQ(names[0].name, "New York");
  EXPECT_EQ(names[0].longitude, -74.89);
  EXPECT_EQ(names[0].latitude, 43.05);
  for (const char* wrong : {"Ohio", "Ohio,-83.0", "Ohio,-83.0,40.1,5", ",-83.0,40.1", "Ohio,x,y"})
  {
    EXPECT_THROW(ParseMapNames(std::string("heading\n") + wrong + "\n"), Error) << wrong;
  }
}

TEST(MapNames, TheEmbeddedOnesLieInTheirStates)
{
  const auto& names = EmbeddedMapNames();
  const auto find = [&](const std::string& wanted)
  {
    return *std::find_if(
      names.begin(), names.end(), [&](const MapName& name) { return name.name == wanted; });
  };
  EXPECT_AT_LEAST(names.size(), 60U, "names of the embedded map");
  const MapName kansas = find("Kansas");
  EXPECT_WITHIN(kansas.longitude, -98.3, 2.5, "longitude of Kansas's name, degrees");
  EXPECT_WITHIN(kansas.latitude, 38.5, 1.0, "latitude of Kansas's name, degrees",
    "a name may stand anywhere in its state");
  const MapName ontario = find("Ontario");
  EXPECT_WITHIN(ontario.latitude, 50.0, 3.5, "latitude of Ontario's name, degrees");
  EXPECT_AT_MOST(find("Michigan").latitude, 45.8, "latitude of Michigan's name, degrees")
    << "the lower peninsula";
}
