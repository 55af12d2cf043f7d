// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/PolarVolume.h"

#include "SweepMaker.h"
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace nexrad;
using nexrad::testing::NumbersOf;
using nexrad::testing::NumberSweep;

namespace
{

constexpr std::uint8_t words[] = {0, 1, 2, 66, 255};
constexpr std::uint8_t wideWords[] = {0, 0, 0, 1, 1, 0}; // 0, 1, 256

Ray MakeRay(float azimuth, std::uint16_t gates, std::int32_t firstGate)
{
  Ray ray;
  ray.time = Time(Duration(static_cast<int>(azimuth) * 1000));
  ray.azimuth = azimuth;
  ray.elevation = 0.5F;
  ray.elevationNumber = 3;
  MomentRow& row = ray.Row(MomentName::REF);
  row.words = words;
  row.gates = gates;
  row.firstGate = firstGate;
  row.gateSpacing = 1000;
  row.scale = 2.0F;
  row.offset = 66.0F;
  return ray;
}

// Whether each gate of a sweep whose rays have one geometry is what its word says.
void ExpectWords(const Sweep& source, MomentName moment, const PolarSweep& sweep)
{
  const NumberSweep numbers = NumbersOf(sweep);
  std::size_t ray = 0;
  for (const Ray& each : source.rays)
  {
    const MomentRow& row = each.Row(moment);
    for (std::size_t gate = 0; gate < std::min<std::size_t>(row.gates, sweep.gates); ++gate)
    {
      const std::size_t index = numbers.Index(ray, gate);
      const GateState state = numbers.states[index];
      ASSERT_TRUE(state == row.State(gate) ||
                  (state == GateState::NotSampled && row.State(gate) == GateState::BelowThreshold));
      if (state == GateState::Valid)
      {
        ASSERT_NEAR(numbers.values[index], row.Value(gate), 1e-6F);
      }
    }
    ray += row.gates > 0 ? 1 : 0;
  }
}

RadarVolume MakeVolume(std::vector<Ray> rays)
{
  RadarVolume volume;
  volume.site.name = "KLSX";
  volume.sweeps.push_back({3, std::move(rays)});
  return volume;
}

} // namespace

TEST(PolarVolume, ConvertsWordsToValuesAndStates)
{
  const PolarVolume polar = MakePolarVolume(MakeVolume({MakeRay(10.0F, 5, 0)}), MomentName::REF);
  EXPECT_EQ(polar.site.name, "KLSX");
  ASSERT_EQ(polar.sweeps.size(), 1U);
  const NumberSweep sweep = NumbersOf(polar.sweeps[0]);
  EXPECT_EQ(sweep.elevationNumber, 3);
  ASSERT_EQ(sweep.gates, 5U);
  EXPECT_EQ(sweep.states, (std::vector<GateState>{GateState::BelowThreshold, GateState::RangeFolded,
                            GateState::Valid, GateState::Valid, GateState::Valid}));
  EXPECT_TRUE(std::isnan(sweep.values[0]));
  EXPECT_TRUE(std::isnan(sweep.values[1]));
  EXPECT_EQ(sweep.values[2], -32.0F);
  EXPECT_EQ(sweep.values[3], 0.0F);
  EXPECT_EQ(sweep.values[4], 94.5F);
}

// Such words stand at the edges of echo in files of 2005.
TEST(PolarVolume, AWidthBelowZeroIsNotSampled)
{
  Ray ray = MakeRay(10.0F, 5, 0);
  ray.Row(MomentName::SW) = ray.Row(MomentName::REF); // words 2 and 66 are -32 and 0
  const PolarVolume polar = MakePolarVolume(MakeVolume({ray}), MomentName::SW);
  const NumberSweep sweep = NumbersOf(polar.sweeps[0]);
  EXPECT_EQ(sweep.states[2], GateState::NotSampled);
  EXPECT_TRUE(std::isnan(sweep.values[2]));
  EXPECT_EQ(sweep.states[3], GateState::Valid);
  EXPECT_EQ(sweep.values[3], 0.0F);
}

TEST(PolarVolume, ReadsWordsOfSixteenBits)
{
  Ray ray = MakeRay(0.0F, 3, 2125);
  ray.Row(MomentName::REF).words = wideWords;
  ray.Row(MomentName::REF).wordBits = 16;
  const PolarVolume polar = MakePolarVolume(MakeVolume({ray}), MomentName::REF);
  ASSERT_EQ(polar.sweeps.size(), 1U);
  const NumberSweep sweep = NumbersOf(polar.sweeps[0]);
  EXPECT_EQ(sweep.firstGate, 2125.0);
  EXPECT_EQ(sweep.states[1], GateState::RangeFolded);
  EXPECT_EQ(sweep.values[2], 95.0F);
}

// Formulas G13: no echo beyond the unambiguous range is not scanned. Of Doppler moments the radar
// itself says where they end.
// The codes are the words plus one, and so the file's scale and offset stay exact.
TEST(PolarVolume, ACodeIsTheWordPlusTwo)
{
  Ray ray = MakeRay(10.0F, 5, 0);
  ray.Row(MomentName::PHI) = ray.Row(MomentName::REF);
  ray.Row(MomentName::PHI).scale = 2.8361F;
  ray.Row(MomentName::PHI).offset = 2.0F;
  ray.Row(MomentName::CFP) = ray.Row(MomentName::REF);
  ray.Row(MomentName::CFP).firstValue = 8;
  const auto codesOf = [&ray](MomentName moment)
  {
    std::vector<std::uint16_t> codes(5);
    MakePolarVolume(MakeVolume({ray}), moment).sweeps[0].Read(0, codes.data());
    return codes;
  };
  EXPECT_EQ(codesOf(MomentName::REF), (std::vector<std::uint16_t>{0, 1, 4, 68, 257}));
  EXPECT_EQ(codesOf(MomentName::PHI), (std::vector<std::uint16_t>{0, 1, 4, 68, 257}));
  EXPECT_EQ(codesOf(MomentName::CFP), (std::vector<std::uint16_t>{0, 0, 0, 68, 257}));
  const PolarVolume phase = MakePolarVolume(MakeVolume({ray}), MomentName::PHI);
  EXPECT_FLOAT_EQ(phase.sweeps[0].scale.ValueOf(std::uint16_t(68)), 64.0F / 2.8361F);
}

// Between rays is interpolated: they get one scale, in which the values of both are.
TEST(PolarVolume, RaysOfTwoScalesGetOneThatHasBoth)
{
  Ray coarse = MakeRay(11.0F, 5, 0);
  coarse.Row(MomentName::REF).scale = 1.0F;
  coarse.Row(MomentName::REF).offset = 64.0F;
  const PolarVolume polar =
    MakePolarVolume(MakeVolume({MakeRay(10.0F, 5, 0), coarse}), MomentName::REF);
  ASSERT_EQ(polar.sweeps.size(), 1U);
  const NumberSweep sweep = NumbersOf(polar.sweeps[0]);
  const std::vector<float> expected = {-32.0F, 0.0F, 94.5F, -62.0F, 2.0F, 191.0F};
  std::vector<float> values;
  for (const std::size_t gate : {2, 3, 4, 7, 8, 9})
  {
    values.push_back(sweep.values[gate]);
  }
  EXPECT_EQ(values, expected);
  EXPECT_EQ(sweep.states[6], GateState::RangeFolded);
}

// A word that leaves no room for its code, and words that fall where values rise.
TEST(PolarVolume, NoWordIsTakenForAnotherValue)
{
  static constexpr std::uint8_t extremes[] = {0, 0, 0, 1, 0, 2, 255, 255}; // 0, 1, 2, 65535
  for (const float scale : {500.0F, -500.0F})
  {
    Ray ray = MakeRay(0.0F, 4, 0);
    MomentRow& row = ray.Row(MomentName::ZDR);
    row = ray.Row(MomentName::REF);
    row.words = extremes;
    row.wordBits = 16;
    row.scale = scale;
    const PolarVolume polar = MakePolarVolume(MakeVolume({ray}), MomentName::ZDR);
    const NumberSweep sweep = NumbersOf(polar.sweeps[0]);
    EXPECT_EQ(sweep.states, (std::vector<GateState>{GateState::BelowThreshold,
                              GateState::RangeFolded, GateState::Valid, GateState::Valid}));
    EXPECT_NEAR(sweep.values[2], -64.0F / scale, 0.002F);
    EXPECT_NEAR(sweep.values[3], 65'469.0F / scale, 0.002F);
    EXPECT_GT(polar.sweeps[0].scale.step, 0.0F);
  }
}

TEST(PolarVolume, KeepsTheWordsOfRealFilesInLittleMemory)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  for (const char* file : {"legacy/KTLX19990503_235621.gz", "superres/KLOT20220317_000842_V06"})
  {
    const RadarVolume volume = ReadLevel2(data / "level2" / file);
    for (const MomentName moment : {MomentName::REF, MomentName::RHO})
    {
      const PolarVolume polar = MakePolarVolume(volume, moment);
      std::size_t gates = 0;
      auto sweep = polar.sweeps.begin();
      for (const Sweep& words : volume.sweeps)
      {
        if (words.Has(moment))
        {
          gates += sweep->gates * sweep->rays.size();
          ExpectWords(words, moment, *sweep++);
        }
      }
      EXPECT_EQ(sweep, polar.sweeps.end());
      // A byte for each gate would be seven times as much in the clear air of KLOT, twice in the
      // storms of KTLX.
      EXPECT_AT_MOST(MemoryOf(polar), gates / 2 + 100'000, "memory of a volume, bytes") << file;
    }
  }
}

TEST(PolarVolume, NoEchoBeyondTheUnambiguousRangeIsNotSampled)
{
  static constexpr std::uint8_t gates[] = {66, 0, 0, 0, 66}; // at 0 to 4 km
  Ray ray = MakeRay(10.0F, 5, 0);
  ray.Row(MomentName::REF).words = gates;
  ray.Row(MomentName::SW) = ray.Row(MomentName::REF);
  ray.unambiguousRange = 2'600.0F;
  RadarVolume volume = MakeVolume({ray});
  volume.sweeps[0].waveform = Waveform::ContiguousDoppler;
  EXPECT_EQ(NumbersOf(MakePolarVolume(volume, MomentName::REF).sweeps[0]).states,
    (std::vector<GateState>{GateState::Valid, GateState::BelowThreshold, GateState::BelowThreshold,
      GateState::NotSampled, GateState::Valid}));
  EXPECT_EQ(NumbersOf(MakePolarVolume(volume, MomentName::SW).sweeps[0]).states[3],
    GateState::BelowThreshold);
}

TEST(PolarVolume, PadsShorterRays)
{
  const PolarVolume polar =
    MakePolarVolume(MakeVolume({MakeRay(1.0F, 3, 0), MakeRay(2.0F, 5, 0)}), MomentName::REF);
  ASSERT_EQ(polar.sweeps.size(), 1U);
  const NumberSweep sweep = NumbersOf(polar.sweeps[0]);
  EXPECT_EQ(sweep.gates, 5U);
  EXPECT_EQ(sweep.states[sweep.Index(0, 2)], GateState::Valid);
  EXPECT_EQ(sweep.states[sweep.Index(0, 3)], GateState::NotSampled);
  EXPECT_EQ(sweep.values[sweep.Index(1, 4)], 94.5F);
}

TEST(PolarVolume, LeavesOutGatesBehindTheWantedRange)
{
  const RadarVolume volume = MakeVolume({MakeRay(1.0F, 5, 0), MakeRay(2.0F, 3, 0)});
  const PolarVolume whole = MakePolarVolume(volume, MomentName::REF);
  const double spacing = whole.sweeps[0].gateSpacing;
  for (const double range : {-1.0, 0.0, 1.0, 1.9, 3.0, 4.0, 9.0})
  {
    const PolarSweep part = MakePolarVolume(volume, MomentName::REF,
      [&](double elevation)
      {
        EXPECT_EQ(elevation, MedianElevation(whole.sweeps[0]));
        return range * spacing;
      }).sweeps[0];
    const auto gates = static_cast<std::size_t>(std::clamp(std::floor(range) + 1.0, 1.0, 5.0));
    ASSERT_EQ(part.gates, gates) << range;
    for (std::size_t ray = 0; ray < 2; ++ray)
    {
      std::vector<std::uint16_t> expected(gates);
      whole.sweeps[0].rows.Read(ray, gates, expected.data());
      std::vector<std::uint16_t> codes(gates);
      part.Read(ray, codes.data());
      EXPECT_EQ(codes, expected) << range << ", ray " << ray;
    }
  }
}

TEST(PolarVolume, SplitsSweepsOfTwoGateGeometries)
{
  const PolarVolume polar =
    MakePolarVolume(MakeVolume({MakeRay(1.0F, 5, 0), MakeRay(2.0F, 4, -375), MakeRay(3.0F, 5, 0)}),
      MomentName::REF);
  ASSERT_EQ(polar.sweeps.size(), 2U);
  EXPECT_EQ(polar.sweeps[0].rays.size(), 2U);
  EXPECT_EQ(polar.sweeps[0].rays[1].azimuth, 3.0F);
  EXPECT_EQ(polar.sweeps[1].firstGate, -375.0);
  EXPECT_EQ(polar.sweeps[1].gates, 4U);
}

TEST(PolarVolume, LeavesOutWhatLacksTheMoment)
{
  RadarVolume volume = MakeVolume({MakeRay(1.0F, 5, 0), MakeRay(2.0F, 0, 0)});
  EXPECT_EQ(MakePolarVolume(volume, MomentName::REF).sweeps[0].rays.size(), 1U);
  EXPECT_TRUE(MakePolarVolume(volume, MomentName::ZDR).sweeps.empty());
  // The volume's times are those of all its rays.
  EXPECT_EQ(MakePolarVolume(volume, MomentName::ZDR).end, Time(Duration(2000)));
  EXPECT_TRUE(MakePolarVolume(RadarVolume{}, MomentName::REF).sweeps.empty());
}
