// SPDX-License-Identifier: BSD-3-Clause
// Ground that is looked for about gates that stand still, and ground that is looked for everywhere.
#include "TestData.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Quality/GroundTest.h"
#include "nexrad/Quality/SplitCuts.h"
#include "nexrad/System/RangeLoop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace nexrad;
using namespace nexrad::testing;

namespace
{

// The sweeps of the reflectivity of a volume, each with the next one as the tilt above it, ground
// found by `judge`.
template <typename Judge>
std::vector<SweepJudgement> FindGroundIn(const MeasuredMoments& moments, const Judge& judge)
{
  std::vector<SweepSources> sources = FindSources(moments);
  std::vector<SweepJudgement> sweeps(sources.size());
  for (std::size_t i = 0; i < sweeps.size(); ++i)
  {
    sources[i].surveillance.reset(); // so that Doppler halves are judged, too
    sweeps[i].Set(moments.reflectivity.sweeps[i], sources[i]);
  }
  for (std::size_t i = 0; i < sweeps.size(); ++i)
  {
    sweeps[i].above = i + 1 < sweeps.size() ? sweeps[i + 1].grid.get() : nullptr;
    judge(sweeps[i], sources[i]);
    FindGround(sweeps[i]);
  }
  return sweeps;
}

void JudgeAll(SweepJudgement& sweep, const SweepSources& sources)
{
  const std::vector<GateRange> wanted(sweep.grid->Rays(), GateRange{0, sweep.judged});
  RowJudge judge(sweep, sources, wanted);
  for (std::size_t place = 0; place < sweep.grid->Rays(); ++place)
  {
    judge.Judge(place);
  }
}

class GroundSearches : public ::testing::TestWithParam<const char*>
{
};

} // namespace

TEST_P(GroundSearches, FindWhatJudgingAllGatesFinds)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const RadarVolume volume = ReadLevel2(data / "level2" / "legacy" / GetParam());
  const PolarVolume reflectivity = MakePolarVolume(volume, MomentName::REF);
  const MeasuredMoments moments(
    reflectivity,
    [&volume](MomentName moment, const WantedRange& wanted)
    { return MakePolarVolume(volume, moment, wanted); },
    [](double) { return 1.0e6; }, ThreadLoop(1));
  const auto expected = FindGroundIn(moments, JudgeAll);
  const auto found = FindGroundIn(moments, SearchGround);
  std::size_t ground = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_TRUE(found[i].reasons == expected[i].reasons) << "sweep " << i;
    ground +=
      static_cast<std::size_t>(std::count_if(expected[i].reasons.begin(), expected[i].reasons.end(),
        [](EchoReason reason) { return ClassOf(reason) == EchoClass::Ground; }));
  }
  EXPECT_GE(ground, 100U);
}

INSTANTIATE_TEST_SUITE_P(Files, GroundSearches,
  ::testing::Values("KLOT19950413_132143.gz", "KTLX19910605_162126.gz", "KTLX19990503_235621.gz",
    "KVWX_20050626_221551.gz"));
