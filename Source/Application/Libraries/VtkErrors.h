// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

namespace nexrad::application
{

/// From now on the program takes the errors and warnings of VTK's objects, which VTK would print in
/// several lines each. A warning is printed as one line at once. The libraries that the program
/// loads share this; without it, no error is known to the next two functions.
void TakeVtkErrors();

/// The first error since the last call, for who shows it to the user; empty without one.
std::string NextVtkError();

/// Throws Error with the first error since the last call, if there is one. To be called before what
/// was made is written.
void ThrowVtkErrors();

/// Takes VTK's errors, does a command's work and returns its exit status: 1 where any error came.
/// Prints one that nobody has asked for. What the work throws passes.
int FailOnVtkErrors(const std::function<int()>& work);

} // namespace nexrad::application
