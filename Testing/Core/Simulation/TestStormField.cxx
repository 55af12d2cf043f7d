// SPDX-License-Identifier: BSD-3-Clause
#include "StormMeans.h"
#include "Tolerance.h"
#include "nexrad/Geometry/Beam.h"
#include "nexrad/Grid/MakeGrid.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/StormField.h"

#include <GeographicLib/Geodesic.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;
using nexrad::testing::MeanReflectivityRows;

namespace
{

Time At(const char* text)
{
  return *ParseIso8601(text);
}

std::vector<Position> SitePositions()
{
  std::vector<Position> positions;
  for (const char* name : {"KEAX", "KILX", "KLSX"})
  {
    positions.push_back(FindSite(name)->position);
  }
  return positions;
}

GridSpecification SiteGrid(const std::array<int, 3>& dimensions)
{
  GridRequest request;
  request.dimensions = dimensions;
  return MakeGrid(request, SitePositions());
}

// Ground distances of the sites from a place, m.
std::vector<double> DistancesFrom(double longitude, double latitude)
{
  std::vector<double> distances;
  for (const Position& site : SitePositions())
  {
    double distance = 0.0;
    GeographicLib::Geodesic::WGS84().Inverse(
      site.latitude, site.longitude, latitude, longitude, distance);
    distances.push_back(distance);
  }
  return distances;
}

// Whether a beam between the lowest and the highest cut passes within 230 km.
bool IsScanned(const std::vector<double>& distances, double height)
{
  const std::vector<Position> sites = SitePositions();
  for (std::size_t index = 0; index < sites.size(); ++index)
  {
    const BeamDirection look = BeamModel().Look({height - sites[index].altitude, distances[index]});
    if (look.slantRange < 230'000.0 && look.elevation > 0.0 && look.elevation < 20.0)
    {
      return true;
    }
  }
  return false;
}

struct EchoCount
{
  std::size_t scanned = 0;
  std::size_t echoes = 0;
};

EchoCount CountEchoes(const StormField& field, const GridSpecification& grid, Time time)
{
  const StormSnapshot snapshot = field.At(time);
  EchoCount count;
  for (int y = 0; y < grid.dimensions[1]; ++y)
  {
    for (int x = 0; x < grid.dimensions[0]; ++x)
    {
      const auto degrees = grid.ToGeographic(grid.Coordinate(0, x), grid.Coordinate(1, y));
      const std::vector<double> distances = DistancesFrom(degrees[0], degrees[1]);
      for (int z = 0; z < grid.dimensions[2]; ++z)
      {
        const double height = grid.Coordinate(2, z);
        if (IsScanned(distances, height))
        {
          ++count.scanned;
          count.echoes +=
            snapshot.Reflectivity(StormPlane::FromGeographic(degrees[0], degrees[1], height)) > 0.0
              ? 1
              : 0;
        }
      }
    }
  }
  return count;
}

// One storm alone at full strength, its middle at the plane's origin.
StormSnapshot LoneStorm(StormKind kind, double top)
{
  StormLife storm;
  storm.kind = kind;
  storm.middleTime = 43'200.0;
  storm.lifetime = 12'000.0;
  storm.peak = kind == StormKind::RainArea ? 30.0 : 60.0;
  storm.top = top;
  std::vector<StormElement> elements;
  std::vector<StormVortex> vortices;
  AddElements(storm, storm.middleTime, elements, vortices);
  return {elements, vortices, storm.middleTime};
}

// The strongest reflectivity of a horizontal square about the origin, and where it stands.
struct Strongest
{
  double reflectivity = -100.0;
  PlanePoint place;
};
Strongest FindStrongest(const StormSnapshot& snapshot, double height)
{
  Strongest strongest;
  for (double x = -150'000.0; x <= 150'000.0; x += 1'000.0)
  {
    for (double y = -150'000.0; y <= 150'000.0; y += 1'000.0)
    {
      const double value = snapshot.Reflectivity({x, y, height});
      if (value > strongest.reflectivity)
      {
        strongest = {value, {x, y, height}};
      }
    }
  }
  return strongest;
}

} // namespace

TEST(StormField, DependsOnTheSeedAlone)
{
  const GridSpecification grid = SiteGrid({32, 32, 8});
  const Time time = At("2006-03-12T18:20");
  const auto first = MeanReflectivityRows(StormField(1), grid, 0, 32, time);
  EXPECT_EQ(first, MeanReflectivityRows(StormField(1), grid, 0, 32, time));
  EXPECT_NE(first, MeanReflectivityRows(StormField(2), grid, 0, 32, time));
}

TEST(StormField, HoldsEchoInFiveToFifteenPercentOfTheScannedVoxels)
{
  const GridSpecification grid = SiteGrid({64, 64, 32}); // every fourth of 256 × 256 × 128
  for (const std::uint32_t seed : {1U, 2U, 3U, 4U})
  {
    for (const char* time : {"2006-03-12T18:00", "2006-03-12T18:30", "2006-03-12T19:00"})
    {
      const EchoCount count = CountEchoes(StormField(seed), grid, At(time));
      const double share = static_cast<double>(count.echoes) / static_cast<double>(count.scanned);
      std::printf("seed %u at %s: %.1f %% of %zu scanned voxels hold echo\n", seed, time,
        100.0 * share, count.scanned);
      EXPECT_AT_LEAST(share, 0.05, "share of echo in the scanned voxels") << time;
      EXPECT_AT_MOST(share, 0.15, "share of echo in the scanned voxels") << time;
    }
  }
}

TEST(StormField, IsBusiestInTheAfternoonAndTheEvening)
{
  const GridSpecification grid = SiteGrid({48, 48, 12});
  const StormField field;
  const std::size_t night = CountEchoes(field, grid, At("2006-03-12T08:00")).echoes;
  const std::size_t evening = CountEchoes(field, grid, At("2006-03-12T20:00")).echoes;
  EXPECT_GT(night, 0U);
  EXPECT_AT_LEAST(static_cast<double>(evening) / static_cast<double>(night), 2.0,
    "voxels of echo in the evening, times those at night");
}

TEST(StormField, MeanIsOverTheLatticeOfTheVoxel)
{
  const GridSpecification grid = SiteGrid({64, 64, 16});
  const StormField field;
  const Time time = At("2006-03-12T18:00");
  const auto rows = MeanReflectivityRows(field, grid, 20, 44, time);
  const StormSnapshot snapshot = field.At(time);
  std::size_t compared = 0;
  for (int y = 20; y < 44; y += 3)
  {
    for (int x = 0; x < 64; x += 3)
    {
      for (int z = 1; z < 16; z += 5)
      {
        double sum = 0.0;
        for (int sample = 0; sample < 32; ++sample)
        {
          const double east = (sample % 4 - 1.5) / 4.0;
          const double north = (sample / 4 % 4 - 1.5) / 4.0;
          const double up = (sample / 16 - 0.5) / 2.0;
          const auto degrees = grid.ToGeographic(grid.Coordinate(0, x) + east * grid.spacing[0],
            grid.Coordinate(1, y) + north * grid.spacing[1]);
          sum += std::max(0.0, snapshot.Reflectivity(StormPlane::FromGeographic(degrees[0],
                                 degrees[1], grid.Coordinate(2, z) + up * grid.spacing[2])));
        }
        const std::size_t index = (static_cast<std::size_t>(z) * 24 + (y - 20)) * 64 + x;
        EXPECT_NEAR(rows[index], sum / 32.0, 1e-4);
        compared += sum > 0.0 ? 1 : 0;
      }
    }
  }
  EXPECT_AT_LEAST(compared, 40U, "voxels compared");
}

TEST(StormField, ClearAirStaysBelowZero)
{
  const StormSnapshot nothingElse({}, {}, 0.0);
  double strongest = -100.0;
  for (double x = 0.0; x < 100'000.0; x += 700.0)
  {
    for (double z = 0.0; z < 4'000.0; z += 100.0)
    {
      strongest = std::max(strongest, nothingElse.Reflectivity({x, 1.7 * x, z}));
    }
  }
  EXPECT_LT(strongest, StormSnapshot::ClearAirMaximum());
  EXPECT_LT(StormSnapshot::ClearAirMaximum(), 0.0);
  EXPECT_AT_LEAST(strongest, -5.0, "strongest clear air, dBZ");
  EXPECT_EQ(nothingElse.Reflectivity({0.0, 0.0, StormSnapshot::ClearAirTop() + 100.0}),
    -std::numeric_limits<double>::infinity());
}

TEST(StormField, TheDayRepeatsWithoutAJump)
{
  const StormField field;
  const StormSnapshot before = field.At(At("2006-03-12T23:59:59.900"));
  const StormSnapshot after = field.At(At("2006-03-13T00:00:00.100"));
  int echoes = 0;
  for (double x = -400'000.0; x < 400'000.0; x += 9'000.0)
  {
    for (double y = -200'000.0; y < 300'000.0; y += 9'000.0)
    {
      const double value = before.Reflectivity({x, y, 3'500.0});
      if (value > 0.0)
      {
        ++echoes;
        EXPECT_WITHIN(after.Reflectivity({x, y, 3'500.0}), value, 0.1, "value a day later, dBZ");
      }
    }
  }
  EXPECT_AT_LEAST(echoes, 500, "places of echo");
}

TEST(Supercell, HasAStrongCoreThatLeansDownshear)
{
  const StormSnapshot storm = LoneStorm(StormKind::Supercell, 14'000.0);
  const Strongest low = FindStrongest(storm, 2'000.0);
  const Strongest high = FindStrongest(storm, 9'000.0);
  EXPECT_AT_LEAST(low.reflectivity, 55.0, "strongest echo at 2 km, dBZ");
  EXPECT_AT_MOST(low.reflectivity, 66.0, "strongest echo at 2 km, dBZ");
  EXPECT_AT_LEAST(high.reflectivity, 30.0, "strongest echo at 9 km, dBZ");
  EXPECT_LT(high.reflectivity, low.reflectivity);
  EXPECT_AT_LEAST(high.place.x - low.place.x, 1'600.0, "lean of the core downshear, m");
}

TEST(Supercell, HasAWideAnvilAndATopAtItsHeight)
{
  const StormSnapshot storm = LoneStorm(StormKind::Supercell, 14'000.0);
  const double above = FindStrongest(storm, 14'500.0).reflectivity;
  const double below = FindStrongest(storm, 13'500.0).reflectivity;
  EXPECT_AT_LEAST(below, 7.0, "strongest echo below the top, dBZ");
  EXPECT_AT_LEAST(below - above, 7.0, "fall of the echo across the top, dB");
  // Downshear at 60 km there is an anvil aloft, and nothing but clear air below it.
  const double x = 60'000.0 * std::sin(64.0 / 57.29578);
  const double y = 60'000.0 * std::cos(64.0 / 57.29578);
  EXPECT_AT_LEAST(storm.Reflectivity({x, y, 10'000.0}), 15.0, "anvil downshear, dBZ");
  EXPECT_AT_MOST(storm.Reflectivity({x, y, 10'000.0}), 30.0, "anvil downshear, dBZ");
  EXPECT_AT_MOST(storm.Reflectivity({x, y, 2'000.0}), -8.0, "clear air below the anvil, dBZ");
}

TEST(Supercell, HasAHookRoundItsMesocyclone)
{
  const StormSnapshot storm = LoneStorm(StormKind::Supercell, 14'000.0);
  // The vortex stands 6.5 km behind and 7.5 km to the right of the core.
  const double sine = std::sin(64.0 / 57.29578);
  const double cosine = std::cos(64.0 / 57.29578);
  const PlanePoint eye{
    -6'500.0 * sine + 7'500.0 * cosine, -6'500.0 * cosine - 7'500.0 * sine, 1'000.0};
  ASSERT_EQ(storm.Vortices().size(), 2U);
  const StormVortex& vortex = storm.Vortices().front();
  EXPECT_WITHIN(vortex.AxisAt(eye.z).x, eye.x, 0.2, "axis of the mesocyclone, m");
  EXPECT_WITHIN(vortex.AxisAt(eye.z).y, eye.y, 0.2, "axis of the mesocyclone, m");
  EXPECT_AT_LEAST(vortex.rotation.At(eye.z), 20.0, "rotation of the mesocyclone at 1 km, m/s");
  // Round the eye there is echo of 40 dBZ and more, and less in it than in the ring.
  double ring = -100.0;
  for (int angle = 0; angle < 360; angle += 10)
  {
    ring = std::max(ring, storm.Reflectivity({eye.x + 4'200.0 * std::cos(angle / 57.29578),
                            eye.y + 4'200.0 * std::sin(angle / 57.29578), 1'000.0}));
  }
  EXPECT_AT_LEAST(ring, 40.0, "strongest echo of the hook, dBZ");
  EXPECT_AT_LEAST(ring - storm.Reflectivity(eye), 12.0, "hook above the eye, dB");
}

TEST(RainArea, HasABrightBandAtTheMeltingLevel)
{
  const StormSnapshot rain = LoneStorm(StormKind::RainArea, 6'000.0);
  const double below = rain.Reflectivity({0.0, 0.0, 1'500.0});
  const double band = rain.Reflectivity({0.0, 0.0, 2'900.0});
  const double above = rain.Reflectivity({0.0, 0.0, 5'000.0});
  EXPECT_AT_LEAST(band - below, 3.0, "bright band above the rain, dB");
  EXPECT_AT_LEAST(below - above, 12.0, "snow below the rain, dB");
}

TEST(StormLife, MovesStraightAndIsGoneBeforeAndAfter)
{
  StormLife storm;
  storm.middleTime = 43'200.0;
  storm.lifetime = 3'600.0;
  storm.east = 20.0;
  storm.north = 5.0;
  std::vector<StormElement> elements;
  std::vector<StormVortex> vortices;
  AddElements(storm, 43'200.0 - 600.0, elements, vortices);
  AddElements(storm, 43'200.0 + 600.0, elements, vortices);
  ASSERT_EQ(elements.size(), 2U);
  EXPECT_NEAR(elements[1].x - elements[0].x, 24'000.0, 1e-6);
  EXPECT_NEAR(elements[1].y - elements[0].y, 6'000.0, 1e-6);
  elements.clear();
  AddElements(storm, 43'200.0 - 1'790.0, elements, vortices);
  EXPECT_LT(elements[0].peak, 0.0);
  elements.clear();
  AddElements(storm, 43'200.0 + 5'000.0, elements, vortices);
  EXPECT_TRUE(elements.empty());
}

TEST(StormElement, NothingReachesBeyondItsBounds)
{
  std::vector<StormElement> elements;
  std::vector<StormVortex> vortices;
  for (const StormLife& storm : MakeStormDay(1))
  {
    AddElements(storm, 65'000.0, elements, vortices);
  }
  ASSERT_AT_LEAST(elements.size(), 300U, "elements of the field");
  for (const StormElement& element : elements)
  {
    const ElementBounds bounds = BoundsOf(element);
    for (double z = bounds.bottom; z <= bounds.top; z += 500.0)
    {
      for (double share = -1.0; share <= 1.0; share += 0.25)
      {
        for (const double side : {-1.0, 1.0})
        {
          const auto at = [&](double along, double across)
          {
            return element.Reflectivity({bounds.x + along * bounds.alongX - across * bounds.alongY,
              bounds.y + along * bounds.alongY + across * bounds.alongX, z});
          };
          EXPECT_LT(
            at(side * (bounds.halfLength + 10.0), share * bounds.halfWidth), MinimumReflectivity);
          EXPECT_LT(
            at(share * bounds.halfLength, side * (bounds.halfWidth + 10.0)), MinimumReflectivity);
        }
      }
    }
    EXPECT_LT(element.Reflectivity({element.x, element.y, bounds.top + 10.0}), MinimumReflectivity);
  }
}
