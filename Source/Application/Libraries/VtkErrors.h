// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace nexrad::application
{

/// From now on the program takes the errors and warnings of VTK's objects, which VTK would print in
/// several lines each. A warning is printed as one line at once. An error makes the command fail.
/// The libraries that the program loads share this; without it, the functions below do nothing.
void TakeVtkErrors();

/// The first error since the last call, for who shows it to the user; empty without one.
std::string NextVtkError();

/// Throws Error with the first error since the last call, if there is one. To be called before what
/// was made is written.
void ThrowVtkErrors();

/// True where no error came at all. Prints one that nobody has asked for.
bool IsFreeOfVtkErrors();

} // namespace nexrad::application
