// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace nexrad::application
{

/// A number rounded to so many digits after the decimal point, for texts that are to be short.
inline double Rounded(double value, int digits)
{
  const double factor = std::pow(10.0, digits);
  return std::round(value * factor) / factor;
}

} // namespace nexrad::application
