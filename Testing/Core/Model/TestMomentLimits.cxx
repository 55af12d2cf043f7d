// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Model/MomentLimits.h"

#include <gtest/gtest.h>

using namespace nexrad;

namespace
{

using Gates = std::vector<std::size_t>;

// −63.5, −0.5, 0, 26.5, 27.5, 28 m/s, and the two codes.
constexpr std::uint8_t words[] = {2, 128, 129, 182, 184, 185, 0, 1};

MomentRow MakeRow(std::uint16_t gates = 8)
{
  MomentRow row;
  row.words = words;
  row.gates = gates;
  row.gateSpacing = 250;
  row.scale = 2.0F;
  row.offset = 129.0F;
  return row;
}

} // namespace

TEST(MomentLimits, WidthsBelowZeroCannotBe)
{
  Ray ray;
  ray.Row(MomentName::SW) = MakeRow();
  EXPECT_EQ(ImpossibleGates(ray, MomentName::SW), (Gates{0, 1}));
  EXPECT_EQ(ImpossibleGates(ray, MomentName::VEL), Gates{}) << "the ray has none";
  EXPECT_EQ(ImpossibleGates(ray, MomentName::REF), Gates{});
}

TEST(MomentLimits, VelocitiesBeyondTheNyquistVelocityCannotBe)
{
  Ray ray;
  ray.Row(MomentName::VEL) = MakeRow();
  EXPECT_EQ(ImpossibleGates(ray, MomentName::VEL), Gates{}) << "its Nyquist velocity is unknown";
  ray.nyquist = 26.5F;
  EXPECT_EQ(ImpossibleGates(ray, MomentName::VEL), (Gates{0, 5}));
  ray.nyquist = 64.0F;
  EXPECT_EQ(ImpossibleGates(ray, MomentName::VEL), Gates{});
}

// Both moments of a gate come from one estimate.
TEST(MomentLimits, AVelocityBesideAnImpossibleWidthCannotBe)
{
  Ray ray;
  ray.Row(MomentName::VEL) = MakeRow();
  ray.Row(MomentName::SW) = MakeRow();
  ray.nyquist = 26.5F;
  EXPECT_EQ(ImpossibleGates(ray, MomentName::VEL), (Gates{0, 1, 5}));
  ray.Row(MomentName::SW) = MakeRow(7);
  EXPECT_EQ(ImpossibleGates(ray, MomentName::VEL), (Gates{0, 5})) << "other gates";
}

TEST(MomentLimits, AllOfThemAreOneLine)
{
  Ray ray;
  EXPECT_EQ(DescribeImpossibleGates({{1, {ray}}}), "");
  ray.Row(MomentName::SW) = MakeRow();
  const std::string line = DescribeImpossibleGates({{1, {ray, ray}}, {2, {ray}}});
  EXPECT_EQ(line.rfind("6 gates have a spectrum width below 0 m/s, 0 a velocity", 0), 0U) << line;
}
