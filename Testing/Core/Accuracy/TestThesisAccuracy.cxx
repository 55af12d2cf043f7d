// SPDX-License-Identifier: BSD-3-Clause
// How well the thesis's method finds the synthetic storm again, and how large its volumes are on
// disk. Both are printed for comparison with the thesis and with later methods; the assertions only
// hold the method to what a sound geometry gives.
#include "Comparison/TruthComparison.h"
#include "ScannedDay.h"
#include "Tolerance.h"
#include "nexrad/Codec/ThesisStream.h"
#include "nexrad/Thesis/ThesisMerge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// What a sound geometry keeps.
constexpr double largestRmse = 10.0; // dBZ
constexpr double mostMissed = 0.045; // parts of the true echo
constexpr double mostFalse = 0.18;

bool IsSound(const TruthScore& score)
{
  return score.rmse <= largestRmse && score.MissedFraction() <= mostMissed &&
         score.FalseFraction() <= mostFalse;
}

class ThesisAccuracy : public ::testing::TestWithParam<std::array<int, 3>>
{
};

} // namespace

TEST_P(ThesisAccuracy, FindsTheStormAgain)
{
  const Truth truth = TruthOn(EveningDay(), GetParam());
  const auto volume = MergeThesis(EveningDay().Brackets(), truth.grid, Evening());
  ASSERT_TRUE(volume);
  EXPECT_TRUE(volume->synthetic);
  const TruthScore score = CompareWithTruth(*volume, truth.values, truth.counts);
  Print("thesis", truth, score);
  RecordProperty("rmse_dBZ", std::to_string(score.rmse));
  RecordProperty("missed_fraction", std::to_string(score.MissedFraction()));
  RecordProperty("false_fraction", std::to_string(score.FalseFraction()));
  EXPECT_AT_LEAST(static_cast<double>(score.trueEcho) / static_cast<double>(truth.values.size()),
    0.02, "share of true echo in the voxels");
  EXPECT_AT_MOST(score.rmse, largestRmse, "RMSE of the thesis's method, dBZ");
  EXPECT_AT_MOST(score.MissedFraction(), mostMissed,
    "missed echo of the thesis's method, part of the echo", "the bound is that of the finer grid");
  EXPECT_AT_MOST(
    score.FalseFraction(), mostFalse, "false echo of the thesis's method, part of the echo");
}

INSTANTIATE_TEST_SUITE_P(Grids, ThesisAccuracy,
  ::testing::Values(std::array<int, 3>{128, 128, 64}, std::array<int, 3>{256, 256, 128}),
  [](const auto& parameter) { return ToText(parameter.param); });

// The bounds are worth something: each of two plain mistakes breaks them.
TEST(ThesisAccuracyBounds, SeeAzimuthsThatTurnTheWrongWay)
{
  ScannedDay mirrored = EveningDay();
  const Truth truth = TruthOn(mirrored, {128, 128, 64});
  mirrored.ChangeRays([](PolarRay& ray) { ray.azimuth = 360.0 - ray.azimuth; });
  const auto volume = MergeThesis(mirrored.Brackets(), truth.grid, Evening());
  const TruthScore score = CompareWithTruth(*volume, truth.values, truth.counts);
  Print("mirrored", truth, score);
  EXPECT_FALSE(IsSound(score));
}

TEST(ThesisAccuracyBounds, SeeAzimuthsThatCountFromTheEast)
{
  ScannedDay turned = EveningDay();
  const Truth truth = TruthOn(turned, {128, 128, 64});
  turned.ChangeRays([](PolarRay& ray) { ray.azimuth += 90.0; });
  const auto volume = MergeThesis(turned.Brackets(), truth.grid, Evening());
  const TruthScore score = CompareWithTruth(*volume, truth.values, truth.counts);
  Print("turned", truth, score);
  EXPECT_FALSE(IsSound(score));
}

namespace
{

// A volume's codes; on demand as the thesis has them, which does not tell what was not scanned from
// what holds no echo.
std::vector<std::uint8_t> CodesOf(const GriddedVolume& volume, bool asTheThesis)
{
  std::vector<std::uint8_t> codes = ThesisCode::EncodeAll(volume);
  if (asTheThesis)
  {
    std::replace(codes.begin(), codes.end(), ThesisCode::NotScannedCode, ThesisCode::NoEchoCode);
  }
  return codes;
}

struct EncodedSizes
{
  std::size_t voxels = 0;
  std::size_t thesis = 0; // not scanned stored as no echo
  std::size_t states = 0;
};

EncodedSizes SizesOf(const GriddedVolume& volume)
{
  const auto codes = CodesOf(volume, false);
  return {
    codes.size(), EncodeRunLength(CodesOf(volume, true)).size(), EncodeRunLength(codes).size()};
}

} // namespace

// Bytes of a volume, beside table 4.4 of the thesis. Its day and ours differ.
TEST(ThesisVolumes, SizesBesideTable44)
{
  const std::map<std::array<int, 3>, const char*> table = {{{128, 128, 64}, "1M to 10.2K (99.1 %)"},
    {{256, 256, 128}, "8M to 54.0K (99.34 %)"}, {{512, 512, 256}, "64M to 308.4K (99.53 %)"}};
  std::printf("%-12s %9s %16s %12s   %s\n", "dimensions", "voxels", "as the thesis", "with states",
    "table 4.4");
  for (const auto& [dimensions, thesis] : table)
  {
    const GridSpecification grid = GridOf(EveningDay(), dimensions);
    const auto volume = MergeThesis(EveningDay().Brackets(), grid, Evening());
    ASSERT_TRUE(volume);
    const EncodedSizes sizes = SizesOf(*volume);
    const double saved =
      100.0 * (1.0 - static_cast<double>(sizes.thesis) / static_cast<double>(sizes.voxels));
    std::printf("%-12s %9zu %8zu (%.1f%%) %12zu   %s\n", ToText(dimensions).c_str(), sizes.voxels,
      sizes.thesis, saved, sizes.states, thesis);
    RecordProperty("bytes_" + ToText(dimensions), std::to_string(sizes.thesis));
    EXPECT_LE(sizes.thesis, sizes.states);
    EXPECT_AT_LEAST(saved, 50.0, "part of the bytes that run lengths save, %");
  }
}
