// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/PolarCache.h"

#include "HandMadeVolume.h"
#include "Scans/RadarsOfMissouri.h"

#include <gtest/gtest.h>

namespace nexrad
{
namespace
{

using testing::keax;

PolarCache::Volume Volume()
{
  const auto decoded = testing::MakeRadarVolume(testing::ConstantVolume(keax, Time(), 10.0));
  return std::make_shared<const PolarVolume>(MakePolarVolume(decoded, MomentName::REF));
}

SeriesVolume Key(const char* file, std::size_t cycle = 0)
{
  SeriesVolume key;
  key.file = file;
  key.cycle = cycle;
  return key;
}

// Room for two volumes.
std::size_t RoomForTwo(PolarCache& probe)
{
  probe.Keep(Key("probe"), Volume());
  return 2 * probe.Used() + probe.Used() / 2;
}

TEST(PolarCache, KeepsTheVolumesAskedForLast)
{
  PolarCache probe(std::size_t(1) << 30);
  const std::size_t limit = RoomForTwo(probe);
  PolarCache cache(limit);
  const auto first = Volume();
  cache.Keep(Key("a"), first);
  cache.Keep(Key("a", 1), Volume());
  EXPECT_EQ(cache.Find(Key("a"), MomentName::REF), first);
  cache.Keep(Key("b"), Volume()); // drops the second cycle of a
  EXPECT_EQ(cache.Find(Key("a"), MomentName::REF), first);
  EXPECT_EQ(cache.Find(Key("a", 1), MomentName::REF), nullptr);
  EXPECT_NE(cache.Find(Key("b"), MomentName::REF), nullptr);
  EXPECT_LE(cache.Used(), limit);
}

TEST(PolarCache, OffersDropNothing)
{
  PolarCache probe(std::size_t(1) << 30);
  PolarCache cache(RoomForTwo(probe));
  EXPECT_TRUE(cache.Offer(Key("a"), Volume()));
  EXPECT_TRUE(cache.Offer(Key("b"), Volume()));
  EXPECT_FALSE(cache.Offer(Key("c"), Volume()));
  EXPECT_NE(cache.Find(Key("a"), MomentName::REF), nullptr);
  EXPECT_EQ(cache.Find(Key("c"), MomentName::REF), nullptr);
}

TEST(PolarCache, WithoutMemoryKeepsNothing)
{
  PolarCache cache(0);
  EXPECT_FALSE(cache.Offer(Key("a"), Volume()));
  cache.Keep(Key("a"), Volume());
  EXPECT_EQ(cache.Find(Key("a"), MomentName::REF), nullptr);
  EXPECT_EQ(cache.Used(), 0U);
}

} // namespace
} // namespace nexrad
