// SPDX-License-Identifier: BSD-3-Clause
// Rays that come twice, late, from another radar or of another time, in small synthetic volumes.
#include "nexrad/Level2/Level2File.h"

#include "FileParts.h"
#include "Level2Bytes.h"
#include "Remarks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

constexpr std::uint32_t rayStep = 100; // ms
constexpr unsigned raysInCut = 12;

// A volume of several cuts of twelve rays each, a second apart.
std::vector<RayPlan> PlanVolume(unsigned cuts, std::uint32_t start = 9'799'000)
{
  std::vector<RayPlan> plans;
  for (unsigned cut = 1; cut <= cuts; ++cut)
  {
    for (unsigned number = 1; number <= raysInCut; ++number)
    {
      RayPlan& plan = plans.emplace_back();
      plan.cut = cut;
      plan.number = number;
      plan.azimuth = 30.0 * number - 15.0;
      plan.elevation = 0.5 * cut;
      plan.milliseconds = start + static_cast<std::uint32_t>(plans.size()) * rayStep;
      plan.status = 1;
    }
    plans[plans.size() - raysInCut].status = cut == 1 ? 3 : 0;
    plans.back().status = cut == cuts ? 4 : 2;
  }
  return plans;
}

Bytes Encode(const std::vector<RayPlan>& plans, unsigned messageType = 31,
  const Bytes& metadata = MakeMessage5(21, {0.5, 1.0, 1.5, 2.0}))
{
  std::vector<Bytes> parts = {MakeVolumeHeader(), metadata};
  for (const RayPlan& plan : plans)
  {
    parts.push_back(messageType == 1 ? MakeMessage1(plan) : MakeMessage31(plan));
  }
  return Join(parts);
}

RadarVolume Decode(const std::vector<RayPlan>& plans, unsigned messageType = 31)
{
  return DecodeLevel2(Encode(plans, messageType), "file");
}

void ChangeCut(
  std::vector<RayPlan>& plans, unsigned cut, const std::function<void(RayPlan&)>& change)
{
  for (RayPlan& plan : plans)
  {
    if (plan.cut == cut)
    {
      change(plan);
    }
  }
}

} // namespace

TEST(RayIdentity, ASpoiltOrderGivesTheSameRaysAtEveryPlace)
{
  for (const unsigned type : {1U, 31U})
  {
    const Bytes whole = Encode(PlanVolume(4), type);
    const RadarVolume clean = DecodeLevel2(whole, "file");
    EXPECT_TRUE(clean.damage.empty()) << DamageOf(clean);
    std::vector<RayPlan> others = PlanVolume(4, 20'000'000);
    for (RayPlan& plan : others)
    {
      plan.site = "KVBX";
      plan.latitude = 34.838F;
    }
    const Bytes foreign = Encode(others, type);
    for (const std::size_t messages : {1U, 5U, 12U})
    {
      const FileParts file = CutFile(whole, messages);
      const FileParts other = CutFile(foreign, messages);
      for (std::size_t place = 0; place < file.parts.size(); ++place)
      {
        const std::size_t last = other.parts.size() - 1;
        for (const ChangedFile& changed :
          ChangeAt(file, place, other.parts[std::max<std::size_t>(std::min(place, last), 1)]))
        {
          const RadarVolume volume = DecodeLevel2(changed.bytes, "file");
          EXPECT_EQ(DifferenceOf(volume, clean), "")
            << "message " << type << ", " << messages << " in a part: " << changed.what;
        }
      }
    }
  }
}

TEST(RayIdentity, RepeatedRaysCountOnceAndAreCounted)
{
  std::vector<RayPlan> plans = PlanVolume(3);
  plans.insert(plans.begin() + 20, plans.begin() + 14, plans.begin() + 20);
  plans.insert(plans.end(), plans.begin(), plans.begin() + 3);
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(volume.RayCount(), 36U);
  EXPECT_EQ(volume.sweeps.size(), 3U);
  EXPECT_TRUE(volume.complete);
  EXPECT_TRUE(volume.damage.empty()) << DamageOf(volume);
  EXPECT_TRUE(Has(NotesOf(volume), "9 rays come more than once")) << NotesOf(volume);
}

// Of two copies the one that lost a moment goes.
TEST(RayIdentity, TheBetterOfTwoCopiesStays)
{
  std::vector<RayPlan> plans = PlanVolume(2);
  plans.insert(plans.begin() + 5, plans[5]);
  plans[5].moments[0].words = {0, 1};
  plans[5].moments[0].gates = 2;
  const RadarVolume volume = Decode(plans);
  ASSERT_EQ(volume.sweeps.at(0).rays.size(), raysInCut);
  EXPECT_EQ(volume.sweeps[0].rays[5].Row(MomentName::REF).gates, 5U);
}

TEST(RayIdentity, ALateRecordIsCountedAndSplitsNothing)
{
  std::vector<RayPlan> plans = PlanVolume(3);
  std::rotate(plans.begin() + 4, plans.begin() + 9, plans.begin() + 30);
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(volume.sweeps.size(), 3U);
  EXPECT_TRUE(volume.damage.empty()) << DamageOf(volume);
  EXPECT_TRUE(Has(NotesOf(volume), "5 rays are out of order")) << NotesOf(volume);
}

TEST(RayIdentity, RaysOfAnotherRadarAreOneLineOfDamage)
{
  std::vector<RayPlan> plans = PlanVolume(3);
  std::vector<RayPlan> others = PlanVolume(2);
  for (RayPlan& plan : others)
  {
    plan.site = "KVBX";
    plan.latitude = 34.838F;
    plan.longitude = -120.397F;
  }
  plans.insert(plans.begin() + 17, others.begin() + 3, others.begin() + 15);
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(DifferenceOf(volume, Decode(PlanVolume(3))), "");
  ASSERT_EQ(volume.damage.size(), 1U) << DamageOf(volume);
  EXPECT_TRUE(
    Has(volume.damage[0].what, "12 of 48 rays are not of the radar of the file (KTLX at 35.330"))
    << volume.damage[0].what;
  EXPECT_TRUE(Has(volume.damage[0].what, "KVBX at 34.838, -120.397 degrees): left out"));
}

// The first record of the file may be the wrong one.
TEST(RayIdentity, TheHeaderDecidesWhereTheRadarsHaveAsManyRays)
{
  std::vector<RayPlan> plans = PlanVolume(2);
  std::vector<RayPlan> others = PlanVolume(2);
  for (RayPlan& plan : others)
  {
    plan.site = "KVBX";
    plan.latitude = 34.838F;
  }
  plans.insert(plans.begin(), others.begin(), others.end());
  plans.resize(plans.size() - 3);
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(volume.site.name, "KTLX");
  EXPECT_EQ(volume.RayCount(), 21U);
}

TEST(RayIdentity, AWrongBitInANameOrPositionLosesNoRay)
{
  for (const std::size_t wrong : {0U, 5U, 12U, 35U})
  {
    std::vector<RayPlan> plans = PlanVolume(3);
    plans[wrong].site = "KTLY";
    EXPECT_EQ(Decode(plans).RayCount(), 36U) << wrong;
    EXPECT_TRUE(Has(DamageOf(Decode(plans)), "1 of 36 rays state another name")) << wrong;
    plans[wrong].site = "KTLX";
    plans[wrong].latitude = 51.33F;
    EXPECT_EQ(Decode(plans).RayCount(), 36U) << wrong;
    EXPECT_TRUE(Has(DamageOf(Decode(plans)), "1 of 36 rays state another position")) << wrong;
  }
}

// The same name, elsewhere and at another time of the day.
TEST(RayIdentity, ARecordOfANamesakeIsLeftOut)
{
  std::vector<RayPlan> plans = PlanVolume(3);
  std::vector<RayPlan> others = PlanVolume(3, 9'900'000);
  for (RayPlan& plan : others)
  {
    plan.latitude = 36.5F;
  }
  plans.insert(plans.begin() + 20, others.begin() + 4, others.begin() + 16);
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(DifferenceOf(volume, Decode(PlanVolume(3))), "");
  EXPECT_TRUE(Has(DamageOf(volume), "12 of 48 rays are not of the radar of the file"));
}

TEST(RayIdentity, RaysOfAnotherYearAreOneLineOfDamage)
{
  std::vector<RayPlan> plans = PlanVolume(4);
  std::vector<RayPlan> others = PlanVolume(4, 30'000'000);
  for (RayPlan& plan : others)
  {
    plan.day -= 700;
  }
  plans.insert(plans.begin() + 20, others.begin() + 24, others.begin() + 36);
  for (const unsigned type : {1U, 31U})
  {
    const RadarVolume volume = Decode(plans, type);
    EXPECT_EQ(DifferenceOf(volume, Decode(PlanVolume(4), type)), "");
    ASSERT_EQ(volume.damage.size(), 1U) << DamageOf(volume);
    EXPECT_TRUE(Has(volume.damage[0].what, "12 rays of 2003-09-21T08:20:02.500Z"))
      << DamageOf(volume);
    EXPECT_TRUE(Has(volume.damage[0].what, "left out")) << DamageOf(volume);
  }
}

TEST(RayIdentity, TheHeadersTimeDecidesAgainstMoreRaysOfAnotherYear)
{
  std::vector<RayPlan> plans = PlanVolume(2);
  std::vector<RayPlan> others = PlanVolume(4, 30'000'000);
  for (RayPlan& plan : others)
  {
    plan.day -= 700;
  }
  plans.insert(plans.begin() + 20, others.begin(), others.end());
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(volume.RayCount(), 24U);
  EXPECT_EQ(volume.sweeps.size(), 2U);
  EXPECT_TRUE(Has(DamageOf(volume), "48 rays of 2003")) << DamageOf(volume);
}

TEST(RayIdentity, ADateThatStaysAtMidnightGoesOn)
{
  // Cut 2 is behind midnight.
  std::vector<RayPlan> plans = PlanVolume(4, 86'400'000 - 13 * rayStep);
  for (RayPlan& plan : plans)
  {
    plan.milliseconds %= 86'400'000;
  }
  std::vector<RayPlan> right = plans;
  for (RayPlan& plan : right)
  {
    plan.day += plan.milliseconds < 40'000'000 ? 1 : 0;
  }
  ASSERT_NE(right.back().day, right.front().day);
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(DifferenceOf(volume, Decode(right)), "");
  EXPECT_TRUE(volume.damage.empty()) << DamageOf(volume);
  EXPECT_TRUE(Has(NotesOf(volume), "36 rays get the date of the next day")) << NotesOf(volume);
  EXPECT_GT(*volume.End(), *volume.Start());
}

TEST(RayIdentity, AWrongTimeOfDayMovesNoRay)
{
  for (const std::size_t wrong : {5U, 12U, 23U, 30U})
  {
    for (const int error : {-900'000, -3'000, 2'000, 900'000})
    {
      std::vector<RayPlan> plans = PlanVolume(3);
      plans[wrong].milliseconds =
        static_cast<std::uint32_t>(int(plans[wrong].milliseconds) + error);
      const RadarVolume volume = Decode(plans);
      ASSERT_EQ(volume.sweeps.size(), 3U) << wrong << ' ' << error;
      for (std::size_t i = 0; i < 36; ++i)
      {
        EXPECT_EQ(volume.sweeps[i / raysInCut].rays[i % raysInCut].azimuth,
          static_cast<float>(plans[i].azimuth));
      }
    }
  }
}

TEST(RayIdentity, AClockThatGoesBackChangesNoOrder)
{
  for (const std::size_t place : {7U, 24U, 31U})
  {
    std::vector<RayPlan> plans = PlanVolume(3);
    for (std::size_t i = place; i < plans.size(); ++i)
    {
      plans[i].milliseconds -= 600'000;
    }
    const RadarVolume volume = Decode(plans);
    EXPECT_EQ(volume.sweeps.size(), 3U);
    EXPECT_EQ(volume.RayCount(), 36U);
    EXPECT_GE(*volume.End(), *volume.Start());
    EXPECT_LT(*volume.End() - *volume.Start(), 10s);
    EXPECT_TRUE(Has(DamageOf(volume), "the clock goes back by 599900 ms")) << DamageOf(volume);
  }
}

// Message 1 has no name; an antenna is in one cut at a time.
TEST(RayIdentity, RaysOfTwoCutsAtOneTime)
{
  std::vector<RayPlan> plans = PlanVolume(16);
  std::vector<RayPlan> others = PlanVolume(16);
  ChangeCut(others, 9, [](RayPlan& plan) { plan.milliseconds -= 6 * 12 * rayStep + 37; });
  plans.insert(plans.begin() + 30, others.begin() + 8 * 12, others.begin() + 8 * 12 + 10);
  const RadarVolume volume = Decode(plans, 1);
  EXPECT_EQ(DifferenceOf(volume, Decode(PlanVolume(16), 1)), "");
  EXPECT_TRUE(Has(DamageOf(volume), "10 rays at the time of another cut")) << DamageOf(volume);
}

// Neither the order in the file nor the times can be trusted where all cuts have the same times.
TEST(RayIdentity, CutsOfOneTimeKeepTheirOrder)
{
  std::vector<RayPlan> plans = PlanVolume(3);
  for (std::size_t i = 0; i < plans.size(); ++i)
  {
    plans[i].milliseconds = plans[i % raysInCut].milliseconds;
  }
  const RadarVolume volume = Decode(plans);
  EXPECT_EQ(volume.sweeps.size(), 3U);
  EXPECT_EQ(volume.RayCount(), 36U);
}

// The cut is scanned again; its first rays are lost.
TEST(RayIdentity, ACutThatStartsAgainIsAnotherSweep)
{
  std::vector<RayPlan> plans = PlanVolume(2);
  std::vector<RayPlan> again = PlanVolume(2, 9'800'000 + 8 * rayStep);
  plans.resize(8);
  plans.insert(plans.end(), again.begin() + 3, again.end());
  const RadarVolume volume = Decode(plans);
  ASSERT_EQ(volume.sweeps.size(), 3U);
  EXPECT_EQ(volume.sweeps[0].rays.size(), 8U);
  EXPECT_EQ(volume.sweeps[1].rays.size(), 9U);
}
