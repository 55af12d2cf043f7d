// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

namespace nexrad::testing
{

/// A measured figure and its bound, as the list of tolerances shows them.
struct BoundedFigure
{
  std::string_view what;   ///< what is measured, with its unit: "RMSE of beam, dBZ"
  std::string_view reason; ///< why the bound is further than twice the figure; "" for none
  bool atMost = true;      ///< the bound is an upper one, else a lower one

  bool Holds(double measured, double bound) const
  {
    return atMost ? measured <= bound : measured >= bound;
  }
  /// Notes the figure for the list. Only where the environment variable NEXRAD_TOLERANCES names a
  /// file: at the end of the test, one line for each thing measured is appended to it, with the
  /// figure that came nearest to its bound. The columns are separated by tabs: test, what,
  /// measured, bound, "most" or "least", reason.
  void Record(double measured, double bound) const;
};

/// A reason: the brightness of a pixel is one of 256 codes.
inline constexpr std::string_view OneCode = "within one code: drivers round to either neighbour";

/// Records a figure; says of one beyond its bound what was compared.
::testing::AssertionResult Judge(const BoundedFigure& figure, const char* expression,
  const char* limit, double measured, double bound);

/// For EXPECT_AT_MOST and EXPECT_AT_LEAST.
class Bound
{
public:
  Bound(bool atMost, std::string_view what, std::string_view reason = {})
    : figure{what, reason, atMost}
  {
  }

  template <typename Measured, typename Limit>
  ::testing::AssertionResult operator()(
    const char* expression, const char* limit, const Measured& measured, const Limit& bound) const
  {
    return Judge(
      figure, expression, limit, static_cast<double>(measured), static_cast<double>(bound));
  }

private:
  BoundedFigure figure;
};

/// For EXPECT_WITHIN.
class Distance
{
public:
  explicit Distance(std::string_view what, std::string_view reason = {})
    : figure{what, reason}
  {
  }

  template <typename Measured, typename Expected, typename Limit>
  ::testing::AssertionResult operator()(const char* expression, const char* wanted,
    const char* limit, const Measured& measured, const Expected& expected, const Limit& bound) const
  {
    const double off = std::abs(static_cast<double>(measured) - static_cast<double>(expected));
    auto result = Judge(figure, "distance", limit, off, static_cast<double>(bound));
    return result ? result
                  : result << "; (" << expression << ") is " << static_cast<double>(measured)
                           << ", (" << wanted << ") is " << static_cast<double>(expected);
  }

private:
  BoundedFigure figure;
};

} // namespace nexrad::testing

/// Asserts that a measured figure is at most, or at least, its bound. After the bound: what is
/// measured, with its unit; then, if the bound is further than twice the figure, the reason. More
/// text can be streamed in. EXPECT_WITHIN has the value, what it should be, and how far apart the
/// two may be. Not for comparisons that are exact up to rounding.
#define EXPECT_AT_MOST(measured, bound, ...)                                                       \
  EXPECT_PRED_FORMAT2(nexrad::testing::Bound(true, __VA_ARGS__), measured, bound)
#define EXPECT_AT_LEAST(measured, bound, ...)                                                      \
  EXPECT_PRED_FORMAT2(nexrad::testing::Bound(false, __VA_ARGS__), measured, bound)
#define EXPECT_WITHIN(measured, expected, tolerance, ...)                                          \
  EXPECT_PRED_FORMAT3(nexrad::testing::Distance(__VA_ARGS__), measured, expected, tolerance)

/// The same, and the test ends where it fails: for loops over many voxels.
#define ASSERT_AT_MOST(measured, bound, ...)                                                       \
  ASSERT_PRED_FORMAT2(nexrad::testing::Bound(true, __VA_ARGS__), measured, bound)
#define ASSERT_AT_LEAST(measured, bound, ...)                                                      \
  ASSERT_PRED_FORMAT2(nexrad::testing::Bound(false, __VA_ARGS__), measured, bound)
#define ASSERT_WITHIN(measured, expected, tolerance, ...)                                          \
  ASSERT_PRED_FORMAT3(nexrad::testing::Distance(__VA_ARGS__), measured, expected, tolerance)
