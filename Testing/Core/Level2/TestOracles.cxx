// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Level2File.h"

#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

// What independent decoders read from real files, as far as `info` does not print it (TestInfo
// compares the rest): the rays' first and last directions and times, the words' sizes and scales,
// the sum of all words, the coverage pattern.
using namespace nexrad;
using nexrad::testing::FindTestFile;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

constexpr double fiveDecimals = 0.6e-5;

// All rays of one elevation number: what the decoders call a sweep.
std::vector<const Ray*> RaysOf(const RadarVolume& volume, int elevationNumber)
{
  std::vector<const Ray*> rays;
  for (const Sweep& sweep : volume.sweeps)
  {
    for (const Ray& ray : sweep.rays)
    {
      if (ray.elevationNumber == elevationNumber)
      {
        rays.push_back(&ray);
      }
    }
  }
  return rays;
}

std::string ShortTime(Time time)
{
  const std::string text = FormatIso8601(time);
  return text.substr(0, text.size() - 1);
}

struct WordTotals
{
  std::size_t rays = 0;
  unsigned fewestGates = 65535;
  std::uint64_t sum = 0;
};

WordTotals AddWords(const std::vector<const Ray*>& rays, MomentName name)
{
  WordTotals totals;
  for (const Ray* ray : rays)
  {
    const MomentRow& row = ray->Row(name);
    totals.rays += row.gates > 0 ? 1 : 0;
    totals.fewestGates = std::min<unsigned>(totals.fewestGates, row.gates);
    for (std::size_t gate = 0; gate < row.gates; ++gate)
    {
      totals.sum += row.Raw(gate);
    }
  }
  return totals;
}

int CompareMoment(const std::vector<const Ray*>& rays, MomentName name, const Json& expected)
{
  if (expected["num_gates"] == 0)
  {
    EXPECT_EQ(AddWords(rays, name).rays, 0U);
    return 1;
  }
  const WordTotals totals = AddWords(rays, name);
  EXPECT_EQ(totals.rays, expected["rays_with_moment"]);
  EXPECT_EQ(totals.fewestGates, expected["num_gates_min"]);
  EXPECT_EQ(totals.sum, expected["raw_sum"]);
  const auto first = std::find_if(
    rays.begin(), rays.end(), [name](const Ray* ray) { return ray->Row(name).gates > 0; });
  const MomentRow& row = (*first)->Row(name);
  EXPECT_EQ(row.wordBits, expected["word_bits"]);
  EXPECT_EQ(row.scale, expected["scale"].get<float>());
  // The decoders read the width with velocity's offset and scale, as the format has it.
  EXPECT_EQ(row.offset, expected["offset"].get<float>());
  return 6;
}

int CompareSweep(const RadarVolume& volume, const Json& expected)
{
  const std::vector<const Ray*> rays = RaysOf(volume, expected["elevation_number"]);
  EXPECT_EQ(rays.size(), expected["num_rays"]);
  if (rays.empty())
  {
    return 0;
  }
  const auto extremes = std::minmax_element(rays.begin(), rays.end(),
    [](const Ray* first, const Ray* second) { return first->elevation < second->elevation; });
  EXPECT_NEAR((*extremes.first)->elevation, expected["elevation_min"], fiveDecimals);
  EXPECT_NEAR((*extremes.second)->elevation, expected["elevation_max"], fiveDecimals);
  EXPECT_NEAR(rays.front()->azimuth, expected["azimuth_first"], fiveDecimals);
  EXPECT_NEAR(rays.back()->azimuth, expected["azimuth_last"], fiveDecimals);
  EXPECT_EQ(ShortTime(rays.front()->time), expected["time_first"]);
  EXPECT_EQ(ShortTime(rays.back()->time), expected["time_last"]);
  int compared = 7;
  for (const auto& [name, moment] : expected["moments"].items())
  {
    SCOPED_TRACE(name);
    compared += CompareMoment(rays, *ParseMomentName(name), moment);
  }
  return compared;
}

int ComparePattern(const RadarVolume& volume, const Json& expected)
{
  const Json& cuts = expected["vcp_cuts"];
  if (cuts.empty())
  {
    EXPECT_FALSE(volume.coveragePattern);
    return 1;
  }
  if (!volume.coveragePattern || volume.coveragePattern->cuts.size() != cuts.size())
  {
    ADD_FAILURE() << "the coverage pattern has not the right number of cuts";
    return 0;
  }
  EXPECT_EQ(volume.coveragePattern->number, expected["vcp_msg5"]);
  for (std::size_t cut = 0; cut < cuts.size(); ++cut)
  {
    EXPECT_NEAR(volume.coveragePattern->cuts[cut].elevation, cuts[cut], 0.6e-4);
  }
  return static_cast<int>(cuts.size()) + 1;
}

int CompareFile(const fs::path& data, const Json& expected)
{
  const std::string name = expected["file"];
  SCOPED_TRACE(name);
  const RadarVolume volume = ReadLevel2(FindTestFile(data, name));
  EXPECT_TRUE(volume.headerTime);
  EXPECT_EQ(ShortTime(volume.headerTime.value_or(Time{})), expected["volume_header_time"]);
  int compared = 1 + (expected.contains("vcp_cuts") ? ComparePattern(volume, expected) : 0);
  for (const Json& sweep : expected["sweeps"])
  {
    SCOPED_TRACE("elevation number " + sweep["elevation_number"].dump());
    compared += CompareSweep(volume, sweep);
  }
  return compared;
}

} // namespace

TEST(Oracles, AgreeOnEveryFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  int files = 0;
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(data / "oracles"))
  {
    if (entry.path().extension() == ".json")
    {
      std::ifstream file(entry.path());
      compared += CompareFile(data, Json::parse(file));
      ++files;
    }
  }
  std::cout << compared << " values of " << files << " files compared\n";
  RecordProperty("values", compared);
  EXPECT_AT_LEAST(files, 40, "files compared");
  EXPECT_AT_LEAST(compared, 10'000, "values compared");
}
