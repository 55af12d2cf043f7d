// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace nexrad::application
{

/// Adds --threads, which sets how many threads decode files, and how many merge; it changes no
/// volume.
void AddThreadsOption(CLI::App& command);

/// The option as it was given, as words for another run of the program; empty when it was not.
std::vector<std::string> GivenThreads(const CLI::App& command);

} // namespace nexrad::application
