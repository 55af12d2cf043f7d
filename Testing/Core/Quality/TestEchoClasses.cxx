// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q1 to Q5: what the echo of hand-made sweeps is taken for, each reason by itself.
#include "EchoScene.h"
#include "Tolerance.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

float RadialWind(std::size_t ray, double speed)
{
  return static_cast<float>(speed * std::cos(static_cast<double>(ray) * 0.01745329252));
}

// Rain everywhere up to 130 km, in a wind of 15 m/s.
SceneGate Rain(std::size_t tilt, std::size_t ray, std::size_t gate)
{
  SceneGate rain;
  if (gate < 130)
  {
    rain.reflectivity = 30.0F + 1.5F * SceneNoise(tilt, ray, gate, 0);
    rain.velocity = RadialWind(ray, 15.0) + SceneNoise(tilt, ray, gate, 1);
  }
  return rain;
}

SceneGate WithPolarimetry(SceneGate gate, std::size_t tilt, std::size_t ray, std::size_t number)
{
  gate.correlation = 0.99F + 0.005F * SceneNoise(tilt, ray, number, 2);
  gate.ratio = 0.6F + 0.3F * SceneNoise(tilt, ray, number, 3);
  gate.phase = 60.0F + 2.0F * SceneNoise(tilt, ray, number, 4);
  return gate;
}

SceneGate Ground(std::size_t tilt, std::size_t ray, std::size_t gate)
{
  SceneGate ground;
  ground.reflectivity = 42.0F + 12.0F * SceneNoise(tilt, ray, gate, 0);
  ground.velocity = 0.4F * SceneNoise(tilt, ray, gate, 1);
  ground.width = 0.8F;
  ground.correlation = 0.65F + 0.2F * SceneNoise(tilt, ray, gate, 2);
  ground.ratio = 3.5F * SceneNoise(tilt, ray, gate, 3);
  ground.phase = 60.0F + 60.0F * SceneNoise(tilt, ray, gate, 4);
  return ground;
}

bool IsPatch(std::size_t ray, std::size_t gate)
{
  return ray >= 40 && ray < 80 && gate >= 40 && gate < 80;
}

bool IsBesidePatch(std::size_t ray, std::size_t gate)
{
  return ray >= 36 && ray < 84 && gate >= 34 && gate < 86 && !IsPatch(ray, gate);
}

// Rain with a patch of ground in the lowest tilt.
SceneGate RainAndGround(std::size_t tilt, std::size_t ray, std::size_t gate)
{
  return tilt == 0 && IsPatch(ray, gate) ? Ground(tilt, ray, gate) : Rain(tilt, ray, gate);
}

EchoScene OnePolarisation(const EchoScene::Gates& gates)
{
  EchoScene scene(gates);
  for (const MomentName name : {MomentName::RHO, MomentName::ZDR, MomentName::PHI})
  {
    scene.Remove(name);
  }
  return scene;
}

// Gates of a reason in a sweep.
std::size_t CountOf(const EchoClassification& found, std::size_t sweep, EchoReason reason)
{
  const std::vector<EchoReason>& reasons = found.sweeps[sweep].reasons;
  return static_cast<std::size_t>(std::count(reasons.begin(), reasons.end(), reason));
}

} // namespace

TEST(EchoClasses, GroundIsRoughAndStill)
{
  const EchoScene scene = OnePolarisation(RainAndGround);
  const EchoClassification found = scene.Classify();
  EXPECT_AT_LEAST(ShareOf(scene, found, 0, EchoClass::Ground, IsPatch), 0.98, "ground found");
  EXPECT_AT_MOST(
    ShareOf(scene, found, 0, EchoClass::Ground, IsBesidePatch), 0.08, "rain beside ground lost");
  const auto rest = [](std::size_t ray, std::size_t gate)
  { return !IsPatch(ray, gate) && !IsBesidePatch(ray, gate); };
  EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::Ground, rest), 0.0);
  EXPECT_EQ(ShareOf(scene, found, 1, EchoClass::Ground, Everywhere), 0.0);
  EXPECT_GT(CountOf(found, 0, EchoReason::GroundTexture), 1000U);
}

TEST(EchoClasses, TwoPolarisationsTellGround)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      const SceneGate found = RainAndGround(tilt, ray, gate);
      return std::isnan(found.reflectivity) || !std::isnan(found.correlation)
               ? found
               : WithPolarimetry(found, tilt, ray, gate);
    });
  const EchoClassification found = scene.Classify();
  EXPECT_AT_LEAST(ShareOf(scene, found, 0, EchoClass::Ground, IsPatch), 0.98, "ground found");
  EXPECT_AT_MOST(
    ShareOf(scene, found, 0, EchoClass::Ground, IsBesidePatch), 0.04, "rain beside ground lost");
  EXPECT_GT(CountOf(found, 0, EchoReason::GroundPolarimetry), 1000U);
}

// Widespread rain whose velocity is small everywhere, and rough showers that turn past zero.
TEST(EchoClasses, RainAlongTheZeroLineStays)
{
  const EchoScene calm = OnePolarisation(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate rain = Rain(tilt, ray, gate);
      rain.velocity = RadialWind(ray, 3.0) + 0.3F * SceneNoise(tilt, ray, gate, 1);
      rain.width = 1.0F;
      return rain;
    });
  EXPECT_EQ(ShareOf(calm, calm.Classify(), 0, EchoClass::Ground, Everywhere), 0.0);
  const EchoScene showers = OnePolarisation(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate rain = Rain(tilt, ray, gate);
      rain.reflectivity = 30.0F + 9.0F * SceneNoise(0, ray / 2, gate / 2, 0);
      rain.velocity = RadialWind(ray, 8.0) + 0.3F * SceneNoise(tilt, ray, gate, 1);
      rain.width = 1.2F;
      return rain;
    });
  const EchoClassification found = showers.Classify();
  for (std::size_t sweep = 0; sweep < 3; ++sweep)
  {
    EXPECT_AT_MOST(ShareOf(showers, found, sweep, EchoClass::Ground, Everywhere), 0.002,
      "rough showers lost along the zero line");
  }
}

TEST(EchoClasses, ASpikeHasOnePower)
{
  const EchoScene scene = OnePolarisation(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate spike = ray < 90 && gate < 60 ? Rain(tilt, ray, gate) : SceneGate();
      if (ray == 40 || ray == 200)
      {
        const double range = static_cast<double>(gate + 1);
        const double power = -20.0 + 20.0 * std::log10(range);
        spike.reflectivity = std::max(std::isnan(spike.reflectivity) ? -99.0F : spike.reflectivity,
          static_cast<float>(power) + SceneNoise(tilt, ray, gate, 5));
      }
      return spike;
    });
  const EchoClassification found = scene.Classify();
  const auto isSpike = [](std::size_t ray, std::size_t gate)
  { return gate > 12 && (ray == 200 || (ray == 40 && gate >= 60)); };
  EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::Spike, isSpike), 1.0);
  const auto isRain = [](std::size_t ray, std::size_t gate) { return ray < 90 && gate < 60; };
  EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::Weather, isRain), 1.0);
}

TEST(EchoClasses, ARayOfOneValueIsAFault)
{
  const EchoScene scene = OnePolarisation(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate rain = Rain(tilt, ray, gate);
      rain.reflectivity = ray == 7 ? 35.0F : rain.reflectivity;
      return rain;
    });
  const EchoClassification found = scene.Classify();
  EXPECT_EQ(CountOf(found, 0, EchoReason::ConstantValue), 150U);
  EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::ReceiverFault,
              [](std::size_t ray, std::size_t) { return ray != 7; }),
    0.0);
}

TEST(EchoClasses, FewerThanThreeGatesAreSpeckle)
{
  const EchoScene scene = OnePolarisation(
    [](std::size_t, std::size_t ray, std::size_t gate)
    {
      SceneGate few;
      const bool pair = ray == 10 && (gate == 50 || gate == 51);
      const bool three = (ray == 30 && gate == 50) || (ray == 31 && (gate == 51 || gate == 52));
      few.reflectivity = pair || three ? 20.0F : few.reflectivity;
      return few;
    });
  const EchoClassification found = scene.Classify();
  EXPECT_EQ(CountOf(found, 0, EchoReason::FewGates), 2U);
  EXPECT_EQ(CountOf(found, 0, EchoReason::Plain), 3U);
}

// Hail and the melting layer have a low ρ_hv.
TEST(EchoClasses, HailAndTheMeltingLayerAreWeather)
{
  const auto isHail = [](std::size_t ray, std::size_t gate)
  { return ray >= 100 && ray < 110 && gate >= 60 && gate < 70; };
  const auto isMelting = [](std::size_t tilt, std::size_t gate)
  { return tilt == 2 && gate >= 50 && gate < 60; };
  const EchoScene scene(
    [&](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate rain = Rain(tilt, ray, gate);
      if (std::isnan(rain.reflectivity))
      {
        return rain;
      }
      rain = WithPolarimetry(rain, tilt, ray, gate);
      if (isHail(ray, gate))
      {
        rain.reflectivity = 60.0F + SceneNoise(tilt, ray, gate, 0);
        rain.correlation = 0.85F + 0.08F * SceneNoise(tilt, ray, gate, 2);
      }
      else if (isMelting(tilt, gate))
      {
        rain.reflectivity += 5.0F;
        rain.correlation = 0.90F + 0.04F * SceneNoise(tilt, ray, gate, 2);
        rain.ratio += 1.0F + SceneNoise(tilt, ray, gate, 3);
        rain.phase += 5.0F * SceneNoise(tilt, ray, gate, 4);
      }
      return rain;
    });
  const EchoClassification found = scene.Classify();
  for (std::size_t sweep = 0; sweep < 4; ++sweep)
  {
    EXPECT_EQ(ShareOf(scene, found, sweep, EchoClass::Weather, Everywhere), 1.0) << sweep;
  }
  EXPECT_EQ(CountOf(found, 0, EchoReason::StrongCore), 100U);
  EXPECT_AT_LEAST(CountOf(found, 2, EchoReason::MeltingLayer), 3'400U, "gates of melting layer");
}

TEST(EchoClasses, DebrisAtACoupletIsWeather)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate rain = Rain(tilt, ray, gate);
      if (std::isnan(rain.reflectivity))
      {
        return rain;
      }
      rain = WithPolarimetry(rain, tilt, ray, gate);
      if (ray >= 58 && ray < 62 && gate >= 48 && gate < 53)
      {
        rain.reflectivity = 48.0F + 3.0F * SceneNoise(tilt, ray, gate, 0);
        rain.velocity = ray < 60 ? -24.0F : 24.0F;
        rain.correlation = 0.55F + 0.2F * SceneNoise(tilt, ray, gate, 2);
        rain.ratio = 3.0F * SceneNoise(tilt, ray, gate, 3);
        rain.phase += 60.0F * SceneNoise(tilt, ray, gate, 4);
      }
      return rain;
    });
  const EchoClassification found = scene.Classify();
  EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::Weather, Everywhere), 1.0);
  EXPECT_AT_LEAST(CountOf(found, 0, EchoReason::Debris), 3U, "gates of debris, of 20");
}

TEST(EchoClasses, BirdsAreToldApart)
{
  const EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate bird;
      if (gate < 60 - 15 * tilt)
      {
        bird.reflectivity = 14.0F + 3.0F * SceneNoise(tilt, ray, gate, 0);
        bird.velocity = RadialWind(ray, 15.0) + SceneNoise(tilt, ray, gate, 1);
        bird.correlation = 0.55F + 0.2F * SceneNoise(tilt, ray, gate, 2);
        bird.ratio = 4.0F + 3.0F * SceneNoise(tilt, ray, gate, 3);
        bird.phase = 100.0F + 40.0F * SceneNoise(tilt, ray, gate, 4);
      }
      return bird;
    });
  const EchoClassification found = scene.Classify();
  // Farther away they are hardly stronger than noise.
  const auto isNear = [](std::size_t, std::size_t gate) { return gate < 30; };
  EXPECT_AT_LEAST(
    ShareOf(scene, found, 0, EchoClass::Biological, isNear), 0.98, "birds told apart");
  PolarVolume kept = scene.Measured(MomentName::REF);
  const ReasonCounts standard = TakeOut(kept, found, QualityLevel::Standard);
  EXPECT_EQ(standard[static_cast<std::size_t>(EchoReason::FlightPolarimetry)], 0U);
  PolarVolume strict = scene.Measured(MomentName::REF);
  const ReasonCounts counts = TakeOut(strict, found, QualityLevel::Strict);
  EXPECT_EQ(counts[static_cast<std::size_t>(EchoReason::FlightPolarimetry)],
    found.counts[static_cast<std::size_t>(EchoReason::FlightPolarimetry)]);
}

// Without ρ_hv: weak echo about the radar that ends below 3 km, beside rain that does not.
TEST(EchoClasses, ClearAirIsShallow)
{
  const EchoScene scene = OnePolarisation(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      SceneGate air = ray < 180 ? Rain(tilt, ray, gate) : SceneGate();
      if (ray >= 180 && gate < 60 && tilt < 3)
      {
        air.reflectivity = 5.0F + 3.0F * SceneNoise(tilt, ray, gate, 0);
        air.velocity = RadialWind(ray, 10.0);
      }
      return air;
    });
  const EchoClassification found = scene.Classify();
  const auto isAir = [](std::size_t ray, std::size_t gate)
  { return ray >= 180 && gate >= 45 && gate < 60; };
  EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::Biological, isAir), 1.0);
  EXPECT_EQ(ShareOf(scene, found, 0, EchoClass::Biological,
              [](std::size_t ray, std::size_t) { return ray < 180; }),
    0.0);
}

TEST(EchoClasses, HalvesOfASplitCutServeEachOther)
{
  EchoScene scene(
    [](std::size_t tilt, std::size_t ray, std::size_t gate)
    {
      const SceneGate found = RainAndGround(tilt, ray, gate);
      return std::isnan(found.reflectivity) || !std::isnan(found.correlation)
               ? found
               : WithPolarimetry(found, tilt, ray, gate);
    });
  scene.SplitFirstTilt();
  const EchoClassification found = scene.Classify();
  ASSERT_EQ(found.sweeps.size(), 5U);
  EXPECT_AT_LEAST(ShareOf(scene, found, 0, EchoClass::Ground, IsPatch), 0.98, "ground found");
  EXPECT_EQ(found.sweeps[0].reasons, found.sweeps[1].reasons);
}

TEST(EchoClasses, DoNotDependOnThreads)
{
  const EchoScene scene = OnePolarisation(RainAndGround);
  const EchoClassification one = scene.Classify(ThreadLoop(1));
  const EchoClassification four = scene.Classify(ThreadLoop(4));
  ASSERT_EQ(one.sweeps.size(), four.sweeps.size());
  for (std::size_t sweep = 0; sweep < one.sweeps.size(); ++sweep)
  {
    EXPECT_EQ(one.sweeps[sweep].reasons, four.sweeps[sweep].reasons);
  }
  EXPECT_EQ(one.counts, four.counts);
  const std::size_t gates = std::accumulate(one.counts.begin(), one.counts.end(), std::size_t(0));
  EXPECT_EQ(gates, 4U * 360U * 150U);
}

TEST(EchoClasses, OfVolumesThatLackMoments)
{
  EchoScene scene = OnePolarisation(RainAndGround);
  scene.Remove(MomentName::SW);
  EXPECT_EQ(scene.Classify().sweeps.size(), 4U);
  scene.Remove(MomentName::VEL);
  // Without any velocity nothing is surely ground.
  EXPECT_EQ(ShareOf(scene, scene.Classify(), 0, EchoClass::Weather, Everywhere), 1.0);
  scene.Remove(MomentName::REF);
  EXPECT_TRUE(scene.Classify().sweeps.empty());
}

TEST(TakeOut, MakesGatesFiltered)
{
  const EchoScene scene = OnePolarisation(RainAndGround);
  const EchoClassification found = scene.Classify();
  const PolarVolume before = scene.Measured(MomentName::REF);
  PolarVolume volume = before;
  const ReasonCounts counts = TakeOut(volume, found, QualityLevel::Standard);
  EXPECT_GT(counts[static_cast<std::size_t>(EchoReason::GroundTexture)], 1000U);
  EXPECT_EQ(counts[static_cast<std::size_t>(EchoReason::Plain)], 0U);
  std::vector<std::uint16_t> codes(150);
  std::vector<std::uint16_t> old(150);
  for (std::size_t ray = 0; ray < 360; ++ray)
  {
    volume.sweeps[0].Read(ray, codes.data());
    before.sweeps[0].Read(ray, old.data());
    for (std::size_t gate = 0; gate < 150; ++gate)
    {
      const EchoClass echoClass = ClassOf(found.sweeps[0].At(ray, gate));
      ASSERT_EQ(codes[gate], RemovesClass(QualityLevel::Standard, echoClass)
                               ? std::uint16_t(GateCode::Filtered)
                               : old[gate]);
    }
  }
}

TEST(TakeOut, OffChangesNothing)
{
  const EchoScene scene = OnePolarisation(RainAndGround);
  const EchoClassification found = scene.Classify();
  PolarVolume volume = scene.Measured(MomentName::REF);
  EXPECT_EQ(TakeOut(volume, found, QualityLevel::Off), ReasonCounts{});
  EXPECT_EQ(NumbersOf(volume.sweeps[0]).states,
    NumbersOf(scene.Measured(MomentName::REF).sweeps[0]).states);
}

TEST(TakeOut, NeedsTheVolumeThatWasClassified)
{
  const EchoScene scene = OnePolarisation(RainAndGround);
  const EchoClassification found = scene.Classify();
  PolarVolume fewer = scene.Measured(MomentName::REF);
  fewer.sweeps.pop_back();
  EXPECT_THROW(TakeOut(fewer, found, QualityLevel::Standard), Error);
  PolarVolume shorter = scene.Measured(MomentName::REF);
  shorter.sweeps[0].gates = 100;
  EXPECT_THROW(TakeOut(shorter, found, QualityLevel::Standard), Error);
}

TEST(TakeOut, LevelsDifferInBiologicalEcho)
{
  for (const EchoClass each :
    {EchoClass::Ground, EchoClass::Spike, EchoClass::ReceiverFault, EchoClass::Speckle})
  {
    EXPECT_FALSE(RemovesClass(QualityLevel::Off, each));
    EXPECT_TRUE(RemovesClass(QualityLevel::Standard, each));
    EXPECT_TRUE(RemovesClass(QualityLevel::Strict, each));
  }
  EXPECT_FALSE(RemovesClass(QualityLevel::Standard, EchoClass::Biological));
  EXPECT_TRUE(RemovesClass(QualityLevel::Strict, EchoClass::Biological));
  EXPECT_FALSE(RemovesClass(QualityLevel::Strict, EchoClass::Weather));
}
