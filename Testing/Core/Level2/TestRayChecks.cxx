// SPDX-License-Identifier: BSD-3-Clause
// One wrong bit in one ray, found by what the other rays say.
#include "nexrad/Level2/Level2File.h"

#include "Level2Bytes.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>

#include <cstring>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

float FlipBit(float value, unsigned bit)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  bits ^= 1U << bit;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

constexpr std::uint32_t day = 13017; // 2005-08-21
constexpr std::uint32_t rayTime = 100;

// Rays of one cut, one degree apart, a tenth of a second apart.
std::vector<RayPlan> PlanRays(unsigned count)
{
  std::vector<RayPlan> plans(count);
  for (unsigned index = 0; index < count; ++index)
  {
    plans[index].number = index + 1;
    plans[index].azimuth = index;
    plans[index].milliseconds = 9'799'000 + index * rayTime;
    plans[index].status = index == 0 ? 3 : index + 1 == count ? 4 : 1;
  }
  return plans;
}

RadarVolume DecodeCut(const std::vector<RayPlan>& plans)
{
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  for (const RayPlan& plan : plans)
  {
    parts.push_back(MakeMessage31(plan));
  }
  return DecodeLevel2(Join(parts), "file");
}

// Where the message of a ray begins.
std::size_t OffsetOf(const std::vector<RayPlan>& plans, std::size_t ray)
{
  std::size_t offset = 24;
  for (std::size_t index = 0; index < ray; ++index)
  {
    offset += MakeMessage31(plans[index]).size();
  }
  return offset;
}

} // namespace

TEST(RayChecks, AFlippedBitOfAScaleOrOffsetTakesOneRaysMoment)
{
  for (unsigned bit = 0; bit < 64; ++bit)
  {
    std::vector<RayPlan> plans = PlanRays(40);
    MomentPlan& moment = plans[17].moments[0];
    moment.scale = bit < 32 ? FlipBit(moment.scale, bit) : moment.scale;
    moment.offset = bit < 32 ? moment.offset : FlipBit(moment.offset, bit - 32);
    const RadarVolume volume = DecodeCut(plans);
    ASSERT_EQ(volume.RayCount() + (volume.RayCount() == 39 ? 1 : 0), 40U);
    ASSERT_EQ(volume.damage.empty() ? "" : volume.damage[0].what.substr(0, 3), "REF") << bit;
    EXPECT_EQ(volume.damage[0].offset, OffsetOf(plans, 17)) << bit;
    for (const Ray& ray : volume.sweeps[0].rays)
    {
      const MomentRow& row = ray.Row(MomentName::REF);
      if (row.gates > 0)
      {
        ASSERT_EQ(row.scale, 2.0F) << bit;
        ASSERT_EQ(row.offset, 66.0F) << bit;
      }
      EXPECT_EQ(row.gates == 0, ray.azimuth == 17.0F) << bit;
    }
  }
}

TEST(RayChecks, ACodingOfImpossibleValuesIsDamageInAllRays)
{
  std::vector<RayPlan> plans = PlanRays(10);
  for (RayPlan& plan : plans)
  {
    plan.moments[0].scale = -2.0F;
  }
  const RadarVolume volume = DecodeCut(plans);
  EXPECT_FALSE(volume.sweeps[0].Has(MomentName::REF));
  ASSERT_EQ(volume.damage.size(), 1U);
  EXPECT_NE(volume.damage[0].what.find("scale -2, offset 66 and 8 bits"), std::string::npos)
    << volume.damage[0].what;
  EXPECT_NE(volume.damage[0].what.find("and 9 more"), std::string::npos);
}

// The resolution of velocities stands in each ray of message 1.
TEST(RayChecks, AFlippedVelocityResolutionTakesOneRaysVelocity)
{
  std::vector<Bytes> parts = {MakeVolumeHeader()};
  std::vector<RayPlan> plans = PlanRays(20);
  plans[5].velocityResolution = 4;
  for (const RayPlan& plan : plans)
  {
    parts.push_back(MakeMessage1(plan));
  }
  const RadarVolume volume = DecodeLevel2(Join(parts), "file");
  ASSERT_EQ(volume.RayCount(), 20U);
  EXPECT_EQ(volume.sweeps[0].rays[5].Row(MomentName::VEL).gates, 0U);
  EXPECT_EQ(volume.sweeps[0].rays[5].Row(MomentName::REF).gates, 5U);
  EXPECT_EQ(volume.sweeps[0].rays[4].Row(MomentName::VEL).gates, 6U);
  ASSERT_EQ(volume.damage.size(), 1U);
}

TEST(RayChecks, AWrongDateOfOneRayDoesNotStretchTheVolume)
{
  for (const std::size_t wrong : {std::size_t(0), std::size_t(3), std::size_t(39)})
  {
    for (const std::uint32_t date : {day + 1, day + 4096, day - 8192})
    {
      std::vector<RayPlan> plans = PlanRays(40);
      plans[wrong].day = date;
      const RadarVolume volume = DecodeCut(plans);
      const Time first = FromLevel2Date(day, 9'799'000);
      EXPECT_EQ(volume.RayCount(), 40U);
      EXPECT_GE(*volume.Start(), first);
      EXPECT_LE(*volume.End(), first + 40 * Duration(rayTime));
      ASSERT_EQ(volume.damage.size(), 1U);
      EXPECT_EQ(volume.damage[0].offset, OffsetOf(plans, wrong));
      EXPECT_NE(volume.damage[0].what.find("hours from the other rays"), std::string::npos);
    }
  }
}

TEST(RayChecks, VolumesHoursApartInOneFileKeepTheirTimes)
{
  std::vector<RayPlan> plans = PlanRays(80);
  for (std::size_t index = 40; index < 80; ++index)
  {
    plans[index].milliseconds += 5 * 3'600'000;
    plans[index].number -= 40;
  }
  plans[39].status = 4;
  plans[40].status = 3;
  const RadarVolume volume = DecodeCut(plans);
  EXPECT_TRUE(volume.damage.empty()) << volume.damage[0].what;
  EXPECT_GT(*volume.End() - *volume.Start(), 5h);
}

// A few rays of as many dates, which are those of one sweep by their numbers and times of day: the
// header's time decides.
TEST(RayChecks, WithoutAMajorityTheHeadersTimeDecides)
{
  std::vector<RayPlan> plans = PlanRays(5);
  for (unsigned index = 0; index < 5; ++index)
  {
    plans[index].day = day + 200 * (index + 7) % 1000; // the fourth is that of the header
  }
  ASSERT_EQ(plans[3].day, day);
  const RadarVolume volume = DecodeCut(plans);
  ASSERT_EQ(volume.RayCount(), 5U);
  EXPECT_EQ(*volume.Start(), FromLevel2Date(day, 9'799'000));
  EXPECT_EQ(*volume.End(), FromLevel2Date(day, 9'799'000 + 4 * rayTime));
}

// No real file has a coding or a date that the checks take for wrong.
TEST(RayChecks, RealFilesHaveNoStrays)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  std::size_t files = 0;
  for (const char* folder : {"superres", "legacy", "tdwr", "damaged"})
  {
    for (const auto& entry : std::filesystem::directory_iterator(data / "level2" / folder))
    {
      ++files;
      for (const Damage& damage : ReadLevel2(entry.path()).damage)
      {
        EXPECT_EQ(damage.what.find(": left out"), std::string::npos) << damage.what;
        EXPECT_EQ(damage.what.find("hours from"), std::string::npos) << damage.what;
      }
    }
  }
  EXPECT_AT_LEAST(files, 25U, "files read");
}
