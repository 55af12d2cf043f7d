// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Level2/Level2File.h"
#include "nexrad/Model/SiteTable.h"

#include "ProgramRun.h"
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

// What `info --json` says of every real file that independent decoders have read, beside what they
// say. Their sweep is all rays of one elevation number; ours is one turn of the antenna, so files
// with several cycles or restarted cuts are compared in sums over the number.
using namespace nexrad;
using namespace nexrad::testing;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace
{

constexpr double fiveDecimals = 0.6e-5; // what rounding to five decimals leaves open

template <typename Function>
void EachSample(const Json& oracle, Function function)
{
  for (const Json& sweep : oracle["sweeps"])
  {
    for (const auto& [name, moment] : sweep["moments"].items())
    {
      for (const Json& sample : moment.value("samples_ray_gate_raw_value", Json::array()))
      {
        function(sample, name, sweep);
      }
    }
  }
}

// Sweep and ray of our numbering for a ray of the decoders' sweep.
std::pair<std::size_t, std::size_t> PlaceOf(
  const RadarVolume& volume, int elevationNumber, std::size_t ray)
{
  for (std::size_t index = 0; index < volume.sweeps.size(); ++index)
  {
    if (volume.sweeps[index].elevationNumber == elevationNumber)
    {
      const std::size_t rays = volume.sweeps[index].rays.size();
      if (ray < rays)
      {
        return {index, ray};
      }
      ray -= rays;
    }
  }
  return {99999, 0};
}

// The samples, as arguments of the program; each stands for one answer in "gates".
std::vector<std::string> GateArguments(const Json& oracle, const RadarVolume& volume)
{
  std::vector<std::string> arguments;
  EachSample(oracle,
    [&](const Json& sample, const std::string&, const Json& sweep)
    {
      const auto [index, ray] = PlaceOf(volume, sweep["elevation_number"], sample[0]);
      arguments.push_back("--gate");
      arguments.push_back(
        std::to_string(index) + ',' + std::to_string(ray) + ',' + sample[1].dump());
    });
  return arguments;
}

// Counts what it compares, so that a comparison of nothing shows.
class Comparison
{
public:
  Comparison(Json oracle, Json found)
    : expected(std::move(oracle))
    , info(std::move(found))
  {
  }

  void CompareFile()
  {
    this->CompareSite();
    this->Equal(info["message_type"], expected["message_type"], "message type");
    this->Equal(info["vcp"], expected["vcp"], "vcp");
    this->Equal(info["start"], expected["first_ray_time"].get<std::string>() + "Z", "start");
    for (const Json& sweep : expected["sweeps"])
    {
      SCOPED_TRACE("elevation number " + sweep["elevation_number"].dump());
      this->CompareSweep(sweep);
    }
    this->CompareGates();
  }

  int Compared() const { return compared; }

private:
  template <typename Found, typename Expected>
  void Equal(const Found& found, const Expected& wanted, const std::string& what)
  {
    EXPECT_EQ(found, wanted) << what;
    ++compared;
  }
  void Near(const Json& found, double wanted, double tolerance, const std::string& what)
  {
    EXPECT_NEAR(found.get<double>(), wanted, tolerance) << what;
    ++compared;
  }

  void CompareSite()
  {
    const std::string name = expected["file"];
    const std::string site = expected["site"];
    const bool blank = site.find_first_not_of(std::string(" \0", 2)) == std::string::npos;
    this->Equal(info["site"], blank ? name.substr(0, 4) : site, "site");
    if (expected["lat"].is_null())
    {
      this->Near(info["latitude"], FindSite(info["site"].get<std::string>())->position.latitude,
        1e-9, "latitude of the site table");
      return;
    }
    const double unit = std::abs(expected["lat"].get<double>()) > 90.0 ? 1000.0 : 1.0;
    this->Near(info["latitude"], expected["lat"].get<double>() / unit, 1e-9, "latitude");
    this->Near(info["longitude"], expected["lon"].get<double>() / unit, 1e-9, "longitude");
    const bool terminal = site[0] == 'T';
    this->Equal(
      info["altitude_m"], expected[terminal ? "site_amsl_m" : "alt_m"].get<double>(), "altitude");
  }

  std::vector<Json> SweepsOf(int elevationNumber)
  {
    std::vector<Json> sweeps;
    for (const Json& sweep : info["sweeps"])
    {
      if (sweep["elevation_number"] == elevationNumber)
      {
        sweeps.push_back(sweep);
      }
    }
    return sweeps;
  }

  void CompareSweep(const Json& oracle)
  {
    const std::vector<Json> sweeps = this->SweepsOf(oracle["elevation_number"]);
    std::size_t rays = 0;
    double elevation = 0.0;
    for (const Json& sweep : sweeps)
    {
      const std::size_t count = sweep["rays"];
      rays += count;
      elevation += sweep["elevation_mean_deg"].get<double>() * static_cast<double>(count);
    }
    this->Equal(rays, oracle["num_rays"], "rays");
    if (rays == 0)
    {
      return;
    }
    this->Near(
      elevation / static_cast<double>(rays), oracle["elevation_mean"], fiveDecimals, "elevation");
    const Json& first = sweeps.front();
    this->Near(first["first_azimuth_deg"], oracle["azimuth_first"], fiveDecimals, "azimuth");
    this->Equal(first["start"], oracle["time_first"].get<std::string>() + "Z", "start");
    // The oracle writes 0 where it found none.
    const Json& nyquist = first["nyquist_m_s"];
    this->Near(nyquist.is_null() ? Json(0.0) : nyquist, oracle["nyquist_mps"], fiveDecimals,
      "Nyquist velocity");
    for (const auto& [name, moment] : oracle["moments"].items())
    {
      SCOPED_TRACE(name);
      this->CompareMoment(sweeps, name, moment);
    }
  }

  void CompareMoment(const std::vector<Json>& sweeps, const std::string& name, const Json& oracle)
  {
    std::map<std::string, std::int64_t> sums;
    double total = 0.0;
    double lowest = INFINITY;
    double highest = -INFINITY;
    for (const Json& sweep : sweeps)
    {
      const Json moment = sweep["moments"].value(name, Json());
      if (moment.is_null())
      {
        continue;
      }
      sums["gates"] = std::max<std::int64_t>(sums["gates"], moment["gates"]);
      for (const char* key : {"valid", "below_threshold", "range_folded"})
      {
        sums[key] += moment[key].get<std::int64_t>();
      }
      sums["status"] += moment.value("status", 0);
      this->Equal(moment["first_gate_m"], oracle["first_gate_m"], "first gate");
      this->Equal(moment["gate_spacing_m"], oracle["gate_spacing_m"], "gate spacing");
      if (moment["valid"] > 0)
      {
        total += moment["mean"].get<double>() * moment["valid"].get<double>();
        lowest = std::min(lowest, moment["min"].get<double>());
        highest = std::max(highest, moment["max"].get<double>());
      }
    }
    this->Equal(sums["gates"], oracle["num_gates"], "gates");
    if (name == "CFP")
    {
      // The decoders do not know its codes; all gates together are all that can be compared.
      this->Equal(sums["valid"] + sums["status"],
        oracle["valid"].get<int>() + oracle["below_threshold"].get<int>() +
          oracle["range_folded"].get<int>(),
        "gates of CFP");
      return;
    }
    for (const char* key : {"valid", "below_threshold", "range_folded"})
    {
      this->Equal(sums[key], oracle.value(key, 0), key);
    }
    if (sums["valid"] > 0)
    {
      const double mean = total / static_cast<double>(sums["valid"]);
      this->Near(lowest, oracle["min"], 1e-9, "lowest value");
      this->Near(highest, oracle["max"], 1e-9, "highest value");
      this->Near(mean, oracle["mean"], 1e-9 * std::max(1.0, std::abs(mean)), "mean");
    }
  }

  void CompareGates()
  {
    std::size_t index = 0;
    EachSample(expected,
      [&](const Json& sample, const std::string& name, const Json&)
      {
        const Json& gate = info["gates"].at(index++)["moments"].at(name);
        this->Equal(gate["raw"], sample[2], "raw word");
        if (name == "CFP")
        {
          return; // its codes are values to the decoders
        }
        ASSERT_EQ(gate["value"].is_null(), sample[3].is_null()) << name << sample;
        if (!sample[3].is_null())
        {
          this->Near(gate["value"], sample[3], fiveDecimals, "value");
        }
      });
    EXPECT_EQ(index, info["gates"].size());
  }

  Json expected;
  Json info;
  int compared = 0;
};

// Damage does not matter here: some of these files are trimmed.
Json RunInfo(const fs::path& file, const std::vector<std::string>& gates)
{
  std::vector<std::string> words = {"info", "--json", file};
  words.insert(words.end(), gates.begin(), gates.end());
  const ProgramRun run = RunNexrad3d(words);
  EXPECT_TRUE(run.status == 0 || run.status == 3) << run.status << '\n' << run.errors;
  return Json::parse(run.output).at(0);
}

int CompareOracle(const fs::path& data, const fs::path& oracle)
{
  std::ifstream stream(oracle);
  const Json expected = Json::parse(stream);
  const fs::path file = FindTestFile(data, expected["file"]);
  SCOPED_TRACE(file.string());
  Comparison comparison(expected, RunInfo(file, GateArguments(expected, ReadLevel2(file))));
  comparison.CompareFile();
  return comparison.Compared();
}

} // namespace

TEST(InfoOracles, AgreeOnEveryFile)
{
  NEXRAD_REQUIRE_TEST_DATA(data);
  int files = 0;
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(data / "oracles"))
  {
    if (entry.path().extension() == ".json")
    {
      const int values = CompareOracle(data, entry.path());
      EXPECT_AT_LEAST(values, 120, "values of a file compared") << entry.path();
      compared += values;
      ++files;
    }
  }
  std::cout << compared << " values of " << files << " files compared\n";
  RecordProperty("values", compared);
  EXPECT_AT_LEAST(files, 40, "files compared");
  EXPECT_AT_LEAST(compared, 30'000, "values compared");
}
