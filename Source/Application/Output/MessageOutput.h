// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace nexrad::application
{

/// "1 ray", "0 rays", "360 rays": for nouns whose plural takes an s.
inline std::string Counted(std::uintmax_t count, const std::string& noun)
{
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Writes a message to standard error: one line, whatever the names of files in it (MessageLine).
/// All that the program says there but its progress bar goes through this.
void PrintMessage(const std::string& message);
void PrintMessages(const std::vector<std::string>& messages);

/// Writes what is made for programs to standard output.
void PrintJson(const nlohmann::ordered_json& json);

/// What came of a command; all in lines.
struct Outcome
{
  std::vector<std::string> made;     ///< for standard output
  std::vector<std::string> notes;    ///< what else is to be said
  std::vector<std::string> problems; ///< inputs that were damaged or left out
};

/// Prints what was made, unless `quiet`, and the notes and the problems.
void PrintOutcome(const Outcome& outcome, bool quiet);

} // namespace nexrad::application
