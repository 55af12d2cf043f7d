// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace nexrad::application
{

/// An option of a command as its text: "--preset" and "storm cores". A flag has no value.
struct OptionText
{
  std::string name;
  std::string value;
};

} // namespace nexrad::application
