// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace nexrad::application
{

/// Writes a message to standard error: one line, whatever the names of files in it (MessageLine).
/// All that the program says there but its progress bar goes through this.
void PrintMessage(const std::string& message);
void PrintMessages(const std::vector<std::string>& messages);

} // namespace nexrad::application
