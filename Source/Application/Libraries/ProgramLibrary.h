// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace nexrad::application
{

/// A function without a type, to be cast to the one that it has.
using AnyFunction = void (*)();

/// Loads a library of this program, for the commands that need it, and finds a function in it. The
/// library stands in ../lib/nexrad3d beside the program as it was built, or below the library
/// folder that it was installed with, and is never closed. `does` and `target` go into the message
/// when it is missing: what it does, and what builds it. Throws Error when it cannot be loaded.
AnyFunction LoadProgramFunction(const std::string& library, const std::string& function,
  const std::string& does, const std::string& target);

} // namespace nexrad::application
