// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/VolumeCache.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace
{

using namespace std::chrono_literals;
using nexrad::GriddedVolume;
using nexrad::VolumeCache;
using nexrad::VoxelBlock;
using nexrad::VoxelState;

const nexrad::Time start = *nexrad::ParseIso8601("2006-03-12T18:00:00Z");

/// A volume of 20 x 10 x 5 voxels: echo in every fifth row, else nothing.
GriddedVolume MakeVolume(nexrad::Time time, float first)
{
  GriddedVolume volume;
  volume.grid.dimensions = {20, 10, 5};
  volume.time = time;
  volume.method = "beam";
  volume.sites = {"KEAX", "KLSX"};
  volume.sitePositions = {{38.8, -94.3, 303.0}, {38.7, -90.7, 185.0}};
  volume.ofOneRadar = true;
  volume.synthetic = true;
  for (int i = 0; i < 1000; ++i)
  {
    const bool isEcho = i / 20 % 5 == 0;
    volume.values.push_back(isEcho ? first + static_cast<float>(i) : volume.fill);
    volume.states.push_back(isEcho ? VoxelState::Echo : VoxelState::NoEcho);
  }
  volume.values[7] = std::numeric_limits<float>::quiet_NaN();
  volume.values[8] = -0.0F;
  return volume;
}

template <class Value>
bool HasSameBits(const std::vector<Value>& a, const std::vector<Value>& b)
{
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

const VoxelBlock whole = VoxelBlock::Of(MakeVolume(start, 0.0F).grid);

TEST(VolumeCache, GivesVolumesBackBitByBit)
{
  GriddedVolume volume = MakeVolume(start, 3.0F);
  volume.ancillary.radars.assign(1000, 2);
  volume.further.push_back(MakeVolume(start, -5.0F));
  volume.further[0].moment = nexrad::MomentName::VEL;
  VolumeCache cache(1 << 20);
  cache.Keep(whole, volume);
  const auto found = cache.Find(whole, start);
  ASSERT_TRUE(found);
  EXPECT_TRUE(HasSameBits(found->values, volume.values));
  EXPECT_TRUE(HasSameBits(found->states, volume.states));
  EXPECT_TRUE(HasSameBits(found->ancillary.radars, volume.ancillary.radars));
  EXPECT_TRUE(found->ancillary.age.empty());
  ASSERT_EQ(found->further.size(), 1U);
  EXPECT_EQ(found->further[0].moment, nexrad::MomentName::VEL);
  EXPECT_TRUE(HasSameBits(found->further[0].values, volume.further[0].values));
  EXPECT_EQ(found->sites, volume.sites);
  ASSERT_EQ(found->sitePositions.size(), 2U);
  EXPECT_EQ(found->sitePositions[1].latitude, 38.7);
  EXPECT_TRUE(found->ofOneRadar);
  EXPECT_EQ(found->method, "beam");
  EXPECT_TRUE(found->synthetic);
  EXPECT_EQ(found->grid, volume.grid);
}

TEST(VolumeCache, TakesLittleMoreThanTheEcho)
{
  VolumeCache cache(1 << 20);
  cache.Keep(whole, MakeVolume(start, 3.0F));
  EXPECT_LT(cache.Used(), 200 * sizeof(float) + 10 * 40 + 100); // 200 voxels with echo in 10 rows
}

TEST(VolumeCache, KnowsTimesAndBlocksApart)
{
  VolumeCache cache(1 << 20);
  cache.Keep(whole, MakeVolume(start, 3.0F));
  EXPECT_FALSE(cache.Find(whole, start + 5min));
  VoxelBlock part = whole;
  part.end[0] = 10;
  EXPECT_FALSE(cache.Find(part, start));
  cache.Clear();
  EXPECT_FALSE(cache.Find(whole, start));
  EXPECT_EQ(cache.Used(), 0U);
}

TEST(VolumeCache, DropsWhatWasNotAskedForLongest)
{
  VolumeCache measuring(1 << 20);
  measuring.Keep(whole, MakeVolume(start, 0.0F));
  VolumeCache cache(2 * measuring.Used() + 20);
  cache.Keep(whole, MakeVolume(start, 0.0F));
  cache.Keep(whole, MakeVolume(start + 5min, 0.0F));
  EXPECT_TRUE(cache.Find(whole, start));
  cache.Keep(whole, MakeVolume(start + 10min, 0.0F));
  EXPECT_TRUE(cache.Find(whole, start));
  EXPECT_FALSE(cache.Find(whole, start + 5min));
  EXPECT_TRUE(cache.Find(whole, start + 10min));
  EXPECT_LE(cache.Used(), 2 * measuring.Used() + 20);
}

TEST(VolumeCache, KeepsNothingLargerThanItsLimit)
{
  for (const std::size_t limit : {std::size_t(0), std::size_t(100)})
  {
    VolumeCache cache(limit);
    cache.Keep(whole, MakeVolume(start, 0.0F));
    EXPECT_FALSE(cache.Find(whole, start));
    EXPECT_EQ(cache.Used(), 0U);
  }
}

} // namespace
