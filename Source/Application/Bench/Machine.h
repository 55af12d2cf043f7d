// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace nexrad::application
{

/// What the figures of a benchmark belong to.
struct Machine
{
  std::string processor; ///< as the system names it; "unknown" where it does not
  unsigned cores = 1;    ///< threads that the machine runs at a time
  std::string build;     ///< version, build type, compiler
};

Machine DescribeMachine();

} // namespace nexrad::application
