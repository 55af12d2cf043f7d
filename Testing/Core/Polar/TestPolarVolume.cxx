// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/PolarVolume.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace nexrad;

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
  const PolarSweep& sweep = polar.sweeps[0];
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
  const PolarSweep& sweep = polar.sweeps[0];
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
  EXPECT_EQ(polar.sweeps[0].firstGate, 2125.0);
  EXPECT_EQ(polar.sweeps[0].states[1], GateState::RangeFolded);
  EXPECT_EQ(polar.sweeps[0].values[2], 95.0F);
}

// Formulas G13: no echo beyond the unambiguous range is not scanned. Of Doppler moments the radar
// itself says where they end.
TEST(PolarVolume, NoEchoBeyondTheUnambiguousRangeIsNotSampled)
{
  static constexpr std::uint8_t gates[] = {66, 0, 0, 0, 66}; // at 0 to 4 km
  Ray ray = MakeRay(10.0F, 5, 0);
  ray.Row(MomentName::REF).words = gates;
  ray.Row(MomentName::SW) = ray.Row(MomentName::REF);
  ray.unambiguousRange = 2'600.0F;
  RadarVolume volume = MakeVolume({ray});
  volume.sweeps[0].waveform = Waveform::ContiguousDoppler;
  EXPECT_EQ(MakePolarVolume(volume, MomentName::REF).sweeps[0].states,
    (std::vector<GateState>{GateState::Valid, GateState::BelowThreshold, GateState::BelowThreshold,
      GateState::NotSampled, GateState::Valid}));
  EXPECT_EQ(MakePolarVolume(volume, MomentName::SW).sweeps[0].states[3], GateState::BelowThreshold);
}

TEST(PolarVolume, PadsShorterRays)
{
  const PolarVolume polar =
    MakePolarVolume(MakeVolume({MakeRay(1.0F, 3, 0), MakeRay(2.0F, 5, 0)}), MomentName::REF);
  ASSERT_EQ(polar.sweeps.size(), 1U);
  const PolarSweep& sweep = polar.sweeps[0];
  EXPECT_EQ(sweep.gates, 5U);
  EXPECT_EQ(sweep.states[sweep.Index(0, 2)], GateState::Valid);
  EXPECT_EQ(sweep.states[sweep.Index(0, 3)], GateState::NotSampled);
  EXPECT_TRUE(std::isnan(sweep.values[sweep.Index(0, 4)]));
  EXPECT_EQ(sweep.values[sweep.Index(1, 4)], 94.5F);
}

TEST(PolarVolume, SplitsSweepsOfTwoGateGeometries)
{
  const PolarVolume polar =
    MakePolarVolume(MakeVolume({MakeRay(1.0F, 5, 0), MakeRay(2.0F, 4, -375), MakeRay(3.0F, 5, 0)}),
      MomentName::REF);
  ASSERT_EQ(polar.sweeps.size(), 2U);
  EXPECT_EQ(polar.sweeps[0].rays.size(), 2U);
  EXPECT_EQ(polar.sweeps[0].rays[1].azimuth, 3.0);
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
