// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Merging/KeptValues.h"

#include <gtest/gtest.h>

#include <string>

namespace nexrad
{
namespace
{

constexpr std::size_t bytes = 100;
constexpr std::size_t roomForTwo = 250;
using Kept = KeptValues<std::string, int>;

TEST(KeptValues, AreThoseAskedForLast)
{
  Kept kept(roomForTwo);
  kept.Keep("a", 1, bytes);
  kept.Keep("b", 2, bytes);
  EXPECT_EQ(kept.Find("a"), 1);
  kept.Keep("c", 3, bytes); // drops b
  EXPECT_EQ(kept.Find("a"), 1);
  EXPECT_EQ(kept.Find("b"), std::nullopt);
  EXPECT_EQ(kept.Find("c"), 3);
  EXPECT_EQ(kept.Used(), 2 * bytes);
  kept.Keep("large", 4, roomForTwo + 1);
  EXPECT_EQ(kept.Find("large"), std::nullopt);
  EXPECT_EQ(kept.Find("a"), 1);
}

TEST(KeptValues, OffersDropNothing)
{
  Kept kept(roomForTwo);
  kept.Offer("a", 1, bytes);
  kept.Offer("b", 2, bytes);
  kept.Offer("c", 3, bytes);
  EXPECT_EQ(kept.Find("a"), 1);
  EXPECT_EQ(kept.Find("c"), std::nullopt);
}

TEST(KeptValues, WithoutMemoryThereAreNone)
{
  Kept kept(0);
  kept.Offer("a", 1, bytes);
  kept.Keep("a", 1, bytes);
  EXPECT_EQ(kept.Find("a"), std::nullopt);
  EXPECT_EQ(kept.Used(), 0U);
}

} // namespace
} // namespace nexrad
