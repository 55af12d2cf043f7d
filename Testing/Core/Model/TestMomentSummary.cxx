// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/MomentSummary.h"

#include <gtest/gtest.h>

using namespace nexrad;

namespace
{

constexpr std::uint8_t sixWords[] = {0, 1, 2, 4, 0, 0};

Ray MakeRay(std::uint16_t gates, float scale, float offset)
{
  Ray ray;
  MomentRow& row = ray.Row(MomentName::REF);
  row.words = sixWords;
  row.gates = gates;
  row.firstGate = gates;
  row.gateSpacing = 250;
  row.scale = scale;
  row.offset = offset;
  return ray;
}

} // namespace

TEST(MomentSummary, CountsCodesAndValues)
{
  const MomentSummary summary = Summarize({1, {MakeRay(5, 2.0F, 2.0F)}}, MomentName::REF);
  EXPECT_EQ(summary.rays, 1U);
  EXPECT_EQ(summary.gates, 5U);
  EXPECT_EQ(summary.valid, 2U);
  EXPECT_EQ(summary.belowThreshold, 2U);
  EXPECT_EQ(summary.rangeFolded, 1U);
  EXPECT_EQ(summary.minimum, 0.0);
  EXPECT_EQ(summary.maximum, 1.0);
  EXPECT_EQ(summary.mean, 0.5);
}

// Two scales in one sweep: values 0 and 1, and -8 and -4. Rays differ in length; the first gate is
// that of the first ray.
TEST(MomentSummary, TakesEachRayWithItsOwnScale)
{
  const MomentSummary summary =
    Summarize({1, {MakeRay(5, 2.0F, 2.0F), MakeRay(6, 0.5F, 6.0F), Ray{}}}, MomentName::REF);
  EXPECT_EQ(summary.rays, 2U);
  EXPECT_EQ(summary.gates, 6U);
  EXPECT_EQ(summary.firstGate, 5);
  EXPECT_EQ(summary.valid, 4U);
  EXPECT_EQ(summary.belowThreshold, 5U);
  EXPECT_EQ(summary.minimum, -8.0);
  EXPECT_EQ(summary.maximum, 1.0);
  EXPECT_EQ(summary.mean, -2.75);
}

TEST(MomentSummary, IsZeroWithoutTheMoment)
{
  const MomentSummary summary = Summarize({1, {MakeRay(5, 2.0F, 2.0F)}}, MomentName::ZDR);
  EXPECT_EQ(summary.rays, 0U);
  EXPECT_EQ(summary.valid, 0U);
  EXPECT_EQ(summary.minimum, 0.0);
  EXPECT_EQ(summary.maximum, 0.0);
}
