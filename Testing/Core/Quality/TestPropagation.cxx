// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q1: anomalous propagation whose velocity is not 0, in hand-made sweeps and in a
// published case without its velocities, and shallow weather that the tilt above does not see
// either.
#include "EchoScene.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// Echo of the sea or the ground that moves: rough, patchy, up to 50 dBZ, in the lowest tilt alone.
SceneGate Propagation(std::size_t tilt, std::size_t ray, std::size_t gate)
{
  SceneGate echo;
  if (tilt == 0 && SceneNoise(0, ray / 2, gate / 3, 5) > -0.6F)
  {
    echo.reflectivity = 27.0F + 12.0F * SceneNoise(tilt, ray / 4, gate / 8, 6) +
                        11.0F * SceneNoise(tilt, ray, gate, 0);
    echo.velocity = 6.0F + 1.5F * SceneNoise(tilt, ray, gate, 1);
  }
  return echo;
}

// Snow up to 1.5 km: the tilts above lose it from 25 km on, one after the other.
SceneGate ShallowSnow(std::size_t tilt, std::size_t ray, std::size_t gate)
{
  constexpr std::array<std::size_t, 4> last = {110, 50, 32, 19}; // gates
  SceneGate snow;
  if (gate < last[tilt])
  {
    snow.reflectivity =
      24.0F + 7.0F * SceneNoise(0, ray / 6, gate / 6, 6) + 2.0F * SceneNoise(tilt, ray, gate, 0);
    snow.velocity = 10.0F * static_cast<float>(std::cos(static_cast<double>(ray) * 0.01745329252)) +
                    SceneNoise(tilt, ray, gate, 1);
  }
  return snow;
}

// Rain close to the radar, so that each tilt has echo.
SceneGate NearRain(std::size_t tilt, std::size_t ray, std::size_t gate)
{
  SceneGate rain;
  if (gate < 12)
  {
    rain.reflectivity = 15.0F + 2.0F * SceneNoise(tilt, ray, gate, 0);
    rain.velocity = 8.0F + SceneNoise(tilt, ray, gate, 1);
  }
  return rain;
}

bool IsArea(std::size_t ray, std::size_t gate)
{
  return ray >= 90 && ray < 160 && gate >= 70 && gate < 145;
}

// Rays along which the wind of the snow blows: beside others its velocity is near 0.
bool IsInWind(std::size_t ray, std::size_t)
{
  return ray < 60 || (ray >= 120 && ray < 240) || ray >= 300;
}

// Part of the gates of the lowest sweep beyond 15 km, of those that `isMeant` names.
double GroundOf(const EchoScene& scene, bool (*isMeant)(std::size_t, std::size_t) = Everywhere)
{
  return ShareOf(scene, scene.Classify(), 0, EchoClass::Ground,
    [isMeant](std::size_t ray, std::size_t gate) { return gate >= 15 && isMeant(ray, gate); });
}

} // namespace

TEST(Propagation, ThatMovesIsGround)
{
  const EchoScene scene([](std::size_t tilt, std::size_t ray, std::size_t gate)
    { return IsArea(ray, gate) ? Propagation(tilt, ray, gate) : NearRain(tilt, ray, gate); });
  EXPECT_AT_LEAST(100.0 * GroundOf(scene), 90.0, "propagation at 6 m/s that is ground, %");
}

// A split cut, as all radars send it below 2°: both halves lose the echo.
TEST(Propagation, IsGroundInBothHalvesOfASplitCut)
{
  EchoScene scene([](std::size_t tilt, std::size_t ray, std::size_t gate)
    { return IsArea(ray, gate) ? Propagation(tilt, ray, gate) : NearRain(tilt, ray, gate); });
  scene.SplitFirstTilt();
  const EchoClassification found = scene.Classify();
  for (const std::size_t sweep : {0U, 1U})
  {
    EXPECT_AT_LEAST(100.0 * ShareOf(scene, found, sweep, EchoClass::Ground, IsArea), 90.0,
      "propagation of a split cut that is ground, %");
  }
}

TEST(Propagation, IsNotShallowSnow)
{
  EXPECT_EQ(GroundOf(EchoScene(ShallowSnow), IsInWind), 0.0);
}

// Snow to one side and propagation to the other: only the latter goes.
TEST(Propagation, GoesBesideShallowSnow)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      return IsArea(ray, gate)         ? Propagation(tilt, ray, gate)
             : ray >= 180 && ray < 240 ? ShallowSnow(tilt, ray, gate)
                                       : NearRain(tilt, ray, gate);
    });
  EXPECT_AT_LEAST(100.0 * GroundOf(scene, IsArea), 90.0, "propagation beside snow, ground, %");
  EXPECT_EQ(GroundOf(scene, [](std::size_t ray, std::size_t) { return ray >= 180; }), 0.0);
}

// Rough showers that the tilt above sees, and their edges that it does not.
TEST(Propagation, IsNotTheEdgeOfShowers)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      if (!IsArea(ray, gate))
      {
        return NearRain(tilt, ray, gate);
      }
      const bool isEdge = ray % 14 < 2 || gate % 15 < 2;
      return tilt == 0 || (tilt == 1 && !isEdge) ? Propagation(0, ray, gate) : SceneGate{};
    });
  EXPECT_EQ(GroundOf(scene), 0.0);
}

// Two polarisations that tell of rain decide.
TEST(Propagation, IsNotWhatTwoPolarisationsCallRain)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate echo = IsArea(ray, gate) ? Propagation(tilt, ray, gate) : NearRain(tilt, ray, gate);
      echo.correlation = std::isnan(echo.reflectivity) ? echo.correlation : 0.99F;
      return echo;
    });
  EXPECT_EQ(GroundOf(scene), 0.0);
}

// KAMA on 1994-05-25 as if its ground echo moved: without its velocities.
TEST(Propagation, OfAPublishedCaseWithoutVelocitiesIsGround)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const RadarVolume volume = ReadLevel2(folder / "level2" / "quality" / "KAMA19940525_003434.gz");
  const PolarVolume reflectivity = MakePolarVolume(volume, MomentName::REF);
  const EchoClassification found = ClassifyEcho(reflectivity,
    [&volume](MomentName moment, const WantedRange& wanted)
    {
      PolarVolume measured = MakePolarVolume(volume, moment, wanted);
      measured.sweeps.clear();
      return measured;
    });
  const PolarSweep& sweep = reflectivity.sweeps.front();
  const NumberSweep numbers = NumbersOf(sweep);
  std::size_t all = 0;
  std::size_t ground = 0;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    const float azimuth = sweep.rays[ray].azimuth;
    for (std::size_t gate = 50; gate < 110 && (azimuth > 330.0F || azimuth < 30.0F); ++gate)
    {
      const std::size_t index = numbers.Index(ray, gate);
      if (numbers.states[index] == GateState::Valid && numbers.values[index] >= 10.0F)
      {
        ++all;
        ground += ClassOf(found.sweeps[0].At(ray, gate)) == EchoClass::Ground ? 1 : 0;
      }
    }
  }
  ASSERT_GT(all, 1'000U);
  EXPECT_AT_LEAST(100.0 * static_cast<double>(ground) / static_cast<double>(all), 50.0,
    "ground of KAMA 1994 without velocities gone, %");
}
