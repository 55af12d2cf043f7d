// SPDX-License-Identifier: BSD-3-Clause
// Radars that see the same places, and how much they differ (Formulas Q6).
#include "nexrad/Calibration/RadarComparison.h"

#include "Tolerance.h"
#include "nexrad/Model/SiteTable.h"
#include "nexrad/Simulation/RadarSimulator.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <chrono>
#include <iostream>
#include <memory>
#include <string>

using namespace nexrad;
using namespace nexrad::testing;
using namespace std::chrono_literals;

namespace
{

BiasPair Pair(const char* first, const char* second, double median, std::size_t cells = 1'000)
{
  BiasPair pair;
  pair.first = first;
  pair.second = second;
  pair.median = median;
  pair.cells = cells;
  return pair;
}

// An evening of the SYNTHETIC storm day, of two radars 190 km apart.
BiasReport CompareSimulated(double biasOfKLSX)
{
  const StormField field(1);
  LowEchoes echoes;
  for (const char* name : {"KILX", "KLSX"})
  {
    SimulatorOptions options;
    options.bias = name == std::string("KLSX") ? biasOfKLSX : 0.0;
    for (int i = 0; i < 6; ++i)
    {
      const Site site{name, FindSite(name)->position};
      const Time start = *ParseIso8601("2006-03-12T18:00:00Z") + i * 10min;
      const RadarVolume volume = ScanVolume(field, site, 21, start, options);
      echoes.push_back(std::make_shared<const LowEcho>(MakePolarVolume(volume, MomentName::REF)));
    }
  }
  return CompareRadars(echoes);
}

} // namespace

TEST(RadarBiases, OfOneWrongRadarAreItsOwn)
{
  const RadarBiases biases = ReconcileBiases(
    {Pair("KA", "KB", 2.0), Pair("KA", "KC", 2.0), Pair("KB", "KC", 0.0), Pair("KX", "KY", -1.0)});
  EXPECT_NEAR(biases.at("KA"), 2.0, 1e-9);
  EXPECT_NEAR(biases.at("KB"), 0.0, 1e-9);
  EXPECT_NEAR(biases.at("KC"), 0.0, 1e-9);
  EXPECT_NEAR(biases.at("KX"), -0.5, 1e-9); // a part of its own
  EXPECT_NEAR(biases.at("KY"), 0.5, 1e-9);
}

TEST(RadarBiases, WeighPairsByTheirCells)
{
  // The circle does not close by 3 dB; weights 1, 1 and 2 share it out as 1.2, 1.2 and 0.6.
  const RadarBiases biases =
    ReconcileBiases({Pair("KA", "KB", 1.0), Pair("KB", "KC", 1.0), Pair("KA", "KC", -1.0, 2'000)});
  EXPECT_NEAR(biases.at("KA") - biases.at("KB"), -0.2, 1e-6);
  EXPECT_NEAR(biases.at("KA") - biases.at("KC"), -0.4, 1e-6);
}

TEST(RadarBiases, OfTooFewCellsAreNotStated)
{
  EXPECT_TRUE(ReconcileBiases({Pair("KA", "KB", 2.0, BiasPair::FewestCells - 1)}).empty());
}

TEST(RadarBiases, AreReadFromText)
{
  const BiasRequest request = ParseBiasRequest("KLSX=+2,KILX=-1.5");
  EXPECT_FALSE(request.measured);
  EXPECT_EQ(request.given, (RadarBiases{{"KILX", -1.5}, {"KLSX", 2.0}}));
  EXPECT_TRUE(ParseBiasRequest("auto").measured);
  EXPECT_TRUE(ParseBiasRequest("off").given.empty());
  for (const char* wrong :
    {"", "KLSX", "KLSX=", "=2", "KLSX=x", "KLSX=21", "KLSX=2,", "KLSX=1,KLSX=2"})
  {
    EXPECT_THROW(ParseBiasRequest(wrong), Error) << wrong;
  }
}

TEST(RadarBiases, OfSimulatedRadarsAreFound)
{
  for (const double bias : {0.0, 2.0, -2.0})
  {
    const BiasReport report = CompareSimulated(bias);
    ASSERT_EQ(report.pairs.size(), 1U);
    EXPECT_AT_LEAST(report.pairs[0].cells, BiasPair::FewestCells, "cells of a pair of radars");
    EXPECT_WITHIN(report.pairs[0].median, -bias, 0.2, "bias between two radars, dB") << bias;
    std::cout << report.Lines().front() << '\n';
  }
}

TEST(LowEcho, ComesBackFromBytes)
{
  const StormField field(1);
  const Site site{"KLSX", FindSite("KLSX")->position};
  const LowEcho echo(MakePolarVolume(
    ScanVolume(field, site, 21, *ParseIso8601("2006-03-12T18:00:00Z")), MomentName::REF));
  ASSERT_FALSE(echo.IsEmpty());
  const std::string bytes = echo.Pack();
  const LowEcho back = LowEcho::Unpack(bytes);
  EXPECT_EQ(back.Pack(), bytes);
  EXPECT_EQ(back.MeanTime(), echo.MeanTime());
  EXPECT_THROW(LowEcho::Unpack("no bytes of it"), Error);
}
