// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "nexrad/System/Error.h"

#include <string>

namespace nexrad::testing
{

/// What the Error says that a call ends with; "" when it ends without one.
template <class Call>
std::string MessageOf(const Call& call)
{
  try
  {
    call();
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return "";
}

} // namespace nexrad::testing
