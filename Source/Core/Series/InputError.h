// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Error.h"

#include <string>

namespace nexrad
{

/// The inputs cannot be used: one of them does not exist, or none holds a volume that can be used.
class InputError : public Error
{
public:
  InputError(const std::string& what, bool missing)
    : Error(what)
    , isMissing(missing)
  {
  }

  const bool isMissing; ///< an input does not exist
};

} // namespace nexrad
