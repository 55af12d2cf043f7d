// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q2 on hand-made sweeps of two polarisations: birds, and weather with as low a ρ_hv.
#include "EchoScene.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// What two polarisations measure: ρ_hv, Z_DR in dB and Φ_DP in degrees, each with its noise.
struct Polarimetry
{
  float correlation;
  float correlationNoise;
  float ratio;
  float ratioNoise;
  float phaseNoise;
};
constexpr Polarimetry rain = {0.99F, 0.008F, 0.8F, 0.3F, 2.0F};
constexpr Polarimetry birds = {0.65F, 0.2F, 2.0F, 1.2F, 14.0F};

SceneGate Make(float reflectivity, const Polarimetry& polarimetry, std::size_t tilt,
  std::size_t ray, std::size_t gate)
{
  const auto noise = [&](std::size_t kind) { return SceneNoise(tilt, ray, gate, kind); };
  SceneGate made;
  made.reflectivity = reflectivity + noise(0);
  made.velocity =
    static_cast<float>(15.0 * std::cos(static_cast<double>(ray) * 0.01745329252)) + noise(1);
  made.correlation = polarimetry.correlation + polarimetry.correlationNoise * noise(2);
  made.ratio = polarimetry.ratio + polarimetry.ratioNoise * noise(3);
  made.phase += polarimetry.phaseNoise * noise(4);
  return made;
}

// A gate that shows how weak echo can be, at 5 km of every fifth ray.
bool IsWeakest(std::size_t ray, std::size_t gate)
{
  return ray % 5 == 0 && gate == 4;
}

// Smooth echo of birds about the radar, up to 1.5 km high.
SceneGate Night(std::size_t tilt, std::size_t ray, std::size_t gate)
{
  const std::size_t end = tilt == 0 ? 60 : tilt == 1 ? 45 : tilt == 2 ? 30 : 18;
  return gate < end ? Make(IsWeakest(ray, gate) ? -30.0F : 8.0F, birds, tilt, ray, gate)
                    : SceneGate();
}

bool IsLowPatch(std::size_t ray, std::size_t gate)
{
  return ray >= 100 && ray < 112 && gate >= 58 && gate < 70;
}

} // namespace

// ρ_hv of 0.65, Z_DR about 2 dB, smooth reflectivity and little spread, as in KBGM 2015-10-10.
TEST(BiologicalEcho, SmoothEchoOfALowCorrelationIsBiological)
{
  EchoScene scene(Night);
  scene.SplitFirstTilt();
  const EchoClassification found = scene.Classify();
  const auto isFar = [](std::size_t, std::size_t gate) { return gate >= 20 && gate < 50; };
  for (const std::size_t half : {0U, 1U})
  {
    EXPECT_AT_LEAST(ShareOf(scene, found, half, EchoClass::Biological, isFar), 0.97,
      "birds of smooth echo told apart");
  }
}

// Whoever looks at what is merged learns how much of it is biological.
TEST(BiologicalEcho, CountsAsLongAsItIsThere)
{
  const EchoClassification found = EchoScene(Night).Classify();
  const EchoGates standard = GatesLeft(found.counts, QualityLevel::Standard);
  EXPECT_AT_LEAST(static_cast<double>(standard.biological) / static_cast<double>(standard.all), 0.9,
    "biological part of what the standard level leaves");
  const EchoGates strict = GatesLeft(found.counts, QualityLevel::Strict);
  EXPECT_EQ(strict.biological, 0U);
  EXPECT_EQ(strict.all, standard.all - standard.biological);
}

// Rain below, snow above, and between them at one height wet snow: half as thick as the beam is
// wide, ρ_hv 0.87 in the middle.
TEST(BiologicalEcho, ARingOfWetSnowIsWeather)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      const std::size_t from = tilt == 0 ? 105 : tilt == 1 ? 66 : tilt == 2 ? 46 : 28;
      if (gate >= 130)
      {
        return SceneGate();
      }
      if (gate < from)
      {
        return Make(30.0F, rain, tilt, ray, gate);
      }
      return gate < from + 14 ? Make(34.0F, {0.87F, 0.05F, 1.8F, 1.0F, 8.0F}, tilt, ray, gate)
                              : Make(18.0F, {0.975F, 0.015F, 0.3F, 0.3F, 3.0F}, tilt, ray, gate);
    });
  const EchoClassification found = scene.Classify();
  for (std::size_t sweep = 0; sweep < 4; ++sweep)
  {
    EXPECT_EQ(ShareOf(scene, found, sweep, EchoClass::Weather, Everywhere), 1.0) << sweep;
  }
}

// Weak snow, whose Z_DR is large where crystals lie flat.
TEST(BiologicalEcho, SnowIsWeather)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      const Polarimetry snow = {0.965F, 0.03F, ray < 180 ? 0.3F : 4.0F, 0.8F, 5.0F};
      return gate < 90 ? Make(IsWeakest(ray, gate) ? -30.0F : 10.0F, snow, tilt, ray, gate)
                       : SceneGate();
    });
  const EchoClassification found = scene.Classify();
  for (std::size_t sweep = 0; sweep < 4; ++sweep)
  {
    EXPECT_EQ(ShareOf(scene, found, sweep, EchoClass::Biological, Everywhere), 0.0) << sweep;
  }
}

// Small hail, the debris of a tornado, or the ashes of a fire: ρ_hv is low, and the echo goes on to
// heights where neither birds nor insects fly.
TEST(BiologicalEcho, DeepEchoOfALowCorrelationIsWeather)
{
  for (const float reflectivity : {18.0F, 33.0F})
  {
    const EchoScene scene(
      [reflectivity](std::size_t tilt, std::size_t ray, std::size_t gate)
      {
        return IsWeakest(ray, gate) ? Make(-30.0F, birds, tilt, ray, gate)
               : IsLowPatch(ray, gate)
                 ? Make(reflectivity, {0.5F, 0.2F, 2.0F, 2.0F, 30.0F}, tilt, ray, gate)
                 : SceneGate();
      });
    const EchoClassification found = scene.Classify();
    EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::Biological, IsLowPatch), 0.0) << reflectivity;
  }
}

// The same echo where the tilts above are empty.
TEST(BiologicalEcho, ShallowEchoOfALowCorrelationIsBiological)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      return IsWeakest(ray, gate) ? Make(-30.0F, birds, tilt, ray, gate)
             : tilt < 2 && IsLowPatch(ray, gate)
               ? Make(18.0F, {0.5F, 0.2F, 2.0F, 2.0F, 30.0F}, tilt, ray, gate)
               : SceneGate();
    });
  const EchoClassification found = scene.Classify();
  EXPECT_AT_LEAST(
    ShareOf(scene, found, 0, EchoClass::Biological, IsLowPatch), 0.85, "shallow echo told apart");
}

// One gate in the core of a storm whose velocity is 0.
TEST(BiologicalEcho, AStillGateInACoreIsNoGround)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate core = gate < 100 ? Make(52.0F, rain, tilt, ray, gate) : SceneGate();
      core.velocity = ray == 20 && gate == 60 ? 0.0F : core.velocity;
      return core;
    });
  EXPECT_EQ(ShareOf(scene, scene.Classify(), 0, EchoClass::Weather, Everywhere), 1.0);
}
