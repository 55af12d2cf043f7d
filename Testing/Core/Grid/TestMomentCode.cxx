// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Grid/MomentCode.h"

#include "VolumeMaker.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace nexrad;

namespace
{

// A volume of one row with these echoes.
GriddedVolume VolumeOf(MomentName moment, const std::vector<float>& echoes)
{
  GriddedVolume volume =
    nexrad::testing::MakeGriddedVolume({static_cast<int>(echoes.size()), 1, 1});
  volume.moment = moment;
  volume.values = echoes;
  volume.states.assign(echoes.size(), VoxelState::Echo);
  return volume;
}

GriddedVolume RoundTrip(const GriddedVolume& volume)
{
  const MomentCode code = MomentCode::Of(volume);
  // Three at a time: the lower bytes end within a part.
  std::vector<std::uint8_t> codes(code.bytes * volume.values.size());
  for (std::size_t first = 0; first < codes.size(); first += 3)
  {
    code.WriteBytes(
      volume, first, std::min<std::size_t>(3, codes.size() - first), codes.data() + first);
  }
  GriddedVolume coded = volume;
  code.DecodeAll(codes, coded);
  return coded;
}

struct Words
{
  MomentName moment;
  unsigned first;
  unsigned last;
  double offset;
  double scale;
};

} // namespace

// Scales and offsets as the data blocks of real files have them; the first and last words of each
// by ICD 2620002, table XVII-I. ZDR has had two scales, VEL has one for whole m/s.
TEST(MomentCode, EveryWordOfARadarComesBack)
{
  const Words all[] = {{MomentName::REF, 2, 255, 66.0, 2.0}, {MomentName::VEL, 2, 255, 129.0, 2.0},
    {MomentName::VEL, 2, 255, 129.0, 1.0}, {MomentName::SW, 129, 255, 129.0, 2.0},
    {MomentName::ZDR, 2, 255, 128.0, 16.0}, {MomentName::ZDR, 2, 1058, 418.0, 32.0},
    {MomentName::PHI, 2, 1023, 2.0, 2.8361}, {MomentName::RHO, 2, 255, -60.5, 300.0},
    {MomentName::CFP, 8, 255, 8.0, 1.0}};
  for (const Words& words : all)
  {
    std::vector<float> values;
    for (unsigned word = words.first; word <= words.last; ++word)
    {
      values.push_back(static_cast<float>((word - words.offset) / words.scale));
    }
    const GriddedVolume read = RoundTrip(VolumeOf(words.moment, values));
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      ASSERT_EQ(read.states[i], VoxelState::Echo) << ToString(words.moment) << ' ' << values[i];
      ASSERT_NEAR(read.values[i], values[i], 1e-4) << ToString(words.moment);
    }
  }
}

TEST(MomentCode, ReflectivityIsHalfDecibelsInAByte)
{
  const GriddedVolume volume =
    VolumeOf(MomentName::REF, {-32.0F, -31.8F, -20.2F, 0.2F, 0.3F, 35.24F, 35.26F, 94.5F});
  EXPECT_EQ(MomentCode::Of(volume).bytes, 1U);
  EXPECT_EQ(RoundTrip(volume).values,
    (std::vector<float>{-32.0F, -32.0F, -20.0F, 0.0F, 0.5F, 35.0F, 35.5F, 94.5F}));
}

// What fades between two times may become weaker than a radar can say; it is still an echo.
TEST(MomentCode, AnEchoBeyondTheEndsStaysAnEcho)
{
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const GriddedVolume read =
    RoundTrip(VolumeOf(MomentName::REF, {-32.7F, -50.0F, -infinity, 95.0F, infinity}));
  EXPECT_EQ(read.values, (std::vector<float>{-32.0F, -32.0F, -32.0F, 94.5F, 94.5F}));
  EXPECT_EQ(read.states, std::vector<VoxelState>(5, VoxelState::Echo));
}

TEST(MomentCode, FastVelocitiesTakeTwoBytes)
{
  EXPECT_EQ(MomentCode::Of(VolumeOf(MomentName::VEL, {-63.5F, 63.0F})).bytes, 1U);
  const GriddedVolume fast = VolumeOf(MomentName::VEL, {-127.0F, -0.5F, 0.0F, 0.5F, 126.0F});
  EXPECT_EQ(MomentCode::Of(fast).bytes, 2U);
  EXPECT_EQ(RoundTrip(fast).values, fast.values);
}

TEST(MomentCode, StatesComeBackInOneByteAndInTwo)
{
  for (const MomentName moment : {MomentName::RHO, MomentName::PHI})
  {
    GriddedVolume volume = VolumeOf(moment, {0.5F, 0.5F, 0.5F, 0.5F, std::nanf("")});
    volume.states = {VoxelState::Echo, VoxelState::NoEcho, VoxelState::RangeFolded,
      VoxelState::NotScanned, VoxelState::Echo};
    const GriddedVolume read = RoundTrip(volume);
    EXPECT_EQ(read.states, (std::vector<VoxelState>{VoxelState::Echo, VoxelState::NoEcho,
                             VoxelState::NoEcho, VoxelState::NotScanned, VoxelState::NotScanned}))
      << ToString(moment);
    EXPECT_NEAR(read.values[0], 0.5F, 0.5 * MomentCode::Of(volume).scale);
    for (std::size_t i = 1; i < 5; ++i)
    {
      EXPECT_EQ(read.values[i], volume.fill) << i;
    }
  }
}

TEST(MomentCode, AVolumeWithoutItsVoxelsIsRefused)
{
  GriddedVolume volume = VolumeOf(MomentName::REF, {1.0F, 2.0F});
  volume.states.pop_back();
  EXPECT_THROW(CheckVoxelCount(volume), Error);
}
