// SPDX-License-Identifier: BSD-3-Clause
// The integrals of pre-integrated classification (Formulas L1) beside those computed by hand.
#include "vtkTextureSliceTables.h"

#include "Tolerance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace
{

constexpr std::size_t Width = 1024;

/// Entries of one colour with those depths.
template <typename Depth>
std::vector<float> MakeEntries(Depth depth)
{
  std::vector<float> entries;
  for (std::size_t i = 0; i < Width; ++i)
  {
    const double scalar = double(i) / (Width - 1);
    entries.insert(entries.end(), {0.25f, 0.5f, float(scalar), float(depth(scalar))});
  }
  return entries;
}

std::vector<float> Integrate(const std::vector<float>& entries, double mostDepth = 1e6)
{
  std::vector<float> integrals(4 * vtkTextureSliceIntegralTable::ChooseWidth(Width));
  vtkTextureSliceIntegralTable::Integrate(entries.data(), Width, mostDepth, integrals.data());
  return integrals;
}

/// Mean of a channel between two entries of the functions, as the shader finds it.
double Mean(const std::vector<float>& integrals, std::size_t from, std::size_t to, std::size_t c)
{
  const std::size_t fine = (integrals.size() / 4 - 1) / (Width - 1);
  const double apart = double(fine * (to - from));
  return (double(integrals[4 * fine * to + c]) - double(integrals[4 * fine * from + c])) / apart;
}

} // namespace

TEST(IntegralTable, AConstantDepthIsItsOwnMean)
{
  const std::vector<float> integrals = Integrate(MakeEntries([](double) { return 0.3; }));
  for (const auto& [from, to] :
    {std::pair<std::size_t, std::size_t>(0, Width - 1), {17, 18}, {1000, 1001}, {200, 900}})
  {
    // Between neighbouring entries, 32 bits of a sum of at most 0.3 keep four digits.
    EXPECT_WITHIN(Mean(integrals, from, to, 3), 0.3, 3.5e-5, "mean of a constant depth of 0.3")
      << from << ' ' << to;
    EXPECT_WITHIN(Mean(integrals, from, to, 0), 0.3 * 0.25, 9e-6,
      "mean of a constant depth and colour of 0.075")
      << from << ' ' << to;
  }
}

TEST(IntegralTable, ARampHasTheMeanOfItsEnds)
{
  const std::vector<float> integrals = Integrate(MakeEntries([](double s) { return 2.0 * s; }));
  const double from = 200.0 / (Width - 1);
  const double to = 900.0 / (Width - 1);
  EXPECT_NEAR(Mean(integrals, 200, 900, 3), from + to, 1e-5);
  EXPECT_NEAR(Mean(integrals, 200, 900, 1), 0.5 * (from + to), 1e-5);
  // Blue is the scalar itself: the mean of 2 s * s.
  const double cubes = std::pow(to, 3.0) - std::pow(from, 3.0);
  EXPECT_NEAR(Mean(integrals, 200, 900, 2), 2.0 / 3.0 * cubes / (to - from), 1e-5);
}

// A spike of one entry is a triangle two entries wide at its foot, wherever the interval ends.
TEST(IntegralTable, ASpikeOfOneEntryIsNotLost)
{
  std::vector<float> entries = MakeEntries([](double) { return 0.0; });
  entries[4 * 500 + 3] = 8.0f;
  const std::vector<float> integrals = Integrate(entries);
  EXPECT_NEAR(Mean(integrals, 0, Width - 1, 3) * (Width - 1), 8.0, 1e-4);
  EXPECT_NEAR(Mean(integrals, 499, 501, 3), 4.0, 1e-4);
  EXPECT_EQ(Mean(integrals, 501, Width - 1, 3), 0.0);
}

// An opaque part does not cost the others their precision: a haze of one thousandth after a tenth
// of the table that is opaque.
TEST(IntegralTable, OpaquePartsAreLimited)
{
  const double most = vtkTextureSliceIntegralTable::ChooseMostDepth(0.25);
  EXPECT_EQ(most, 128.0);
  const std::vector<float> integrals =
    Integrate(MakeEntries([](double s) { return s < 0.1 ? 1048576.0 : 0.001; }), most);
  EXPECT_NEAR(Mean(integrals, 10, 20, 3), most, 0.01);
  EXPECT_WITHIN(Mean(integrals, 200, 300, 3), 0.001, 7e-6,
    "mean depth of a haze of 0.001 after an opaque part");
}

// The limit makes a slab opaque, is a power of two, and is never below what an opacity other than 1
// can have in 32 bits.
TEST(IntegralTable, TheLimitFollowsTheSlab)
{
  EXPECT_EQ(vtkTextureSliceIntegralTable::ChooseMostDepth(100.0), 32.0);
  EXPECT_EQ(vtkTextureSliceIntegralTable::ChooseMostDepth(1.0), 32.0);
  EXPECT_EQ(vtkTextureSliceIntegralTable::ChooseMostDepth(0.9), 64.0);
  EXPECT_EQ(vtkTextureSliceIntegralTable::ChooseMostDepth(0.0), 1048576.0);
}
