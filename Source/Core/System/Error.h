// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>

namespace nexrad
{

/// A request that cannot be met: a missing file, an unknown site, a grid without voxels.
/// what() is one line for the user: the file, offset or option, what is wrong, what would be right.
class Error : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

} // namespace nexrad
