// SPDX-License-Identifier: BSD-3-Clause
// How well the merge by beams finds the synthetic storm again, beside the thesis's method: the
// table of Documentation/Developer/formulas.md, section E. The refraction of the simulated
// atmosphere varies; the merges know of 4/3 alone.
#include "Gridding/BeamMerge.h"
#include "ScannedDay.h"
#include "StormFeatures.h"

#include <gtest/gtest.h>

#include <cstdio>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

void PrintFeatures(const GriddedVolume& volume, const Truth& truth)
{
  const EchoTopScore tops = CompareEchoTops(volume, truth);
  const CoreScore cores = CompareCores(volume, truth);
  std::printf("         echo tops %+5.0f m, off by %4.0f m (%zu columns)  cores %zu of %zu, off by "
              "%4.0f m\n",
    tops.meanError, tops.meanAbsoluteError, tops.columns, cores.found, cores.cores,
    cores.meanDistance);
}

// Both methods against the truth; the beams' must be better by what is written at the asserts.
void Compare(const ScannedDay& day, const std::array<int, 3>& dimensions)
{
  const Truth truth = TruthOn(day, dimensions);
  const auto thesis = MergeThesis(day.Brackets(), truth.grid, day.At());
  BeamMerger merger(truth.grid);
  const auto beam = merger.Merge(day.Volumes(), day.At(), ThreadLoop(2));
  ASSERT_TRUE(thesis && beam);
  EXPECT_TRUE(beam->synthetic);
  const TruthScore before = CompareWithTruth(*thesis, truth.values, truth.counts);
  const TruthScore now = CompareWithTruth(*beam, truth.values, truth.counts);
  Print("thesis", truth, before);
  PrintFeatures(*thesis, truth);
  Print("beam", truth, now);
  PrintFeatures(*beam, truth);
  EXPECT_LT(now.rmse, 0.6 * before.rmse);
  EXPECT_LT(now.FalseFraction(), 0.25 * before.FalseFraction());
  EXPECT_LT(now.MissedFraction(), 0.02);
  EXPECT_LT(CompareEchoTops(*beam, truth).meanAbsoluteError,
    CompareEchoTops(*thesis, truth).meanAbsoluteError);
}

} // namespace

TEST(BeamAccuracy, At128)
{
  Compare(EveningDay(), {128, 128, 64});
}

TEST(BeamAccuracy, At256)
{
  Compare(EveningDay(), {256, 256, 128});
}

TEST(BeamAccuracy, UnderARefractionOf121)
{
  Compare(ScannedDay(Evening(), 1.21), {128, 128, 64});
}

TEST(BeamAccuracy, UnderARefractionOf15)
{
  Compare(ScannedDay(Evening(), 1.5), {128, 128, 64});
}
