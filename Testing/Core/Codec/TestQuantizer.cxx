// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Codec/Quantizer.h"

#include "VolumeMaker.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace nexrad;
using Bytes = std::vector<std::uint8_t>;

TEST(Quantizer, DefaultIsTheWholeDecibel)
{
  const Quantizer quantizer;
  const auto code = [&quantizer](float value)
  { return static_cast<int>(quantizer.Encode(value, VoxelState::Echo)); };
  EXPECT_EQ(code(35.0F), 35);
  EXPECT_EQ(code(35.49F), 35);
  EXPECT_EQ(code(35.5F), 36);
  EXPECT_EQ(code(80.0F), 80);
  EXPECT_EQ(code(94.5F), 80) << "0 to 80 dBZ";
  EXPECT_EQ(code(0.4F), 0);
  EXPECT_EQ(code(-20.0F), 0) << "an echo at or below 0 dBZ is no echo";
}

TEST(Quantizer, StatesHaveCodes)
{
  const Quantizer quantizer;
  EXPECT_EQ(quantizer.Encode(50.0F, VoxelState::NoEcho), 0);
  EXPECT_EQ(quantizer.Encode(50.0F, VoxelState::RangeFolded), 0);
  EXPECT_EQ(quantizer.Encode(50.0F, VoxelState::NotScanned), 127);
  EXPECT_EQ(Quantizer::StateOf(0), VoxelState::NoEcho);
  EXPECT_EQ(Quantizer::StateOf(1), VoxelState::Echo);
  EXPECT_EQ(Quantizer::StateOf(126), VoxelState::Echo);
  EXPECT_EQ(Quantizer::StateOf(127), VoxelState::NotScanned);
}

TEST(Quantizer, FinerCodesEndAt126)
{
  const Quantizer quantizer{-10.0, 0.5, 80.0};
  EXPECT_EQ(quantizer.Encode(20.2F, VoxelState::Echo), 60);
  EXPECT_FLOAT_EQ(quantizer.ValueOf(60), 20.0F);
  EXPECT_EQ(quantizer.Encode(70.0F, VoxelState::Echo), 126);
}

TEST(Quantizer, NumbersThatAreNoneDoNoHarm)
{
  const Quantizer quantizer;
  constexpr float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(quantizer.Encode(std::nanf(""), VoxelState::Echo), 127);
  EXPECT_EQ(quantizer.Encode(infinity, VoxelState::Echo), 80);
  EXPECT_EQ(quantizer.Encode(-infinity, VoxelState::Echo), 0);
}

TEST(Quantizer, RefusesWhatCannotBeUsed)
{
  const GriddedVolume volume = nexrad::testing::MakeGriddedVolume();
  EXPECT_THROW((Quantizer{0.0, 0.0}.EncodeAll(volume)), Error);
  EXPECT_THROW((Quantizer{0.0, -1.0}.EncodeAll(volume)), Error);
  EXPECT_THROW((Quantizer{std::nan(""), 1.0}.EncodeAll(volume)), Error);
  GriddedVolume shorter = volume;
  shorter.states.pop_back();
  EXPECT_THROW(Quantizer{}.EncodeAll(shorter), Error);
}

TEST(Quantizer, AllVoxelsAreRoundedAsEachIs)
{
  GriddedVolume volume = nexrad::testing::MakeGriddedVolume();
  volume.grid.dimensions = {97, 11, 3};
  volume.values.clear();
  volume.states.clear();
  std::mt19937 random(11);
  Bytes expected;
  while (expected.size() < volume.grid.VoxelCount())
  {
    // Sixteenths, so that halves are met exactly.
    const float value = static_cast<float>(random() % 1'600) / 16.0F - 5.0F;
    const auto state = static_cast<VoxelState>(random() % 4);
    volume.values.push_back(value);
    volume.states.push_back(state);
    const float rounded = std::clamp(std::round(value), 0.0F, 80.0F);
    expected.push_back(state == VoxelState::Echo         ? static_cast<std::uint8_t>(rounded)
                       : state == VoxelState::NotScanned ? Quantizer::NotScannedCode
                                                         : Quantizer::NoEchoCode);
  }
  EXPECT_EQ(Quantizer().EncodeAll(volume), expected);
}
