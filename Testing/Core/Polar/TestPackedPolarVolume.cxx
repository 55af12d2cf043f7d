// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/PackedPolarVolume.h"

#include "TestData.h"
#include "nexrad/Level2/Level2File.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

constexpr float none = std::numeric_limits<float>::quiet_NaN();

// A volume of one sweep with these gates on each of its rays.
PolarVolume OneSweep(
  std::size_t rays, const std::vector<float>& values, const std::vector<GateState>& states)
{
  PolarVolume volume;
  volume.site = {"KEAX", Position{38.81, -94.264, 333.0}};
  volume.moment = MomentName::ZDR;
  volume.start = *ParseIso8601("2006-03-12T18:00Z");
  volume.end = volume.start + std::chrono::minutes(5);
  volume.synthetic = true;
  PolarSweep& sweep = volume.sweeps.emplace_back();
  sweep.elevationNumber = 7;
  sweep.waveform = Waveform::Batch;
  sweep.firstGate = -375.0;
  sweep.gateSpacing = 250.0;
  sweep.gates = values.size();
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    sweep.rays.push_back({static_cast<double>(ray), 0.5, volume.start, 148'000.0});
    sweep.values.insert(sweep.values.end(), values.begin(), values.end());
    sweep.states.insert(sweep.states.end(), states.begin(), states.end());
  }
  return volume;
}

void ExpectSame(const PolarVolume& one, const PolarVolume& other)
{
  EXPECT_EQ(one.site.name, other.site.name);
  EXPECT_EQ(one.moment, other.moment);
  EXPECT_EQ(one.start, other.start);
  EXPECT_EQ(one.end, other.end);
  EXPECT_EQ(one.synthetic, other.synthetic);
  ASSERT_EQ(one.sweeps.size(), other.sweeps.size());
  for (std::size_t index = 0; index < one.sweeps.size(); ++index)
  {
    const PolarSweep& a = one.sweeps[index];
    const PolarSweep& b = other.sweeps[index];
    EXPECT_EQ(a.elevationNumber, b.elevationNumber);
    EXPECT_EQ(a.waveform, b.waveform);
    EXPECT_EQ(a.firstGate, b.firstGate);
    EXPECT_EQ(a.gateSpacing, b.gateSpacing);
    EXPECT_EQ(a.gates, b.gates);
    EXPECT_EQ(a.rays.size(), b.rays.size());
    EXPECT_EQ(a.states, b.states);
    ASSERT_EQ(a.values.size(), b.values.size());
    // Bit by bit: NaN is not equal to itself.
    EXPECT_TRUE(std::equal(a.values.begin(), a.values.end(), b.values.begin(),
      [](const float& x, const float& y) { return std::memcmp(&x, &y, sizeof x) == 0; }));
  }
}

} // namespace

TEST(PackedPolarVolume, KeepsEveryStateAndValue)
{
  const PolarVolume volume = OneSweep(3, {none, 12.5F, none, none, -0.0F, 0.0F, 1e-30F},
    {GateState::BelowThreshold, GateState::Valid, GateState::RangeFolded, GateState::NotSampled,
      GateState::Valid, GateState::Valid, GateState::Valid});
  ExpectSame(PackedPolarVolume(volume).Unpack(), volume);
}

TEST(PackedPolarVolume, RunsAndLiteralsOfEveryLength)
{
  std::minstd_rand random(5);
  for (std::size_t length = 1; length < 300; ++length)
  {
    // A run, then as many values that differ from their neighbours, then a run.
    std::vector<float> values(length, 20.0F);
    for (std::size_t index = 0; index < length; ++index)
    {
      values.push_back(static_cast<float>(index % 2 * 100 + random() % 50));
    }
    values.insert(values.end(), length, 30.0F);
    const PolarVolume volume =
      OneSweep(1, values, std::vector<GateState>(values.size(), GateState::Valid));
    ExpectSame(PackedPolarVolume(volume).Unpack(), volume);
  }
}

TEST(PackedPolarVolume, TooManyValuesForCodesAreKeptAsTheyAre)
{
  for (const std::size_t count : {252, 253, 5000})
  {
    std::vector<float> values;
    for (std::size_t index = 0; index < count; ++index)
    {
      values.push_back(static_cast<float>(index) * 0.25F);
    }
    const PolarVolume volume = OneSweep(4, values, std::vector<GateState>(count, GateState::Valid));
    const PackedPolarVolume packed(volume);
    ExpectSame(packed.Unpack(), volume);
    EXPECT_EQ(packed.Bytes() < MemoryOf(volume), count == 252) << count;
  }
}

TEST(PackedPolarVolume, NoGatesAtAll)
{
  ExpectSame(PackedPolarVolume(OneSweep(0, {}, {})).Unpack(), OneSweep(0, {}, {}));
  EXPECT_TRUE(PackedPolarVolume(PolarVolume()).Unpack().sweeps.empty());
}

TEST(PackedPolarVolume, RealVolumesAreSmallAndExact)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto level2 = data / "level2";
  for (const auto& path :
    {level2 / "legacy" / "KTLX19990503_235621.gz", level2 / "superres" / "KLOT20220317_000842_V06"})
  {
    for (const MomentName moment : {MomentName::REF, MomentName::PHI})
    {
      const PolarVolume volume = MakePolarVolume(ReadLevel2(path), moment);
      const PackedPolarVolume packed(volume);
      ExpectSame(packed.Unpack(), volume);
      if (moment == MomentName::REF)
      {
        EXPECT_LT(packed.Bytes() * 5, MemoryOf(volume)) << path;
      }
    }
  }
}
