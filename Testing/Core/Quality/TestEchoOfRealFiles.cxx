// SPDX-License-Identifier: BSD-3-Clause
// Formulas Q1 and Q2 on real files: ground echo of three published cases, and weather that must
// stay.
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Quality/EchoClassification.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

struct Place
{
  double azimuth; // degrees
  double range;   // m
  float value;    // dBZ
};

// Percent of the gates of a sweep, of those that `isMeant` names, that a level takes out.
double PercentOut(const std::filesystem::path& path, std::size_t number, QualityLevel level,
  const std::function<bool(const Place&)>& isMeant)
{
  const RadarVolume volume = ReadLevel2(path);
  const EchoClassification found = ClassifyEcho(volume);
  const PolarVolume reflectivity = MakePolarVolume(volume, MomentName::REF);
  const PolarSweep& sweep = reflectivity.sweeps.at(number);
  std::vector<std::uint16_t> codes(sweep.gates);
  std::size_t all = 0;
  std::size_t out = 0;
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.Read(ray, codes.data());
    for (std::size_t gate = 0; gate < sweep.gates; ++gate)
    {
      const Place place = {static_cast<double>(sweep.rays[ray].azimuth),
        sweep.firstGate + sweep.gateSpacing * static_cast<double>(gate),
        sweep.scale.ValueOf(codes[gate])};
      if (codes[gate] >= GateCode::FirstValue && isMeant(place))
      {
        ++all;
        const EchoReason reason = found.sweeps[number].At(ray, gate);
        out += RemovesClass(level, ClassOf(reason)) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(all, 100U) << path;
  return 100.0 * static_cast<double>(out) / static_cast<double>(all);
}

// Gates of weather, and those that the strict level takes out; cores are those from 45 dBZ on.
struct WeatherLost
{
  std::size_t weather = 0;
  std::size_t gone = 0;
  std::size_t cores = 0;
  std::size_t coresGone = 0;
};

// The values of a sweep, rays × gates; NaN where a gate has none.
std::vector<float> ValuesOf(const PolarSweep& sweep)
{
  std::vector<float> values;
  std::vector<std::uint16_t> codes(sweep.gates);
  for (std::size_t ray = 0; ray < sweep.rays.size(); ++ray)
  {
    sweep.Read(ray, codes.data());
    for (const std::uint16_t code : codes)
    {
      values.push_back(code >= GateCode::FirstValue ? sweep.scale.ValueOf(code) : std::nanf(""));
    }
  }
  return values;
}

// Whether ρ_hv of 0.95 and more prevails over an area about a gate: two thirds of the gates of five
// rays and nine gates have one, and seven in ten of these are as high.
bool IsUniform(const PolarSweep& sweep, const std::vector<float>& values, std::size_t at)
{
  const auto gates = static_cast<std::ptrdiff_t>(sweep.gates);
  const auto size = static_cast<std::ptrdiff_t>(values.size());
  std::size_t known = 0;
  std::size_t high = 0;
  for (std::ptrdiff_t ray = -2; ray <= 2; ++ray)
  {
    for (std::ptrdiff_t gate = -4; gate <= 4; ++gate)
    {
      const std::ptrdiff_t index =
        (static_cast<std::ptrdiff_t>(at) + ray * gates + gate + size) % size;
      const float value = values[static_cast<std::size_t>(index)];
      known += std::isnan(value) ? 0 : 1;
      high += value >= 0.95F ? 1 : 0;
    }
  }
  return known >= 30 && 10 * high >= 7 * known;
}

void AddSweep(const PolarSweep& reflectivity, const PolarSweep& correlation,
  const SweepReasons& reasons, WeatherLost& lost)
{
  const std::vector<float> echo = ValuesOf(reflectivity);
  const std::vector<float> uniform = ValuesOf(correlation);
  for (std::size_t i = 0; i < uniform.size(); ++i)
  {
    const std::size_t ray = i / correlation.gates;
    const std::size_t gate = i % correlation.gates;
    const std::size_t own = ray * reflectivity.gates + gate;
    if (gate < reflectivity.gates && echo[own] >= 0.0F && uniform[i] >= 0.85F &&
        IsUniform(correlation, uniform, i))
    {
      const bool gone = RemovesClass(QualityLevel::Strict, ClassOf(reasons.At(ray, gate)));
      const bool core = echo[own] >= 45.0F;
      ++lost.weather;
      lost.gone += gone ? 1 : 0;
      lost.cores += core ? 1 : 0;
      lost.coresGone += core && gone ? 1 : 0;
    }
  }
}

// Of the sweeps with two polarisations whose gates of both moments lie together.
WeatherLost LostIn(const std::filesystem::path& path)
{
  const RadarVolume volume = ReadLevel2(path);
  const EchoClassification found = ClassifyEcho(volume);
  const PolarVolume reflectivity = MakePolarVolume(volume, MomentName::REF);
  const PolarVolume correlation = MakePolarVolume(volume, MomentName::RHO);
  WeatherLost lost;
  for (std::size_t i = 0; i < reflectivity.sweeps.size(); ++i)
  {
    const PolarSweep& sweep = reflectivity.sweeps[i];
    for (const PolarSweep& other : correlation.sweeps)
    {
      if (other.elevationNumber == sweep.elevationNumber &&
          other.rays.size() == sweep.rays.size() && other.firstGate == sweep.firstGate)
      {
        AddSweep(sweep, other, found.sweeps[i], lost);
      }
    }
  }
  return lost;
}

bool AnyPlace(const Place&)
{
  return true;
}

bool IsCore(const Place& place)
{
  return place.value >= 45.0F;
}

} // namespace

// Anomalous propagation of 42 to 74 dBZ within a squall line; nearly all of it is gone 1° higher.
TEST(EchoOfRealFiles, GroundWithinASquallLineGoes)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const auto isGround = [](const Place& place)
  {
    return place.azimuth > 60.0 && place.azimuth < 115.0 && place.range > 65'000.0 &&
           place.range < 110'000.0 && place.value >= 42.0F;
  };
  const auto path = folder / "level2" / "quality" / "KLSX19930707_040351.gz";
  EXPECT_AT_LEAST(
    PercentOut(path, 0, QualityLevel::Standard, isGround), 95.0, "ground of KLSX 1993 gone, %");
  EXPECT_AT_MOST(PercentOut(path, 2, QualityLevel::Standard, AnyPlace), 0.95,
    "echo of KLSX 1993 at 2.4° gone, %");
}

TEST(EchoOfRealFiles, GroundBesideStormsGoes)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const auto isGround = [](const Place& place)
  {
    return (place.azimuth > 330.0 || place.azimuth < 30.0) && place.range > 50'000.0 &&
           place.range < 110'000.0;
  };
  const auto path = folder / "level2" / "quality" / "KAMA19940525_003434.gz";
  EXPECT_AT_LEAST(
    PercentOut(path, 0, QualityLevel::Standard, isGround), 85.0, "ground of KAMA 1994 gone, %");
  EXPECT_AT_MOST(PercentOut(path, 2, QualityLevel::Standard, IsCore), 0.48,
    "cores of KAMA 1994 at 2.4° lost, %");
}

// Showers in a light wind: much of them has no radial velocity.
TEST(EchoOfRealFiles, ShowersInALightWindStay)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const auto path = folder / "level2" / "quality" / "KMLB19980707_220118.gz";
  EXPECT_AT_MOST(PercentOut(path, 3, QualityLevel::Standard, AnyPlace), 2.0,
    "showers of KMLB 1998 at 3.4° lost, %");
}

TEST(EchoOfRealFiles, ATornadoStays)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const auto path = folder / "level2" / "legacy" / "KTLX19990503_235621.gz";
  const auto isHook = [](const Place& place)
  {
    return place.azimuth > 235.0 && place.azimuth < 275.0 && place.range > 25'000.0 &&
           place.range < 60'000.0 && place.value >= 25.0F;
  };
  EXPECT_EQ(PercentOut(path, 0, QualityLevel::Strict, isHook), 0.0);
  EXPECT_AT_MOST(
    PercentOut(path, 0, QualityLevel::Standard, AnyPlace), 2.4, "echo of KTLX 1999 gone, %");
}

TEST(EchoOfRealFiles, WidespreadRainAndSnowStay)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  struct File
  {
    const char* path;
    std::size_t sweep;
    double most; // percent
  };
  for (const File& file : {File{"superres/KCRP20170826_044114.bin", 0, 0.8},
         File{"superres/KDMX20220305_232324.bin", 0, 3.6},
         File{"superres/KBLX20090603_004417_V03.gz", 0, 4.6},
         File{"tdwr/TDAL20191021021543V08.raw.gz", 1, 0.44},
         File{"legacy/KVWX_20050626_221551.gz", 0, 1.1}})
  {
    EXPECT_AT_MOST(
      PercentOut(folder / "level2" / file.path, file.sweep, QualityLevel::Standard, AnyPlace),
      file.most, file.path);
  }
}

TEST(EchoOfRealFiles, StrongEchoOfStormsStaysAtTheStrictLevel)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  for (const char* path : {"superres/KCRP20170826_044114.bin", "superres/KDMX20220305_232324.bin",
         "tdwr/TDAL20191021021543V08.raw.gz"})
  {
    EXPECT_AT_MOST(PercentOut(folder / "level2" / path, 1, QualityLevel::Strict,
                     [](const Place& place) { return place.value >= 35.0F; }),
      0.4, "echo from 35 dBZ on lost at the strict level, %")
      << path;
  }
}

// Insects and birds on a summer morning.
TEST(EchoOfRealFiles, TheBloomOfASummerMorningIsBiological)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const auto path = folder / "level2" / "superres" / "KTLX20190715_120037_V06";
  EXPECT_AT_MOST(PercentOut(path, 0, QualityLevel::Standard, AnyPlace), 2.7,
    "bloom taken out at the standard level, %");
  EXPECT_AT_LEAST(PercentOut(path, 0, QualityLevel::Strict, AnyPlace), 65.0,
    "bloom taken out at the strict level, %");
}

// A night of birds that fly smoothly spread, and two others.
TEST(EchoOfRealFiles, BirdsOfANightAreBiological)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const auto isAirborne = [](const Place& place)
  { return place.range > 20'000.0 && place.range < 50'000.0 && place.value > 0.0F; };
  struct File
  {
    const char* path;
    std::size_t sweep;
    double least; // percent
  };
  for (const File& file : {File{"reports/radar/birds-as-weather/KBGM20151010_000227_V06", 0, 98.5},
         File{"reports/radar/birds-as-weather/KBGM20151010_000227_V06", 1, 98.5},
         File{"level2/pairs/KVBX20190501_093433_V06", 0, 95.0},
         File{"level2/pairs/KVBX20190501_094607_V06", 0, 95.0},
         File{"level2/damaged/KATX20160427_095248_V06.gz", 0, 91.0}})
  {
    EXPECT_AT_LEAST(PercentOut(folder / file.path, file.sweep, QualityLevel::Strict, isAirborne),
      file.least, file.path);
  }
}

// Weather lost at the strict level: of storms, and of rain beside birds and clear air.
TEST(EchoOfRealFiles, WeatherStaysAtTheStrictLevel)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  for (const char* path : {"superres/KCRP20170826_044114.bin", "superres/KDMX20220305_232324.bin",
         "superres/PGUA20160602_055618_V06.raw.gz", "chunks/KLOT-20210729",
         "chunks/KHDX-20240401-partial", "damaged/KATX20160427_095248_V06.gz"})
  {
    const WeatherLost lost = LostIn(folder / "level2" / path);
    EXPECT_GT(lost.weather, 5'000U) << path;
    EXPECT_AT_MOST(
      100.0 * static_cast<double>(lost.gone) / static_cast<double>(lost.weather), 0.3, path);
    EXPECT_EQ(lost.coresGone, 0U) << path << ", of " << lost.cores;
  }
}

// Halves of split cuts take classes of each other, whichever thread comes first.
TEST(EchoOfRealFiles, TheClassesDoNotDependOnTheOrderOfTheWork)
{
  NEXRAD_REQUIRE_TEST_DATA(folder);
  const RadarVolume volume =
    ReadLevel2(folder / "level2" / "superres" / "Level2_KFTG_20150430_1419.ar2v");
  const RangeLoop backward = [](int count, const std::function<void(int, int)>& work)
  {
    for (int i = count - 1; i >= 0; --i)
    {
      work(i, i + 1);
    }
  };
  const std::vector<SweepReasons> forward = ClassifyEcho(volume, ThreadLoop(1)).sweeps;
  const std::vector<SweepReasons> found = ClassifyEcho(volume, backward).sweeps;
  ASSERT_EQ(found.size(), forward.size());
  for (std::size_t sweep = 0; sweep < found.size(); ++sweep)
  {
    EXPECT_EQ(found[sweep].reasons, forward[sweep].reasons);
  }
}
