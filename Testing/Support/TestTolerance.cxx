// SPDX-License-Identifier: BSD-3-Clause
#include "TestData.h"
#include "Tolerance.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <optional>
#include <string>

namespace
{

const double asWanted = 2.0;
const double tooLarge = 3.5;

// The figures of these tests are made up: the list is without them.
class Tolerance : public ::testing::Test
{
protected:
  void SetUp() override { unsetenv("NEXRAD_TOLERANCES"); }
  void TearDown() override
  {
    if (listed)
    {
      setenv("NEXRAD_TOLERANCES", listed->c_str(), 1);
    }
  }

private:
  static std::optional<std::string> Listed()
  {
    const char* path = std::getenv("NEXRAD_TOLERANCES");
    return path != nullptr ? std::optional<std::string>(path) : std::nullopt;
  }

  std::optional<std::string> listed = Listed();
};

} // namespace

TEST_F(Tolerance, HoldsUpToTheBound)
{
  EXPECT_AT_MOST(asWanted, 2.0, "a figure, m");
  EXPECT_AT_LEAST(asWanted, 2.0, "a figure, m");
  EXPECT_WITHIN(asWanted, 2.5, 0.5, "a figure, m");
  EXPECT_WITHIN(asWanted, 1.5, 0.5, "a figure, m");
}

TEST_F(Tolerance, AFailureNamesWhatWasMeasured)
{
  EXPECT_NONFATAL_FAILURE(EXPECT_AT_MOST(tooLarge, 2 * 1.5, "a figure, m") << "at a place",
    "a figure, m\nExpected: (tooLarge) <= (2 * 1.5), actual: 3.5 vs 3\nat a place");
  EXPECT_NONFATAL_FAILURE(EXPECT_AT_LEAST(asWanted, 3, "a figure, m"),
    "a figure, m\nExpected: (asWanted) >= (3), actual: 2 vs 3");
  EXPECT_NONFATAL_FAILURE(EXPECT_WITHIN(asWanted, 1.5, 0.25, "a figure, m"),
    "Expected: (distance) <= (0.25), actual: 0.5 vs 0.25; (asWanted) is 2, (1.5) is 1.5");
  EXPECT_FATAL_FAILURE(ASSERT_AT_MOST(tooLarge, 3.0, "a figure, m"), "a figure, m");
}

TEST_F(Tolerance, NotANumberFails)
{
  static const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NONFATAL_FAILURE(EXPECT_AT_MOST(none, 1.0, "a figure, m"), "nan");
  EXPECT_NONFATAL_FAILURE(EXPECT_AT_LEAST(none, 1.0, "a figure, m"), "nan");
  EXPECT_NONFATAL_FAILURE(EXPECT_WITHIN(none, 1.0, 1.0, "a figure, m"), "nan");
}

// Run by the test below, in a process of its own.
TEST(ToleranceList, DISABLED_Sample)
{
  for (const double error : {0.5, 0.75, 0.25})
  {
    EXPECT_AT_MOST(error, 1.0, "error, m");
    EXPECT_AT_LEAST(100.0 * error, 20, "voxels", "the picture depends on the driver");
  }
  EXPECT_WITHIN(41, 42, 2, "answer");
}

TEST(ToleranceList, HasTheWorstFigureOfEachTest)
{
  const nexrad::testing::TemporaryFolder folder;
  const std::string file = (folder.Path() / "list.txt").string();
  const std::string command = "NEXRAD_TOLERANCES='" + file +
                              "' /proc/$PPID/exe --gtest_filter=ToleranceList.DISABLED_Sample"
                              " --gtest_also_run_disabled_tests >/dev/null";
  const std::string sample = "ToleranceList.DISABLED_Sample\t";
  const std::string lines = sample + "answer\t1\t2\tmost\t\n" +      //
                            sample + "error, m\t0.75\t1\tmost\t\n" + //
                            sample + "voxels\t25\t20\tleast\tthe picture depends on the driver\n";
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(nexrad::testing::FileContent(file), lines);
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(nexrad::testing::FileContent(file), lines + lines) << "lines are appended";
}
