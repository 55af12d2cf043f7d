// SPDX-License-Identifier: BSD-3-Clause
// Simulated files beside real ones of the same kind: they must be about as large.
#include "TestData.h"
#include "Tolerance.h"
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Simulation/SimulatedDay.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace nexrad;

namespace
{

double SizeOf(const std::string& site, int pattern, int messageType, Level2Container container)
{
  SimulatedDayOptions options;
  options.begin = *ParseIso8601("2006-03-12T18:00");
  options.length = std::chrono::minutes(12);
  options.sites = {{site, pattern}};
  options.messageType = messageType;
  options.container = container;
  const SimulatedVolume volume = PlanSimulatedDay(options).front();
  const auto bytes =
    static_cast<double>(SimulateFile(StormField(options.seed), volume, options).size());
  std::printf("%s: %.0f bytes\n", volume.fileName.c_str(), bytes);
  return bytes;
}

} // namespace

TEST(SimulatedFiles, AreAsLargeAsTheRunOfKbgm)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  double mean = 0.0;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data / "level2/run-kbgm-20050821"))
  {
    mean += static_cast<double>(entry.file_size());
    ++files;
  }
  ASSERT_EQ(files, 5);
  mean /= files;
  std::printf("KBGM, five files: %.0f bytes on average\n", mean);
  for (const char* site : {"KEAX", "KILX", "KLSX"})
  {
    EXPECT_WITHIN(SizeOf(site, 21, 1, Level2Container::LdmBzip2) / mean, 1.0, 0.16,
      "size of a file, part of the real ones' mean")
      << site;
  }
}

TEST(SimulatedFiles, SuperResolutionIsAsLargeAsKblx)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  const auto real = static_cast<double>(
    std::filesystem::file_size(data / "level2/superres/KBLX20090603_004417_V03.gz"));
  double mean = 0.0;
  for (const char* site : {"KEAX", "KILX", "KLSX"})
  {
    mean += SizeOf(site, 212, 31, Level2Container::Gzip) / 3.0;
  }
  EXPECT_WITHIN(mean / real, 1.0, 0.3, "mean size of the files, part of the real one's");
}
