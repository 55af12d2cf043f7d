// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace nexrad::application
{

/// A function without a type, to be cast to the one that it has.
using AnyFunction = void (*)();

/// A library of this program, for the commands that need it.
struct ProgramLibrary
{
  std::string file;   ///< "nexrad3d-scene.so"
  std::string does;   ///< in the message when it is missing: what it does
  std::string target; ///< likewise: what builds it
};

/// Loads a library, and finds a function in it. The library stands in ../lib/nexrad3d beside the
/// program as it was built, or below the library folder that it was installed with, and is never
/// closed. Throws Error when it cannot be loaded.
AnyFunction LoadProgramFunction(const ProgramLibrary& library, const std::string& function);

} // namespace nexrad::application
