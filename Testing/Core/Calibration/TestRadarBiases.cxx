// SPDX-License-Identifier: BSD-3-Clause
// Biases of radars as text, and how they follow from differences (Formulas Q6).
#include "nexrad/Calibration/RadarBiases.h"

#include "ErrorMessage.h"
#include "nexrad/System/Error.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace nexrad;
using nexrad::testing::MessageOf;

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
  const BiasRequest request = ParseBiasRequest("KLSX:+2,KILX=-1.5");
  EXPECT_FALSE(request.measured);
  EXPECT_EQ(request.given, (RadarBiases{{"KILX", -1.5}, {"KLSX", 2.0}}));
  EXPECT_TRUE(ParseBiasRequest("auto").measured);
  EXPECT_TRUE(ParseBiasRequest("off").given.empty());
  for (const char* wrong :
    {"", "KLSX", "KLSX:", ":2", "KLSX:x", "KLSX:21", "KLSX:2,", "KLSX:1,KLSX:2"})
  {
    EXPECT_THROW(ParseBiasRequest(wrong), Error) << wrong;
  }
}

TEST(RadarBiases, AreOfRadarsAmongTheInputs)
{
  EXPECT_NO_THROW(RequireRadars({{"KLSX", 2.0}}, {"KILX", "KLSX"}));
  EXPECT_NO_THROW(RequireRadars({}, {}));
  const std::string error = MessageOf([&] { RequireRadars({{"KABR", 1.0}}, {"KILX", "KLSX"}); });
  EXPECT_EQ(
    error, "a bias is given for KABR, which none of the inputs is of; they are of KILX, KLSX");
}

TEST(RadarBiases, AreStatedInLines)
{
  BiasReport report;
  report.pairs = {Pair("KA", "KB", 2.0), Pair("KB", "KC", 1.0, 3)};
  report.pairs[0].volumes = 1;
  report.biases = ReconcileBiases(report.pairs);
  report.alone = {"KC"};
  EXPECT_EQ(report.Lines(),
    (std::vector<std::string>{
      "KA - KB: median +2.00 dB, quartiles +0.00 and +0.00 dB, 1000 places in 1 pair of volumes",
      "KB - KC: 3 places are too few to tell a difference", "KA: bias +1.00 dB",
      "KB: bias -1.00 dB", "KC: no other radar tells its bias"}));
}
