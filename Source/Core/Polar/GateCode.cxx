// SPDX-License-Identifier: BSD-3-Clause
#include "nexrad/Polar/GateCode.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nexrad
{

namespace
{

// The smallest power of two that is not below a number above 0.
double PowerOfTwo(double number)
{
  int exponent = 0;
  const double part = std::frexp(number, &exponent);
  return std::ldexp(1.0, part > 0.5 ? exponent : exponent - 1);
}

} // namespace

ValueRule ValueRule::Of(MomentName moment, bool linearReflectivity)
{
  ValueRule rule;
  rule.nearest = IsRadialVelocity(moment);
  rule.zeroIsNone = moment == MomentName::REF;
  rule.linear = moment == MomentName::REF && linearReflectivity;
  rule.period = moment == MomentName::PHI ? 360.0F : 0.0F;
  return rule;
}

std::uint16_t GateScale::CodeOf(float value) const
{
  const float number = step > 0.0F ? (value - base) / step : 0.0F;
  constexpr auto first = static_cast<float>(FirstNumber);
  constexpr auto last = static_cast<float>(GateCode::Last - 1);
  return static_cast<std::uint16_t>(std::clamp(number, first, last) + 1.5F);
}

GateScale GateScale::Between(float least, float most)
{
  const auto from = static_cast<double>(least);
  const auto to = static_cast<double>(most);
  constexpr float steps = GateCode::Last - GateCode::FirstValue;
  // One step is left for the multiple of it below `least`.
  const double wanted = (to - from) / static_cast<double>(steps - 1.0F);
  const double told = std::max(std::abs(from), std::abs(to)) *
                      static_cast<double>(std::numeric_limits<float>::epsilon());
  const double smallest = static_cast<double>(std::numeric_limits<float>::min());
  const double step = PowerOfTwo(std::max({wanted, told, smallest}));
  const double first = std::floor(from / step) * step;
  return {static_cast<float>(first - step * FirstNumber), static_cast<float>(step)};
}

} // namespace nexrad
