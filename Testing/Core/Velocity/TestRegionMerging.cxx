// SPDX-License-Identifier: BSD-3-Clause
// Formulas V2: regions made by hand, and what their borders ask for.
#include "nexrad/Velocity/VelocityRegions.h"

#include <gtest/gtest.h>

using namespace nexrad;

namespace
{

RegionBorder Border(int a, int b, int fold, float weight)
{
  RegionBorder border;
  border.a = a;
  border.b = b;
  border.votes.Add(fold, weight);
  return border;
}

int Between(const RegionClusters& clusters, std::size_t a, std::size_t b)
{
  EXPECT_EQ(clusters.cluster[a], clusters.cluster[b]);
  return clusters.offset[b] - clusters.offset[a];
}

} // namespace

TEST(RegionMerging, AddsFoldsAlongAChain)
{
  const RegionClusters clusters = MergeRegions(
    {100, 50, 200, 80}, {Border(0, 1, 1, 40.0F), Border(1, 2, 1, 60.0F), Border(2, 3, -1, 30.0F)});
  ASSERT_EQ(clusters.size.size(), 1u);
  EXPECT_EQ(clusters.size[0], 430u);
  EXPECT_EQ(Between(clusters, 0, 1), 1);
  EXPECT_EQ(Between(clusters, 0, 2), 2);
  EXPECT_EQ(Between(clusters, 0, 3), 1);
}

// The border of 0 and 2 asks for no fold; those with 1 ask for two, and are the clearer ones.
TEST(RegionMerging, FollowsTheClearestBorders)
{
  const RegionClusters clusters = MergeRegions(
    {100, 100, 100}, {Border(0, 1, 1, 50.0F), Border(0, 2, 0, 10.0F), Border(1, 2, 1, 40.0F)});
  EXPECT_EQ(Between(clusters, 0, 2), 2);
}

// The border of 1 and 2 asks for no fold; with what that of 0 and 2 asks for, there is one.
TEST(RegionMerging, AddsTheBordersOfWhatItMerges)
{
  RegionBorder unclear = Border(1, 2, 0, 30.0F);
  unclear.votes.Add(1, 25.0F);
  const RegionClusters clusters =
    MergeRegions({100, 100, 400}, {Border(0, 1, 0, 50.0F), Border(0, 2, 1, 20.0F), unclear});
  EXPECT_EQ(Between(clusters, 0, 2), 1);
}

TEST(RegionMerging, KeepsApartWhatAShortBorderJoins)
{
  const RegionClusters clusters = MergeRegions({10'000, 20'000}, {Border(0, 1, 1, 4.0F)});
  EXPECT_EQ(clusters.size.size(), 2u);
  ASSERT_EQ(clusters.borders.size(), 1u);
  EXPECT_EQ(clusters.borders[0].votes.Best(), 1);
}

TEST(FoldVotes, TellHowClearTheyAre)
{
  FoldVotes votes;
  votes.Add(1, 3.0F);
  votes.Add(0, 1.0F);
  votes.Add(9, 5.0F); // no wind has as many folds
  EXPECT_EQ(votes.Best(), 1);
  EXPECT_EQ(votes.Total(), 4.0F);
  EXPECT_EQ(votes.Lead(), 2.0F);
  EXPECT_EQ(Turned(votes).Best(), -1);
  FoldVotes shifted;
  shifted.AddShifted(votes, 2, 0.5F);
  EXPECT_EQ(shifted.Of(3), 1.5F);
}
