// SPDX-License-Identifier: BSD-3-Clause
#include "ErrorMessage.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Simulation/SimulatedDay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

using namespace nexrad;
using nexrad::testing::MessageOf;

namespace
{

SimulatedDayOptions OneHour()
{
  SimulatedDayOptions options;
  options.begin = *ParseIso8601("2006-03-12T18:00");
  options.length = std::chrono::hours(1);
  return options;
}

std::string PlanError(const SimulatedDayOptions& options)
{
  return MessageOf([&] { PlanSimulatedDay(options); });
}

} // namespace

TEST(SimulatedDay, EverySiteKeepsItsOwnPace)
{
  std::map<std::string, std::vector<Time>> starts;
  for (const SimulatedVolume& volume : PlanSimulatedDay(OneHour()))
  {
    EXPECT_GE(volume.start, OneHour().begin);
    EXPECT_LT(volume.start, OneHour().begin + OneHour().length);
    starts[volume.site.name].push_back(volume.start);
  }
  ASSERT_EQ(starts.size(), 3U);
  const std::map<std::string, int> patterns = {{"KEAX", 21}, {"KILX", 12}, {"KLSX", 11}};
  for (const auto& [name, times] : starts)
  {
    ASSERT_GE(times.size(), 10U) << name;
    for (std::size_t index = 1; index < times.size(); ++index)
    {
      EXPECT_EQ(times[index] - times[index - 1], VolumePeriod(patterns.at(name))) << name;
    }
  }
}

TEST(SimulatedDay, VolumesDoNotDependOnWhereThePeriodBegins)
{
  SimulatedDayOptions later = OneHour();
  later.begin += std::chrono::minutes(25);
  later.length = std::chrono::minutes(35);
  const std::vector<SimulatedVolume> all = PlanSimulatedDay(OneHour());
  const std::vector<SimulatedVolume> end = PlanSimulatedDay(later);
  ASSERT_LT(end.size(), all.size());
  for (std::size_t index = 0; index < end.size(); ++index)
  {
    const SimulatedVolume& same = all[all.size() - end.size() + index];
    EXPECT_EQ(end[index].fileName, same.fileName);
    EXPECT_EQ(end[index].start, same.start);
    EXPECT_EQ(end[index].volumeNumber, same.volumeNumber);
  }
}

TEST(SimulatedDay, ADayHasSevenToNineHundredVolumes)
{
  SimulatedDayOptions options;
  options.begin = *ParseIso8601("2006-03-12");
  const std::size_t volumes = PlanSimulatedDay(options).size();
  EXPECT_AT_LEAST(volumes, 700U, "volumes of a day");
  EXPECT_AT_MOST(volumes, 900U, "volumes of a day");
}

TEST(SimulatedDay, FilesAreNamedAsTheArchiveNamesThem)
{
  SimulatedDayOptions options = OneHour();
  options.sites = {{"KLSX", 21}};
  const std::string plain = PlanSimulatedDay(options).front().fileName;
  EXPECT_EQ(plain.substr(0, 15), "KLSX20060312_18");
  EXPECT_EQ(plain.size(), 19U);
  options.container = Level2Container::Gzip;
  EXPECT_EQ(PlanSimulatedDay(options).front().fileName, plain + ".gz");
  options.messageType = 31;
  EXPECT_EQ(PlanSimulatedDay(options).front().fileName, plain + "_V06.gz");
}

TEST(SimulatedDay, AFileDecodesToWhatWasScanned)
{
  SimulatedDayOptions options = OneHour();
  options.sites = {{"KILX", 32}};
  const SimulatedVolume planned = PlanSimulatedDay(options).front();
  const StormField field(options.seed);
  const RadarVolume decoded = DecodeLevel2(SimulateFile(field, planned, options), planned.fileName);
  EXPECT_TRUE(decoded.synthetic);
  EXPECT_TRUE(decoded.complete);
  EXPECT_TRUE(decoded.damage.empty());
  EXPECT_EQ(decoded.site.name, "KILX");
  EXPECT_EQ(decoded.headerTime, planned.start);
  EXPECT_EQ(decoded.coveragePatternNumber, 32);
  const RadarVolume scanned = ScanVolume(field, planned.site, 32, planned.start);
  ASSERT_EQ(decoded.sweeps.size(), scanned.sweeps.size());
  for (std::size_t cut = 0; cut < scanned.sweeps.size(); ++cut)
  {
    ASSERT_EQ(decoded.sweeps[cut].rays.size(), scanned.sweeps[cut].rays.size());
    for (std::size_t index = 0; index < scanned.sweeps[cut].rays.size(); ++index)
    {
      const Ray& truth = scanned.sweeps[cut].rays[index];
      const Ray& ray = decoded.sweeps[cut].rays[index];
      EXPECT_EQ(ray.time, truth.time);
      for (const MomentName name : {MomentName::REF, MomentName::VEL, MomentName::SW})
      {
        const MomentRow& row = truth.Row(name);
        ASSERT_EQ(ray.Row(name).gates, row.gates);
        EXPECT_TRUE(std::equal(row.words, row.words + row.gates, ray.Row(name).words));
      }
    }
  }
}

TEST(SimulatedDay, SaysWhatCannotBeSimulated)
{
  SimulatedDayOptions options = OneHour();
  options.sites = {{"KZZZ", 21}};
  EXPECT_NE(PlanError(options).find("KZZZ"), std::string::npos);
  options.sites = {{"KLSX", 13}};
  EXPECT_NE(PlanError(options).find("13"), std::string::npos);
  options.sites = {{"KLSX", 21}, {"KLSX", 11}};
  EXPECT_NE(PlanError(options).find("twice"), std::string::npos);
  options.sites = {};
  EXPECT_NE(PlanError(options).find("no sites"), std::string::npos);
  options = OneHour();
  options.length = Duration(0);
  EXPECT_NE(PlanError(options).find("above 0"), std::string::npos);
}
